#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/base/content_hash.h"
#include "core/base/options.h"
#include "core/base/progress.h"
#include "core/photo/decode.h"
#include "core/photo/photo.h"

namespace bosk {

struct PhotoOptions {
  double working_megapixels = 1.0;  // photos are scaled down to this, never up
  double max_megapixels = 150.0;    // larger files are refused before they are decoded
  double memory_gib = 4.0;          // what decoding one photo may take
  double seconds = 60.0;            // how long decoding one photo may take
};
Options describe(PhotoOptions& options);

// What became of one file. `reason` is a clause: why it was rejected, or, for an accepted photo,
// what was done with it ("JPEG, 6000 x 4000, scaled to 1225 x 816; its colour profile ... was read
// as sRGB").
struct PhotoVerdict {
  std::string file, name;  // as given; without folder and ending
  bool accepted = false;
  std::string reason;
  int width_px = 0, height_px = 0;  // of the file; 0 when it could not be read
  PhotoMetadata metadata;
  ContentHash content;
};

// `photos` holds the accepted ones in the order of the files; `rgba` beside it the same pixels with
// straight alpha for files that have alpha (they serve as mattes), empty images for the others.
struct PhotoImport {
  Photos photos;
  std::vector<Image<glm::vec4>> rgba;
  std::vector<PhotoVerdict> verdicts;  // one per file, in the order of the files
};

// Decodes each file, matches it with a camera by name, scales it to the working size and undistorts
// it, in one resampling. Cameras may be empty (they are calibrated later): then the lens is guessed
// from EXIF. A file that is no use gets a verdict and a warning and the others go on; Error when no
// file is left, or memory runs out. The result doesn't depend on the number of threads.
PhotoImport import_photos(std::span<const std::filesystem::path> files,
                          std::span<const Camera> cameras, const PhotoOptions& options,
                          Progress& progress);

// The limits that PhotoOptions means: for a PhotoDecoder beside import_photos.
DecodeLimits decode_limits(const PhotoOptions& options);

// Width and height, about a pixel count of `megapixels`, of the same shape; the size itself when it
// has fewer.
glm::ivec2 working_size(int width_px, int height_px, double megapixels);

// A pinhole guessed from EXIF's focal length (35 mm equivalent, by the diagonal); without one 1.2
// times the longer side, which is about a phone's.
Lens guessed_lens(const DecodedPhoto& photo);

}  // namespace bosk
