#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/photo/photo.h"

namespace bosk {

// Where all optical axes nearly meet, in the world; none when they are too parallel.
std::optional<glm::dvec3> place_seen_by_all(const Photos& photos);

// What nearly all photos agree on, in a cube of cells around the tree out to where the photos end.
struct AgreedVolume {
  static constexpr int kSide = 64;  // cells along each edge
  glm::dvec3 centre_in_world{0.0};
  double half_edge_m = 0.0;
  std::vector<float> alpha;  // of the surroundings, as photos show them; x runs fastest, then y

  glm::dvec3 cell_centre(const glm::ivec3& cell) const;
  glm::ivec3 cell_of(const glm::dvec3& point_in_world) const;  // may lie outside
  float at(const glm::ivec3& cell) const;                      // 0 outside
};

// `mean_alpha` is, for each photo, a coarse grid of the opacity around each place. None when the
// cameras do not look at the tree from around, or there are fewer than four.
std::optional<AgreedVolume> agreed_volume(const Photos& photos,
                                          const std::vector<Image<float>>& mean_alpha,
                                          Progress& progress);

// How much less likely opaque is where the other photos exclude it (natural logarithm), at
// weight 1.
constexpr float kMostDoubt = -3.2f;

// For each photo a coarse grid of how much less likely opaque is (natural logarithm, kMostDoubt *
// weight to 0), because along that ray there is no place that the other photos too hold for tree.
std::vector<Image<float>> hull_tilts(const Photos& photos, const AgreedVolume& volume, float weight,
                                     Progress& progress);

}  // namespace bosk
