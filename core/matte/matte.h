#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/base/binary.h"
#include "core/base/options.h"
#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/matte/scribbles.h"
#include "core/photo/photo.h"

namespace bosk {

// The tree alone in one photo: straight sRGB-encoded colour (0 to 1) in rgb, opacity (0 to 1) in a.
// Same size and pixels as the photo's undistorted image. Colour where a = 0 is meaningless but
// finite.
struct Matte {
  std::string name;  // of the photo
  Image<glm::vec4> rgba;
};
using Mattes = std::vector<Matte>;  // in the order of the photos

struct MatteOptions {
  int clusters = 8;              // colours per side, 1 to 32
  std::string mixing = "curve";  // where leaf and background mix: curve, lab, srgb, linear
  double position_sigma = 0.06;  // reach of a stroke, as a fraction of the image diagonal
  double transfer_sigma = 0.12;  // the same, in photos that have no strokes of their own
  double clear_below = 0.03;     // alpha below is set to 0
  double opaque_above = 0.97;    // alpha above is set to 1
};
Options describe(MatteOptions& options);

// Alpha and pure foreground colour of every photo. A photo without strokes of its own is matted
// with the colours learnt from a scribbled photo. Throws Error when no photo has strokes or the
// strokes of one are of a single kind.
Mattes matte_photos(const Photos& photos, const Scribbles& scribbles, const MatteOptions& options,
                    Progress& progress);

void write(BinaryWriter& writer, const Mattes& mattes);
Mattes read_mattes(BinaryReader& reader);

}  // namespace bosk
