#include "core/photo/import.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/system_error.h"
#include "core/photo/resample.h"
#include "core/photo/verdicts.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

// More photos at once would take memory, not time: beyond this the disk is the limit.
constexpr int kMaxPhotosAtOnce = 8;

struct Imported {
  Photo photo;
  Image<glm::vec4> rgba;
};

// Runs `step` for each accepted photo, a few at a time; an Error that the user can mend becomes a
// verdict.
template <class Step>
void for_each_photo(std::vector<PhotoVerdict>& verdicts, Progress& progress, const Step& step) {
  const int at_once = std::min(kMaxPhotosAtOnce, tbb::this_task_arena::max_concurrency());
  tbb::task_arena arena(std::max(1, at_once));
  arena.execute([&] {
    tbb::parallel_for(std::size_t(0), verdicts.size(), [&](std::size_t i) {
      // Isolated, so that a thread that waits for the rows of one photo doesn't begin another
      tbb::this_task_arena::isolate([&] {
        try {
          if (verdicts[i].accepted) step(i);
        } catch (const Error& error) {
          if (error.kind() != ErrorKind::bad_input) throw;
          reject(verdicts[i], error);
        }
      });
      progress.advance();
    });
  });
}

Image<glm::vec3> colour_of(const Image<glm::vec4>& rgba) {
  Image<glm::vec3> srgb(rgba.width(), rgba.height());
  std::transform(rgba.pixels().begin(), rgba.pixels().end(), srgb.pixels().begin(),
                 [](const glm::vec4& pixel) { return glm::vec3(pixel); });
  return srgb;
}

Imported imported_photo(PhotoVerdict& verdict, const CamerasByName& cameras,
                        const PhotoOptions& options, PhotoDecoder& decoder,
                        const Progress& progress) {
  const DecodedPhoto decoded = decoder.decode(verdict.file, progress);
  Imported result;
  Photo& photo = result.photo;
  photo = judged_photo(verdict, decoded, cameras, options);
  Image<glm::vec4> rgba = undistorted_photo(decoded, photo.original_camera.lens, photo.camera.lens);
  photo.srgb = colour_of(rgba);
  if (decoded.has_alpha()) result.rgba = std::move(rgba);
  return result;
}

PhotoImport gathered(std::vector<PhotoVerdict> verdicts, std::vector<Imported> all,
                     Progress& progress) {
  PhotoImport import;
  import.verdicts = std::move(verdicts);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PhotoVerdict& verdict = import.verdicts[i];
    if (verdict.accepted) {
      import.photos.push_back(std::move(all[i].photo));
      import.rgba.push_back(std::move(all[i].rgba));
    } else {
      progress.warn(printable(verdict.file) + ": " + verdict.reason);
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
  const CamerasByName by_name = cameras_by_name(cameras);
  std::vector<PhotoVerdict> verdicts = begun_verdicts(files);
  progress.begin("Looking through photos", files.size(), 0.0, 0.1);
  for_each_photo(verdicts, progress,
                 [&](std::size_t i) { verdicts[i].content = hash_of_photo(verdicts[i].file); });
  reject_doubles(verdicts);
  reject_without_camera(verdicts, by_name);
  progress.begin("Reading photos", files.size(), 0.1, 1.0);
  std::vector<Imported> photos(files.size());
  tbb::enumerable_thread_specific<PhotoDecoder> decoders(decode_limits(options));
  for_each_photo(verdicts, progress, [&](std::size_t i) {
    photos[i] = imported_photo(verdicts[i], by_name, options, decoders.local(), progress);
  });
  return gathered(std::move(verdicts), std::move(photos), progress);
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
