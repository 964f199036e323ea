#pragma once

#include <glm/gtc/type_precision.hpp>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/measure/image_quality.h"
#include "core/photo/photo.h"
#include "core/render/prepared_tree.h"

namespace bosk {

// A photo beside what the package shows from the same place. All pictures are of one size, sRGB
// with straight alpha.
struct Comparison {
  Image<glm::u8vec4> photo;        // with its background where that is known; opaque
  Image<glm::u8vec4> truth;        // the tree alone, by its matte
  Image<glm::u8vec4> render;       // the tree alone
  std::optional<ViewScore> score;  // of render against truth; none where the matte shows nothing
};

// Drawn by the CPU reference from the photo's camera through its own lens, in as many pixels as the
// working photo has; photo and matte are resampled into the same pixels. `srgb` (or nothing) and
// `matte` are the working photo's.
Comparison compare_with_photo(const PreparedTree& tree, const Photo& view,
                              const Image<glm::vec3>& srgb, const Image<glm::vec4>& matte,
                              Progress& progress);

// The same of pictures that are there already.
Comparison comparison_of(const Image<glm::u8vec4>& truth, const Image<glm::u8vec4>& render);

// Opaque pictures to look at.
Image<glm::u8vec4> shown_over_white(const Image<glm::u8vec4>& straight);
// |render - truth| over white, three times as strong, on black.
Image<glm::u8vec4> shown_difference(const Comparison& comparison);

}  // namespace bosk
