#pragma once

#include "core/matte/matte.h"
#include "core/matte/study.h"

namespace bosk {

Image<glm::vec3> linear_light(const Image<glm::vec3>& srgb, const Progress& progress);

// The matte of a photo about which all is settled; `linear` is its linear light. Calls
// progress.advance() four times for each row. The photo may be a smaller copy of the one studied.
Matte matte_from_study(const Photo& photo, const Image<glm::vec3>& linear, const Study& study,
                       const MatteOptions& options, Progress& progress);

}  // namespace bosk
