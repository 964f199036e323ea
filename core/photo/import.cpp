#include "core/photo/import.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/system_error.h"
#include "core/photo/resample.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kMaxFileBytes = std::uint64_t(2) << 30;
constexpr int kMinSidePx = 16;
// More photos at once would take memory, not time: beyond this the disk is the limit.
constexpr int kMaxPhotosAtOnce = 8;

struct Imported {
  PhotoVerdict verdict;
  Photo photo;
  Image<glm::vec4> rgba;
};

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

void reject(PhotoVerdict& verdict, const std::string& reason) {
  verdict.accepted = false;
  verdict.reason = reason;
}

// Runs `step` for each index, a few at a time; an Error that the user can mend becomes a verdict.
template <class Step>
void for_each_photo(std::vector<Imported>& photos, Progress& progress, const Step& step) {
  const int at_once = std::min(kMaxPhotosAtOnce, tbb::this_task_arena::max_concurrency());
  tbb::task_arena arena(std::max(1, at_once));
  arena.execute([&] {
    tbb::parallel_for(std::size_t(0), photos.size(), [&](std::size_t i) {
      // Isolated, so that a thread that waits for the rows of one photo doesn't begin another
      tbb::this_task_arena::isolate([&] {
        PhotoVerdict& verdict = photos[i].verdict;
        try {
          if (verdict.accepted) step(photos[i]);
        } catch (const Error& error) {
          if (error.kind() != ErrorKind::bad_input) throw;
          reject(verdict, without_file_name(error.what(), verdict.file));
        }
      });
      progress.advance();
    });
  });
}

std::vector<Imported> begin_import(std::span<const fs::path> files) {
  std::vector<Imported> photos(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    PhotoVerdict& verdict = photos[i].verdict;
    verdict.file = files[i].string();
    verdict.name = files[i].stem().string();
    verdict.accepted = true;
  }
  return photos;
}

// Later files of a pair are rejected, so that the order of the files alone decides.
void reject_doubles(std::vector<Imported>& photos) {
  std::map<ContentHash, std::string> by_content;
  std::map<std::string, std::string> by_name;
  for (Imported& photo : photos) {
    PhotoVerdict& verdict = photo.verdict;
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

using CamerasByName = std::map<std::string, const Camera*>;

CamerasByName by_name(std::span<const Camera> cameras) {
  CamerasByName all;
  for (const Camera& camera : cameras) {
    if (!all.try_emplace(camera.name, &camera).second) {
      throw Error("two cameras have the name " + printable(camera.name) +
                  "; name each by its photo");
    }
  }
  return all;
}

void reject_without_camera(std::vector<Imported>& photos, const CamerasByName& cameras) {
  if (cameras.empty()) return;
  for (Imported& photo : photos) {
    PhotoVerdict& verdict = photo.verdict;
    if (verdict.accepted && !cameras.contains(verdict.name)) {
      reject(verdict, "no camera has its name; the first of " + std::to_string(cameras.size()) +
                          " cameras is " + printable(cameras.begin()->first));
    }
  }
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

Image<glm::vec3> colour_of(const Image<glm::vec4>& rgba) {
  Image<glm::vec3> srgb(rgba.width(), rgba.height());
  std::transform(rgba.pixels().begin(), rgba.pixels().end(), srgb.pixels().begin(),
                 [](const glm::vec4& pixel) { return glm::vec3(pixel); });
  return srgb;
}

void import_one(Imported& result, const CamerasByName& cameras, const PhotoOptions& options,
                PhotoDecoder& decoder, const Progress& progress) {
  PhotoVerdict& verdict = result.verdict;
  const DecodedPhoto decoded = decoder.decode(verdict.file, progress);
  verdict.width_px = decoded.width_px;
  verdict.height_px = decoded.height_px;
  verdict.metadata = decoded.metadata;
  if (std::min(decoded.width_px, decoded.height_px) < kMinSidePx) {
    throw Error("has only " + size_text(decoded.width_px, decoded.height_px) +
                " pixels; give the full photo");
  }
  Photo& photo = result.photo;
  photo.name = verdict.name;
  photo.original_camera = original_camera(decoded, verdict.name, cameras);
  const glm::ivec2 size =
      working_size(decoded.width_px, decoded.height_px, options.working_megapixels);
  photo.camera = photo.original_camera;
  photo.camera.lens = undistorted(scaled(photo.original_camera.lens, size.x, size.y));
  Image<glm::vec4> rgba = undistorted_photo(decoded, photo.original_camera.lens, photo.camera.lens);
  photo.srgb = colour_of(rgba);
  if (decoded.has_alpha()) result.rgba = std::move(rgba);
  verdict.reason = what_was_done(decoded, photo, cameras.empty());
}

PhotoImport gathered(std::vector<Imported> all, Progress& progress) {
  PhotoImport import;
  for (Imported& one : all) {
    import.verdicts.push_back(one.verdict);
    if (one.verdict.accepted) {
      import.photos.push_back(std::move(one.photo));
      import.rgba.push_back(std::move(one.rgba));
    } else {
      progress.warn(printable(one.verdict.file) + ": " + one.verdict.reason);
    }
  }
  if (!import.photos.empty()) return import;
  if (import.verdicts.empty()) throw Error("no photos were given; name at least one file");
  const PhotoVerdict& first = import.verdicts.front();
  throw Error("none of the " + std::to_string(import.verdicts.size()) + " photos can be used; " +
              printable(first.file) + ": " + first.reason);
}

}  // namespace

Options describe(PhotoOptions& options) {
  return {
      {"working_megapixels",
       "megapixels",
       "size that photos are scaled down to: more is sharper and slower",
       &options.working_megapixels,
       0.01,
       50.0,
       {}},
      {"max_megapixels",
       "megapixels",
       "larger photos are refused",
       &options.max_megapixels,
       0.1,
       1000.0,
       {}},
      {"memory_gib",
       "GiB",
       "memory that decoding one photo may take",
       &options.memory_gib,
       1.0,
       64.0,
       {}},
      {"seconds", "s", "time that decoding one photo may take", &options.seconds, 1.0, 3600.0, {}},
  };
}

PhotoImport import_photos(std::span<const fs::path> files, std::span<const Camera> cameras,
                          const PhotoOptions& options, Progress& progress) {
  const CamerasByName cameras_by_name = by_name(cameras);
  std::vector<Imported> photos = begin_import(files);
  progress.begin("Looking through photos", photos.size(), 0.0, 0.1);
  for_each_photo(photos, progress, [](Imported& photo) {
    photo.verdict.content = content_hash(read_file(photo.verdict.file, kMaxFileBytes));
  });
  reject_doubles(photos);
  reject_without_camera(photos, cameras_by_name);
  progress.begin("Reading photos", photos.size(), 0.1, 1.0);
  tbb::enumerable_thread_specific<PhotoDecoder> decoders(decode_limits(options));
  for_each_photo(photos, progress, [&](Imported& photo) {
    import_one(photo, cameras_by_name, options, decoders.local(), progress);
  });
  return gathered(std::move(photos), progress);
}

DecodeLimits decode_limits(const PhotoOptions& options) {
  DecodeLimits limits;
  limits.max_megapixels = options.max_megapixels;
  limits.child.memory_bytes = std::uint64_t(options.memory_gib * double(1 << 30));
  limits.child.result_bytes = limits.child.memory_bytes;
  limits.child.wall_s = options.seconds;
  limits.child.cpu_s = options.seconds;
  return limits;
}

glm::ivec2 working_size(int width_px, int height_px, double megapixels) {
  const double shrink = std::sqrt(1e6 * megapixels / (double(width_px) * double(height_px)));
  if (shrink >= 1.0) return {width_px, height_px};
  return {std::max(1L, std::lround(width_px * shrink)),
          std::max(1L, std::lround(height_px * shrink))};
}

Lens guessed_lens(const DecodedPhoto& photo) {
  constexpr double kFilmDiagonalMm = 43.2666;  // of 36 x 24 mm
  Lens lens;
  lens.width_px = photo.width_px;
  lens.height_px = photo.height_px;
  lens.principal_px = 0.5 * (glm::dvec2(photo.width_px, photo.height_px) - 1.0);
  const double diagonal_px = std::hypot(photo.width_px, photo.height_px);
  const auto equivalent_mm = photo.metadata.focal_35mm_equivalent_mm;
  lens.focal_px = glm::dvec2(equivalent_mm ? *equivalent_mm / kFilmDiagonalMm * diagonal_px
                                           : 1.2 * std::max(photo.width_px, photo.height_px));
  return lens;
}

}  // namespace bosk
