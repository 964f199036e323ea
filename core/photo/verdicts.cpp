#include "core/photo/verdicts.h"

#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/base/system_error.h"
#include "core/photo/resample.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kMaxFileBytes = std::uint64_t(2) << 30;
constexpr int kMinSidePx = 16;

std::string size_text(int width_px, int height_px) {
  return std::to_string(width_px) + " x " + std::to_string(height_px);
}

// decode_photo names the file first, and so do the verdicts.
std::string without_file_name(const std::string& message, const fs::path& file) {
  for (const std::string& name : {file.filename().string(), file.string()}) {
    const std::string start = printable(name) + ": ";
    if (message.starts_with(start)) return message.substr(start.size());
  }
  return message;
}

Camera original_camera(const DecodedPhoto& decoded, const std::string& name,
                       const CamerasByName& cameras) {
  if (cameras.empty()) return {name, guessed_lens(decoded), {}};
  Camera camera = *cameras.at(name);
  camera.lens = lens_for_size(camera.lens, decoded.width_px, decoded.height_px);
  return camera;
}

std::string focal_source(const DecodedPhoto& decoded) {
  return decoded.metadata.focal_35mm_equivalent_mm ? "focal length from EXIF"
                                                   : "no focal length in EXIF, a phone's assumed";
}

std::string what_was_done(const DecodedPhoto& decoded, const Photo& photo, bool guessed) {
  const Lens& lens = photo.camera.lens;
  std::string text =
      name_of(decoded.format) + ", " + size_text(decoded.width_px, decoded.height_px);
  if (lens.width_px != decoded.width_px) {
    text += ", scaled to " + size_text(lens.width_px, lens.height_px);
  }
  if (photo.original_camera.lens.model != LensModel::pinhole) text += ", undistorted";
  if (guessed) text += ", " + focal_source(decoded);
  for (const std::string& note : decoded.notes) text += "; " + note;
  return text;
}

// What can be mended becomes a reason; what can't is thrown on.
template <class Step>
std::string trouble_of(const fs::path& file, const Step& step) {
  try {
    step();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    return without_file_name(error.what(), file);
  }
  return {};
}

}  // namespace

CamerasByName cameras_by_name(std::span<const Camera> cameras) {
  CamerasByName all;
  for (const Camera& camera : cameras) {
    if (!all.try_emplace(camera.name, &camera).second) {
      throw Error("two cameras have the name " + printable(camera.name) +
                  "; name each by its photo");
    }
  }
  return all;
}

ContentHash hash_of_photo(const fs::path& file) {
  return content_hash(read_file(file, kMaxFileBytes));
}

void reject(PhotoVerdict& verdict, const std::string& reason) {
  verdict.accepted = false;
  verdict.reason = reason;
}

void reject(PhotoVerdict& verdict, const Error& error) {
  reject(verdict, without_file_name(error.what(), verdict.file));
}

std::vector<PhotoVerdict> begun_verdicts(std::span<const fs::path> files) {
  std::vector<PhotoVerdict> verdicts(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    verdicts[i].file = files[i].string();
    verdicts[i].name = files[i].stem().string();
    verdicts[i].accepted = true;
  }
  return verdicts;
}

void reject_doubles(std::vector<PhotoVerdict>& verdicts) {
  std::map<ContentHash, std::string> by_content;
  std::map<std::string, std::string> by_name;
  for (PhotoVerdict& verdict : verdicts) {
    if (!verdict.accepted) continue;
    const auto [same, is_new] = by_content.try_emplace(verdict.content, verdict.file);
    const auto [namesake, is_only] = by_name.try_emplace(verdict.name, verdict.file);
    if (!is_new) {
      reject(verdict, "is a copy of " + same->second);
    } else if (!is_only) {
      reject(verdict, "has the same name as " + namesake->second + "; rename one of them");
    }
  }
}

void reject_without_camera(std::vector<PhotoVerdict>& verdicts, const CamerasByName& cameras) {
  if (cameras.empty()) return;
  for (PhotoVerdict& verdict : verdicts) {
    if (verdict.accepted && !cameras.contains(verdict.name)) {
      reject(verdict, "no camera has its name; the first of " + std::to_string(cameras.size()) +
                          " cameras is " + printable(cameras.begin()->first));
    }
  }
}

Photo judged_photo(PhotoVerdict& verdict, const DecodedPhoto& decoded, const CamerasByName& cameras,
                   const PhotoOptions& options) {
  verdict.width_px = decoded.width_px;
  verdict.height_px = decoded.height_px;
  verdict.metadata = decoded.metadata;
  if (std::min(decoded.width_px, decoded.height_px) < kMinSidePx) {
    throw Error("has only " + size_text(decoded.width_px, decoded.height_px) +
                " pixels; give the full photo");
  }
  Photo photo;
  photo.name = verdict.name;
  photo.original_camera = original_camera(decoded, verdict.name, cameras);
  const glm::ivec2 size =
      working_size(decoded.width_px, decoded.height_px, options.working_megapixels);
  photo.camera = photo.original_camera;
  photo.camera.lens = undistorted(scaled(photo.original_camera.lens, size.x, size.y));
  verdict.reason = what_was_done(decoded, photo, cameras.empty());
  return photo;
}

PhotoFacts look_through(const fs::path& file, PhotoDecoder& decoder, const Progress& progress) {
  PhotoFacts facts;
  facts.file = file;
  facts.trouble = trouble_of(file, [&] {
    facts.content = hash_of_photo(file);
    facts.decoded = decoder.decode(file, progress);
  });
  return facts;
}

std::vector<PhotoVerdict> photo_verdicts(std::span<const PhotoFacts> files,
                                         std::span<const Camera> cameras,
                                         const PhotoOptions& options) {
  const CamerasByName by_name = cameras_by_name(cameras);
  std::vector<fs::path> paths;
  for (const PhotoFacts& facts : files) paths.push_back(facts.file);
  std::vector<PhotoVerdict> verdicts = begun_verdicts(paths);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].content) {
      verdicts[i].content = *files[i].content;
    } else {
      reject(verdicts[i], files[i].trouble);
    }
  }
  reject_doubles(verdicts);
  reject_without_camera(verdicts, by_name);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!verdicts[i].accepted) continue;
    const std::string trouble =
        !files[i].trouble.empty() ? files[i].trouble : trouble_of(files[i].file, [&] {
          judged_photo(verdicts[i], files[i].decoded, by_name, options);
        });
    if (!trouble.empty()) reject(verdicts[i], trouble);
  }
  return verdicts;
}

}  // namespace bosk
