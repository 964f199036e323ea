#include "core/project/imported_mattes.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/image/image_io.h"
#include "core/photo/resample.h"

namespace bosk {
namespace {

const SourceFile* file_named(const std::vector<SourceFile>& files, const std::string& name) {
  for (const SourceFile& file : files) {
    if (file.name == name) return &file;
  }
  return nullptr;
}

const SourceFile& matte_file(const std::vector<SourceFile>& files, const Photo& photo) {
  if (const SourceFile* file = file_named(files, photo.name)) return *file;
  throw Error("photo " + printable(photo.name) + " has no matte; add one of its name");
}

// In the photo's working pixels; without colour where the file has none.
struct FittedMatte {
  Image<glm::vec4> rgba;
  bool has_colour = false;
};

FittedMatte fitted_matte(const SourceFile& file, const Photo& photo, PhotoDecoder& decoder,
                         const Progress& progress) {
  const DecodedMatte matte = decoder.decode_matte(file.path, progress);
  try {
    return {undistort_rgba(matte.rgba, photo.original_camera, photo.camera), matte.has_colour};
  } catch (const Error& error) {
    throw Error(printable(file.path.string()) + ": " + error.what(), error.kind());
  }
}

void require_something(const SourceFile& file, const Image<glm::vec4>& rgba) {
  const auto& pixels = rgba.pixels();
  if (std::any_of(pixels.begin(), pixels.end(), [](const glm::vec4& p) { return p.a > 0.0f; })) {
    return;
  }
  throw Error(
      printable(file.path.string()) +
      ": the matte is clear everywhere, so the photo shows no tree; mend the matte or leave "
      "the photo out");
}

std::vector<FittedMatte> fitted_mattes(const std::vector<SourceFile>& files, const Photos& photos,
                                       const DecodeLimits& limits, Progress& progress) {
  std::vector<FittedMatte> mattes(photos.size());
  tbb::enumerable_thread_specific<PhotoDecoder> decoders(limits);
  progress.begin("Reading mattes", photos.size(), 0.0, 0.6);
  tbb::parallel_for(std::size_t(0), photos.size(), [&](std::size_t i) {
    const SourceFile& file = matte_file(files, photos[i]);
    mattes[i] = fitted_matte(file, photos[i], decoders.local(), progress);
    require_something(file, mattes[i].rgba);
    progress.advance();
  });
  return mattes;
}

Image<float> alpha_of(const Image<glm::vec4>& rgba) {
  Image<float> alpha(rgba.width(), rgba.height());
  std::transform(rgba.pixels().begin(), rgba.pixels().end(), alpha.pixels().begin(),
                 [](const glm::vec4& pixel) { return pixel.a; });
  return alpha;
}

std::size_t rows_to_colour(const std::vector<FittedMatte>& mattes) {
  std::size_t rows = 0;
  for (const FittedMatte& matte : mattes) {
    if (!matte.has_colour) rows += std::size_t(matte.rgba.height());
  }
  return rows;
}

// White, black or grey as a stroke's value: the mean of the channels.
Image<std::uint8_t> grey_of(const DecodedPhoto& drawn) {
  const Image<glm::vec3> srgb = srgb_of(drawn);
  Image<std::uint8_t> grey(srgb.width(), srgb.height());
  std::transform(srgb.pixels().begin(), srgb.pixels().end(), grey.pixels().begin(),
                 [](const glm::vec3& p) { return byte_from_unit((p.r + p.g + p.b) / 3.0f); });
  return grey;
}

bool is_unknown(const Image<std::uint8_t>& scribbles) {
  const auto& pixels = scribbles.pixels();
  return std::all_of(pixels.begin(), pixels.end(),
                     [](std::uint8_t value) { return value == kNoStroke; });
}

}  // namespace

Mattes import_mattes(const std::vector<SourceFile>& files, const Photos& photos,
                     const DecodeLimits& limits, Progress& progress) {
  std::vector<FittedMatte> fitted = fitted_mattes(files, photos, limits, progress);
  progress.begin("Colours of mattes", rows_to_colour(fitted), 0.6, 1.0);
  Mattes mattes;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    mattes.push_back(fitted[i].has_colour
                         ? Matte{photos[i].name, std::move(fitted[i].rgba)}
                         : matte_from_alpha(photos[i], alpha_of(fitted[i].rgba), progress));
    fitted[i].rgba = {};
  }
  return mattes;
}

Image<std::uint8_t> import_drawing(const SourceFile& file, const Photo& photo,
                                   const DecodeLimits& limits, const Progress& progress) {
  const DecodedPhoto drawn = decode_photo(file.path, limits, progress);
  return drawing_in_photo(grey_of(drawn), photo, printable(file.path.string()));
}

Scribbles import_scribbles(const std::vector<SourceFile>& files, const Strokes& strokes,
                           const Photos& photos, const DecodeLimits& limits, Progress& progress) {
  Scribbles scribbles;
  for (const Photo& photo : photos) {
    progress.check();
    const SourceFile* file = file_named(files, photo.name);
    const auto drawn = strokes.find(photo.name);
    Image<std::uint8_t> known;
    if (file != nullptr) known = import_drawing(*file, photo, limits, progress);
    if (drawn != strokes.end()) paint_strokes(drawn->second, photo, known);
    if (known.empty() || (file == nullptr && is_unknown(known))) continue;
    scribbles[photo.name] = std::move(known);
  }
  return scribbles;
}

}  // namespace bosk
