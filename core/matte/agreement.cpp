#include "core/matte/agreement.h"

#include <algorithm>

#include "core/matte/surroundings.h"

namespace bosk {
namespace {

// The lesser of both at each place, on the grid of b.
Image<float> least_of_grids(const Image<float>& a, const Image<float>& b) {
  Image<float> least = stretched(a, b.width(), b.height());
  for (std::size_t i = 0; i < least.size(); ++i)
    least.data()[i] = std::min(least.data()[i], b.data()[i]);
  return least;
}

}  // namespace

std::vector<Image<float>> agreement_tilts(const Photos& photos,
                                          const std::vector<Image<float>>& mean_alpha,
                                          const std::optional<Ground>& ground, bool settled,
                                          float weight, Progress& progress) {
  std::vector<Image<float>> tilts(photos.size(), Image<float>(1, 1));
  if (weight <= 0.0f) return tilts;
  const auto volume = agreed_volume(photos, mean_alpha, progress);
  if (volume) tilts = hull_tilts(photos, *volume, weight, progress);
  if (!ground) return tilts;
  const auto below =
      ground_tilts(photos, *ground, settled ? volume : std::nullopt, weight, progress);
  for (std::size_t i = 0; i < photos.size(); ++i) tilts[i] = least_of_grids(tilts[i], below[i]);
  return tilts;
}

}  // namespace bosk
