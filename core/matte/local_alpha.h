#pragma once

#include <glm/glm.hpp>

#include "core/base/progress.h"
#include "core/image/image.h"

namespace bosk {

// Alpha of half-covered pixels measured once more, along the line in linear light from the mean
// colour of the sure background close by to that of the sure tree close by. The answer counts for
// more the further apart the two are against their own spread times `caution`. Calls
// progress.advance() for each row.
void refine_locally(const Image<glm::vec3>& linear, float caution, Image<float>& alpha,
                    Progress& progress);

}  // namespace bosk
