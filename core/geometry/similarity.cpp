#include "core/geometry/similarity.h"

#include <cassert>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/geometry/rotation.h"

namespace bosk {
namespace {

using glm::dmat3;
using glm::dvec3;

// Below it the points lie on a line up to the rounding of their coordinates.
constexpr double kLeastSharpness = 1e-9;

dvec3 mean(std::span<const dvec3> points) {
  dvec3 sum(0.0);
  for (const dvec3& point : points) sum += point;
  return sum / double(points.size());
}

}  // namespace

Similarity inverse(const Similarity& a_from_b) {
  const dmat3 turned = glm::transpose(a_from_b.rotation);
  return {1.0 / a_from_b.scale, turned, -(turned * a_from_b.translation) / a_from_b.scale};
}

// Rotation after Horn 1987, scale after Umeyama 1991 (the errors are the target's; Horn's scale is
// symmetric in both).
Similarity fit_similarity(std::span<const dvec3> source, std::span<const dvec3> target) {
  assert(source.size() == target.size());
  if (source.size() < 3)
    throw Error("a similarity needs at least 3 pairs of points, got " +
                std::to_string(source.size()) + ": add points");
  const dvec3 source_mean = mean(source), target_mean = mean(target);
  dmat3 target_by_source(0.0);
  double source_spread = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const dvec3 a = source[i] - source_mean, b = target[i] - target_mean;
    target_by_source += glm::outerProduct(b, a);
    source_spread += glm::dot(a, a);
  }
  const RotationFit fit = fit_rotation(target_by_source);
  double along = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i)
    along += glm::dot(target[i] - target_mean, fit.rotation * (source[i] - source_mean));
  const double scale = along / source_spread;
  if (!(fit.sharpness > kLeastSharpness) || !(scale > 0.0) || !std::isfinite(scale))
    throw Error(
        "the points that should fix the world's position lie on one line or are not finite: "
        "choose points that spread in two directions");
  return {scale, fit.rotation, target_mean - scale * (fit.rotation * source_mean)};
}

RigidTransform moved(const RigidTransform& camera_from_source,
                     const Similarity& target_from_source) {
  const dmat3 rotation = camera_from_source.rotation * glm::transpose(target_from_source.rotation);
  return {rotation, target_from_source.scale * camera_from_source.translation -
                        rotation * target_from_source.translation};
}

}  // namespace bosk
