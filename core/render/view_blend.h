#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/package/tree_model.h"

namespace bosk {

// Two of a level's views and how to mix them: colour = (1 - weight_b) a + weight_b b,
// premultiplied. `a` and `b` are positions in TreeLevel::views.
struct ViewBlend {
  std::uint32_t a = 0, b = 0;
  float weight_b = 0.0f;
};

// How the weight falls with the angle between the directions to the eye and to a view.
enum class BlendRule {
  // angle_a / (angle_a + angle_b): linear in angle (Linz et al. 2006, after Reche et al. 2004).
  // Jumps when the second nearest view changes, unless views and eye lie in one plane.
  linear,
  // The same with 1 / angle_third taken from both inverse angles, so that b has faded out where the
  // third view takes its place (after Buehler et al. 2001, unstructured lumigraph rendering).
  fading,
};

// "linear" or "fading", as options name them.
inline BlendRule blend_rule(const std::string& name) {
  return name == "linear" ? BlendRule::linear : BlendRule::fading;
}

// Picks the views of one level for any cell and eye.
class ViewPicker {
 public:
  ViewPicker(const TreeModel& model, const TreeLevel& level, BlendRule rule);

  // The two views nearest in angle, seen from `centre`. One view: weight 0. No view: a is
  // view_count().
  ViewBlend pick(const glm::dvec3& centre, const glm::dvec3& eye) const;
  std::uint32_t view_count() const { return std::uint32_t(positions_.size()); }

 private:
  struct Nearest {
    std::uint32_t index[3];
    int count;
  };
  Nearest nearest_three(const glm::dvec3& centre, const glm::dvec3& to_eye) const;
  double angle(std::uint32_t view, const glm::dvec3& centre, const glm::dvec3& to_eye) const;

  std::vector<glm::dvec3> positions_;  // of the level's views, world frame
  std::vector<float> x_, y_, z_;       // the same from `pivot_`, padded to a multiple of 4
  glm::dvec3 pivot_;
  BlendRule rule_;
};

}  // namespace bosk
