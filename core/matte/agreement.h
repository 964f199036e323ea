#pragma once

#include <optional>
#include <vector>

#include "core/matte/ground.h"

namespace bosk {

// For each photo a grid of how much less likely opaque is (natural logarithm, 0 or less), by what
// the other photos show: the greater doubt of hull_tilts and ground_tilts; a single zero where they
// say nothing. `mean_alpha` is as for agreed_volume. `settled` says that it already owes something
// to the ground: before, shadows that all photos hold for tree stand like trees on it.
std::vector<Image<float>> agreement_tilts(const Photos& photos,
                                          const std::vector<Image<float>>& mean_alpha,
                                          const std::optional<Ground>& ground, bool settled,
                                          float weight, Progress& progress);

}  // namespace bosk
