#include "core/photo/camera_files.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <system_error>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/photo/camera_files_parts.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using namespace camera_files;

constexpr std::uint64_t kMaxSniffedBytes = std::uint64_t(256) << 20;

using Writer = void (*)(std::span<const Camera>, const fs::path&, Images);
struct Format {
  std::string_view name;
  Writer write;
  std::string_view file_ending;  // of a path that is a file, not a folder
};
constexpr std::array<Format, 4> kFormats{{
    {"colmap", write_colmap_text, ""},
    {"colmap-binary", write_colmap_binary, ""},
    {"transforms", write_transforms_json, ".json"},
    {"cameramodel", write_cameramodel, ".cameramodel"},
}};

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}
bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

std::vector<fs::path> cameramodels_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (entry->path().extension() == ".cameramodel") files.push_back(entry->path());
  if (error) throw Error(folder.string() + ": can't be listed (" + error.message() + "); check it");
  std::sort(files.begin(), files.end());
  return files;
}

bool holds_colmap(const fs::path& folder, const char* ending) {
  return is_file(folder / (std::string("cameras") + ending)) &&
         is_file(folder / (std::string("images") + ending));
}

// The cameras that lie in this folder itself.
std::optional<CameraFile> read_here(const fs::path& folder, const ImageSizeLookup& size_of_image) {
  if (holds_colmap(folder, ".bin")) return read_colmap_binary(folder);
  if (holds_colmap(folder, ".txt")) return read_colmap_text(folder);
  if (is_file(folder / "transforms.json"))
    return read_transforms_json(folder / "transforms.json", size_of_image);
  const std::vector<fs::path> models = cameramodels_in(folder);
  if (!models.empty()) return read_cameramodel(models);
  return std::nullopt;
}

CameraFile read_folder(const fs::path& folder, const ImageSizeLookup& size_of_image) {
  for (const char* below : {"", "sparse/0", "sparse", "colmap/sparse/0"})
    if (is_folder(folder / below))
      if (auto found = read_here(folder / below, size_of_image)) return *std::move(found);
  refuse(folder.string(),
         "no cameras found; looked for cameras.txt with images.txt, cameras.bin with images.bin, "
         "transforms.json and *.cameramodel, also in sparse/0: give the file itself");
}

CameraFile read_by_content(const fs::path& file, const ImageSizeLookup& size_of_image) {
  const std::string text = read_text(file, kMaxSniffedBytes);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const char mark = first == std::string::npos ? '\0' : text[first];
  const bool mrcal = text.find("lensmodel") != std::string::npos;
  if ((mark == '{' || mark == '#') && mrcal) return read_cameramodel(std::span(&file, 1));
  if (mark == '{') return read_transforms_json(file, size_of_image);
  refuse(
      file.string(),
      "not recognised as cameras; known are COLMAP models (give the folder), transforms.json and "
      ".cameramodel");
}

void check_writable(std::span<const Camera> cameras, Images images) {
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const std::string place = "camera " + in_quotes(cameras[i].name);
    check(cameras[i], place);
    if (camera_name(images[i].generic_string(), place) != cameras[i].name)
      refuse(place, "its photo is called " + in_quotes(images[i].string()) +
                        ", which doesn't lead back to the camera's name; rename it");
  }
  check_set(cameras, "the cameras to write");
}

}  // namespace

CameraFile read_camera_file(const fs::path& file_or_folder, const ImageSizeLookup& size_of_image) {
  if (is_folder(file_or_folder)) return read_folder(file_or_folder, size_of_image);
  const std::string name = file_or_folder.filename().string();
  const fs::path ending = file_or_folder.extension();
  if (name == "cameras.txt" || name == "images.txt")
    return read_colmap_text(file_or_folder.parent_path());
  if (name == "cameras.bin" || name == "images.bin")
    return read_colmap_binary(file_or_folder.parent_path());
  if (ending == ".json") return read_transforms_json(file_or_folder, size_of_image);
  if (ending == ".cameramodel") return read_cameramodel(std::span(&file_or_folder, 1));
  return read_by_content(file_or_folder, size_of_image);
}

std::vector<Camera> read_cameras(const fs::path& file_or_folder,
                                 const ImageSizeLookup& size_of_image) {
  return read_camera_file(file_or_folder, size_of_image).cameras;
}

std::vector<std::string> camera_format_names() {
  std::vector<std::string> names;
  names.reserve(std::size(kFormats));
  for (const Format& format : kFormats) names.emplace_back(format.name);
  return names;
}

void write_cameras(std::span<const Camera> cameras, std::string_view format, const fs::path& path,
                   std::span<const fs::path> images) {
  const auto chosen = std::find_if(kFormats.begin(), kFormats.end(),
                                   [&](const Format& known) { return known.name == format; });
  if (chosen == kFormats.end()) {
    std::string known;
    for (const std::string& name : camera_format_names()) known += " " + name;
    throw Error("the camera format " + in_quotes(format) + " is not known; choose one of" + known);
  }
  std::vector<fs::path> listed(images.begin(), images.end());
  if (images.empty())
    for (const Camera& camera : cameras) listed.emplace_back(camera.name + ".png");
  assert(listed.size() == cameras.size());
  check_writable(cameras, listed);
  const bool to_file = !chosen->file_ending.empty() && path.extension() == chosen->file_ending;
  const fs::path folder = to_file ? path.parent_path() : path;
  if (!folder.empty()) make_folder(folder);
  chosen->write(cameras, path, listed);
}

}  // namespace bosk
