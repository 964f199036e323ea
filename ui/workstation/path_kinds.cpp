#include "ui/workstation/path_kinds.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>
#include <set>

#include "core/base/system_error.h"
#include "core/photo/photo_format.h"
#include "core/project/project.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

using Paths = std::vector<fs::path>;

bool is_file(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

bool is_folder(const fs::path& path) {
  std::error_code none;
  return fs::is_directory(path, none);
}

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

Paths files_in(const fs::path& folder) {
  std::error_code failure;
  Paths files;
  for (auto entry = fs::directory_iterator(folder, failure);
       !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
    if (!is_hidden(entry->path()) && is_file(entry->path())) files.push_back(entry->path());
  }
  return files;
}

bool is_of_colmap(const fs::path& file) {
  static const std::set<std::string> names = {"cameras", "images", "points3D", "frames", "rigs"};
  const std::string ending = file.extension().string();
  return names.contains(file.stem().string()) && (ending == ".txt" || ending == ".bin");
}

bool is_colmap_model(const fs::path& folder) {
  return is_file(folder / "cameras.txt") || is_file(folder / "cameras.bin");
}

// Folders where a camera file may lie when this one is named; those that read_cameras looks into.
bool holds_cameras(const fs::path& folder) {
  if (is_file(folder / "transforms.json")) return true;
  for (const char* place : {"", "sparse/0", "sparse", "colmap/sparse/0"}) {
    if (is_colmap_model(folder / place)) return true;
  }
  const Paths files = files_in(folder);
  return std::any_of(files.begin(), files.end(),
                     [](const fs::path& file) { return file.extension() == ".cameramodel"; });
}

Paths photos_in(const fs::path& folder) {
  Paths photos = files_in(folder);
  std::erase_if(photos, [](const fs::path& file) { return !has_photo_ending(file); });
  return photos;
}

Paths photos_at(const fs::path& folder) {
  for (const char* place : {"", "images", "photos"}) {
    const Paths photos = photos_in(folder / place);
    if (!photos.empty()) return photos;
  }
  return {};
}

void take(fs::path& place, const fs::path& path, NamedPaths& all) {
  if (place.empty()) {
    place = path;
  } else if (place != path) {
    all.left_out.push_back(printable(path.filename().string()) + ": one at a time, and " +
                           printable(place.filename().string()) + " came first");
  }
}

void leave_out(const fs::path& path, const std::string& why, NamedPaths& all) {
  all.left_out.push_back(printable(path.filename().string()) + ": " + why);
}

void sort_out_folder(const fs::path& folder, NamedPaths& all) {
  if (holds_project(folder)) return take(all.project, folder, all);
  const bool cameras = holds_cameras(folder);
  const Paths photos = photos_at(folder);
  if (cameras) take(all.cameras, folder, all);
  all.photos.insert(all.photos.end(), photos.begin(), photos.end());
  if (!cameras && photos.empty()) leave_out(folder, "holds neither photos nor cameras", all);
}

void sort_out_file(const fs::path& file, NamedPaths& all) {
  const std::string ending = file.extension().string();
  if (file.filename() == "project.json") return take(all.project, file.parent_path(), all);
  if (is_of_colmap(file)) return take(all.cameras, file.parent_path(), all);
  if (ending == ".json" || ending == ".cameramodel") return take(all.cameras, file, all);
  if (has_photo_ending(file)) return all.photos.push_back(file);
  if (ending == ".bosk") {
    return leave_out(file, "is a finished tree; look at it with `bosk view`", all);
  }
  leave_out(file, "is neither a photo nor a camera file", all);
}

std::string trimmed(const std::string& text, const char* what) {
  const auto from = text.find_first_not_of(what), to = text.find_last_not_of(what);
  return from == std::string::npos ? std::string() : text.substr(from, to - from + 1);
}

// As file managers write addresses: %20 for a blank.
std::string without_percents(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    const char* digits = text.data() + i + 1;
    const bool is_code = text[i] == '%' && i + 2 < text.size() &&
                         std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    plain += is_code ? char(code) : text[i];
    if (is_code) i += 2;
  }
  return plain;
}

}  // namespace

NamedPaths sorted_out(const Paths& named) {
  NamedPaths all;
  for (const fs::path& path : named) {
    std::error_code failure;
    const fs::path place = fs::absolute(path, failure).lexically_normal();
    const fs::path plain = place.has_filename() ? place : place.parent_path();
    if (failure || plain.empty()) {
      all.left_out.push_back("'" + printable(path.string()) + "' is no path");
    } else if (is_folder(plain)) {
      sort_out_folder(plain, all);
    } else if (is_file(plain)) {
      sort_out_file(plain, all);
    } else {
      all.left_out.push_back(printable(path.string()) + ": there is no such file or folder");
    }
  }
  std::sort(all.photos.begin(), all.photos.end());
  all.photos.erase(std::unique(all.photos.begin(), all.photos.end()), all.photos.end());
  return all;
}

Paths mattes_for(const Paths& photos, const fs::path& folder) {
  if (holds_project(folder)) return {};
  std::map<std::string, fs::path> files;
  for (const fs::path& file : photos_in(folder)) files[file.stem().string()] = file;
  Paths mattes;
  for (const fs::path& photo : photos) {
    const auto file = files.find(photo.stem().string());
    if (file == files.end()) continue;
    std::error_code none;
    if (fs::equivalent(photo, file->second, none)) return {};
    mattes.push_back(file->second);
  }
  return mattes;
}

fs::path path_of_text(std::string text) {
  text = trimmed(trimmed(text, " \t\r\n"), "'\"");
  if (text.starts_with("file://")) text = without_percents(text.substr(7));
  const char* home = std::getenv("HOME");
  if (home && (text == "~" || text.starts_with("~/"))) text = home + text.substr(1);
  return text;
}

}  // namespace bosk
