#include "core/render/view_blend.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bosk {
namespace {

// Views looked at in one go: their cosines fit a small buffer and the compiler's vectors.
constexpr std::size_t kBatch = 64;

double inverse_angle(double angle) { return 1.0 / std::max(angle, 1e-9); }

}  // namespace

ViewPicker::ViewPicker(const TreeModel& model, const TreeLevel& level, BlendRule rule)
    : pivot_(model.origin + 0.5 * model.size_m), rule_(rule) {
  for (const std::uint32_t view : level.views) {
    const glm::dvec3 position = model.view_positions[view];
    positions_.push_back(position);
    x_.push_back(float(position.x - pivot_.x));
    y_.push_back(float(position.y - pivot_.y));
    z_.push_back(float(position.z - pivot_.z));
  }
}

ViewPicker::Nearest ViewPicker::nearest_three(const glm::dvec3& centre,
                                              const glm::dvec3& to_eye) const {
  const glm::vec3 c(centre - pivot_), e(to_eye);
  Nearest nearest{{view_count(), view_count(), view_count()}, 0};
  float best[3];
  std::fill(best, best + 3, -std::numeric_limits<float>::infinity());
  float cosine[kBatch];
  for (std::size_t first = 0; first < x_.size(); first += kBatch) {
    const std::size_t count = std::min(kBatch, x_.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const float x = x_[first + i] - c.x, y = y_[first + i] - c.y, z = z_[first + i] - c.z;
      cosine[i] = (x * e.x + y * e.y + z * e.z) / std::sqrt(x * x + y * y + z * z + 1e-30f);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!(cosine[i] > best[2])) continue;
      int at = 2;
      for (; at > 0 && cosine[i] > best[at - 1]; --at) {
        best[at] = best[at - 1];
        nearest.index[at] = nearest.index[at - 1];
      }
      best[at] = cosine[i];
      nearest.index[at] = std::uint32_t(first + i);
    }
  }
  nearest.count = int(std::min<std::size_t>(3, x_.size()));
  return nearest;
}

double ViewPicker::angle(std::uint32_t view, const glm::dvec3& centre,
                         const glm::dvec3& to_eye) const {
  const glm::dvec3 to_view = positions_[view] - centre;
  const double lengths = glm::length(to_view) * glm::length(to_eye);
  if (!(lengths > 0.0)) return 0.0;
  return std::acos(std::clamp(glm::dot(to_view, to_eye) / lengths, -1.0, 1.0));
}

ViewBlend ViewPicker::pick(const glm::dvec3& centre, const glm::dvec3& eye) const {
  const glm::dvec3 to_eye = eye - centre;
  const Nearest nearest = nearest_three(centre, to_eye);
  const std::uint32_t a = nearest.index[0], b = nearest.index[1];
  if (nearest.count < 2 || b >= view_count()) return {a, a, 0.0f};
  double share_a = inverse_angle(angle(a, centre, to_eye));
  double share_b = inverse_angle(angle(b, centre, to_eye));
  if (rule_ == BlendRule::fading && nearest.count > 2 && nearest.index[2] < view_count()) {
    const double fade = inverse_angle(angle(nearest.index[2], centre, to_eye));
    share_a = std::max(share_a - fade, 0.0);
    share_b = std::max(share_b - fade, 0.0);
  }
  const double sum = share_a + share_b;
  return {a, b, sum > 0.0 ? float(share_b / sum) : 0.0f};
}

}  // namespace bosk
