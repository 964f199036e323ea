#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/balls.h"
#include "core/calibrate/boards.h"
#include "core/calibrate/lens_profile.h"
#include "core/calibrate/tags.h"
#include "core/project/cache.h"
#include "core/project/calibration_sources.h"

namespace bosk {

// What to look for in one photo.
struct LookFor {
  std::optional<BallOptions> balls;
  std::string tags;  // their dictionary; empty: none
  std::optional<BoardShape> board;
};

// What one photo shows by itself, in its own pixels, before balls have names.
struct PhotoFinds {
  std::string name;
  int width_px = 0, height_px = 0;
  std::optional<double> exif_focal_px;
  std::optional<glm::dvec3> up_in_camera;
  LensIdentity taken_with;
  std::vector<SightedBall> balls;
  std::vector<SightedTag> tags;
  std::vector<BoardCorner> corners;
  std::string trouble;  // why the photo can't be read; empty: it could
};

// Decodes each photo at full size and looks through it, several at a time; each is kept in the
// cache under its content and what was looked for, so that another photo or a click costs nothing.
// Throws Error where memory ran out, Cancelled.
std::vector<PhotoFinds> find_in_photos(const std::vector<SourceFile>& photos, const LookFor& wanted,
                                       const DecodeLimits& limits, const Cache& cache,
                                       Progress& progress);

void write(BinaryWriter& writer, const PhotoFinds& finds);
PhotoFinds read_photo_finds(BinaryReader& reader);

}  // namespace bosk
