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
  int clusters = 8;              // colours per kind of stroke, 1 to 32
  std::string mixing = "curve";  // where leaf and background mix: curve, lab, srgb
  double position_sigma = 0.1;   // reach of a stroke's colours, as a fraction of the image diagonal
  double transfer_sigma = 0.1;   // the same, in photos that have no strokes of their own
  double position_weight = 2.0;  // how much a place near strokes of one kind favours that kind
  double region_sigma = 0.03;    // reach of the surroundings, as a fraction of the image diagonal
  double region_weight = 2.0;    // how much tree or background all around favours the same
  double hull_weight = 3.0;  // how much the other photos, through their cameras, say "not the tree"
  double local_caution =
      5.0;  // half-covered pixels: 0 trusts the colours close by, large ignores them
  double clear_below = 0.03;   // alpha below becomes 0
  double opaque_above = 0.97;  // alpha above becomes 1
};
Options describe(MatteOptions& options);

// Alpha and pure foreground colour of every photo. A photo without strokes of its own is matted
// with the colours learnt from the scribbled photo that fits it best; a warning says which fit
// badly. Strokes of one kind correct what others teach. Where the cameras look at the tree from
// around, what only some photos hold for tree is doubted. Throws Error when no photo has strokes of
// both kinds, or those of one are of another size than the photo.
Mattes matte_photos(const Photos& photos, const Scribbles& scribbles, const MatteOptions& options,
                    Progress& progress);

// The matte of a photo whose alpha is known: adds the foreground's colour, estimated from the
// photo. Progress counts the photo's rows.
Matte matte_from_alpha(const Photo& photo, const Image<float>& alpha, Progress& progress);

void write(BinaryWriter& writer, const Mattes& mattes);
Mattes read_mattes(BinaryReader& reader);

}  // namespace bosk
