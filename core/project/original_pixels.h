#pragma once

#include "core/image/image.h"
#include "core/photo/photo.h"

namespace bosk {

// A picture in the photo's working pixels as it would be in the photo as taken, with its size and
// lens; bilinear in premultiplied colour. Clear where the working picture doesn't reach.
Image<glm::vec4> in_original_pixels(const Image<glm::vec4>& working, const Photo& photo);

}  // namespace bosk
