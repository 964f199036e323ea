#pragma once

#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/matte/matte.h"
#include "core/photo/photo.h"
#include "core/radiance/volume_snapshot.h"

namespace bosk {

// The photos' mattes, small: made once, compared with many states of a volume.
struct SmallMatte {
  std::string name;
  Camera camera;                   // pinhole, at the small size
  Image<glm::vec4> premultiplied;  // sRGB-encoded; means over blocks of pixels
};
// At most `longest_px` along the longer edge, by whole steps.
std::vector<SmallMatte> small_mattes(const Photos& photos, const Mattes& mattes,
                                     int longest_px = 96);

struct PhotoResidual {
  std::string name;
  double alpha_error = 0.0;  // mean |alpha - matte| over the pixels that either shows
  double psnr_db = 0.0;      // of premultiplied colour and alpha over those; alpha alone where the
                             // volume has no colour. Infinite when exact
};
// How far the volume is from each photo, in the order given. On all cores.
std::vector<PhotoResidual> photo_residuals(const VolumeSnapshot& volume,
                                           const std::vector<SmallMatte>& mattes);

}  // namespace bosk
