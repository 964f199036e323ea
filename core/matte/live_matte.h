#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/matte/matte.h"
#include "core/matte/stroke_model.h"

namespace bosk {

// About as large as a matte can be that follows the brush on two cores (README.md).
constexpr double kLiveMegapixels = 0.2;

// A photo made ready for live_matte: all that does not change with the strokes.
struct LivePhoto {
  Photo full;
  LabPlanes lab;                  // of the full photo
  Photo small;                    // the full one's area means, with its camera at that size
  Image<glm::vec3> small_linear;  // its linear light
};
LivePhoto ready_for_live(const Photo& photo, Progress& progress,
                         double megapixels = kLiveMegapixels);

// `matte` has the size of LivePhoto::small. It is empty while strokes are missing; then
// `what_is_missing` says in a sentence what to draw.
struct LiveMatte {
  Matte matte;
  std::string what_is_missing;
};

// What the other photos say of each photo (agreement.h), from mattes of all that are at hand: for
// live_matte. One grid per photo, a single zero each where the photos say nothing. About 0.7 s.
std::vector<Image<float>> hull_tilts_from(const Photos& photos, const Mattes& mattes,
                                          const MatteOptions& options, Progress& progress);

// What matte_photos would make of this photo alone, at a reduced size and from fewer samples: made
// to be computed again after each stroke. `strokes` has the full photo's size or is empty.
// `hull_tilt` is the photo's of hull_tilts_from.
LiveMatte live_matte(const LivePhoto& photo, const Image<std::uint8_t>& strokes,
                     const Image<float>& hull_tilt, const MatteOptions& options,
                     Progress& progress);

}  // namespace bosk
