#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/content_hash.h"
#include "core/calibrate/sightings.h"
#include "core/image/image.h"
#include "core/matte/strokes.h"

namespace bosk {

// What a person painted over on a photo (StrokeKind::left_out, in its pixels as delivered) so that
// calibration passes over it: sky and clouds, people, cars, a puddle.

// 0 where something is left out, 255 elsewhere, for a photo of `photo_px` reduced to `mask_px`.
Image<std::uint8_t> mask_of(const std::vector<Stroke>& left_out, const glm::ivec2& photo_px,
                            const glm::ivec2& mask_px);

// Takes out of the photo's sightings what is found there; clicks stay.
void leave_out(const std::vector<Stroke>& left_out, PhotoSightings& photo);

void hash_left_out(ContentHasher& hasher, const Strokes& left_out);

}  // namespace bosk
