#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/photo/photo.h"

namespace bosk {

// Where all optical axes nearly meet, in the world; none when they are too parallel.
std::optional<glm::dvec3> place_seen_by_all(const Photos& photos);

// For each photo a coarse grid of how much less likely opaque is, 0 or negative (natural
// logarithm), because along that ray there is no place that the other photos too hold for tree.
// `mean_alpha` is, for each photo, a coarse grid of the opacity around each place. Empty when the
// cameras do not look at the tree from around, or there are fewer than four.
std::vector<Image<float>> hull_tilts(const Photos& photos,
                                     const std::vector<Image<float>>& mean_alpha, float weight,
                                     Progress& progress);

}  // namespace bosk
