#include "core/phantom/tree_shape.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace bosk {
namespace {

TreeShape dense_shape() {
  TreeShape shape;
  shape.radius_profile = {3.0, 4.7, 5.3, 5.3, 4.9, 4.3, 3.5, 2.3, 0.5};
  return shape;
}

TreeShape sparse_shape() {
  TreeShape shape;
  shape.crown_base = 2.0;
  shape.height = 8.6;
  shape.radius_profile = {0.9, 1.9, 2.5, 2.6, 2.4, 2.0, 1.5, 0.9, 0.2};
  shape.envelope_lumps = 0.35;
  shape.attractors = 2600;
  shape.step = 0.12;
  shape.kill = 0.3;
  shape.influence = 1.2;
  shape.leader_height = 4.5;
  shape.tropism = {0.0, 0.0, 0.25};
  shape.pipe_exponent = 2.25;
  shape.twig_radius = 0.0032;
  shape.trunk_flare = 0.35;
  shape.leaf_kind = LeafKind::ovate;
  shape.leaf_bearing_radius = 0.006;
  shape.shoots_per_node = 0.6;
  shape.shoot_length = 0.2;
  shape.leaves_per_shoot = 5;
  shape.leaf_length = 0.085;
  shape.leaf_width = 0.055;
  shape.leaf_droop = 0.6;
  shape.bark_albedo = {0.24f, 0.225f, 0.2f};
  shape.leaf_albedo = {0.085f, 0.14f, 0.028f};
  shape.leaf_transmission = {0.12f, 0.19f, 0.02f};
  return shape;
}

TreeShape conical_shape() {
  TreeShape shape;
  shape.crown_base = 0.7;
  shape.height = 10.0;
  shape.radius_profile = {2.5, 2.55, 2.35, 2.05, 1.75, 1.4, 1.05, 0.65, 0.08};
  shape.envelope_lumps = 0.22;
  shape.attractors = 4200;
  shape.step = 0.12;
  shape.kill = 0.26;
  shape.influence = 1.1;
  shape.leader_height = 9.7;
  shape.rind = 0.45;
  shape.tropism = {0.0, 0.0, -0.12};
  shape.wobble = 0.12;
  shape.pipe_exponent = 2.25;
  shape.twig_radius = 0.0035;
  shape.trunk_flare = 0.3;
  shape.leaf_kind = LeafKind::needle;
  shape.leaf_bearing_radius = 0.012;
  shape.shoots_per_node = 2.0;
  shape.shoot_length = 0.2;
  shape.leaves_per_shoot = 15;
  shape.leaf_length = 0.092;
  shape.leaf_width = 0.015;
  shape.leaf_droop = 0.1;
  shape.bark_albedo = {0.12f, 0.08f, 0.055f};
  shape.leaf_albedo = {0.05f, 0.095f, 0.042f};
  shape.leaf_transmission = {0.02f, 0.04f, 0.012f};
  return shape;
}

TreeShape preset_shape(const std::string& preset) {
  if (preset == "dense") return dense_shape();
  if (preset == "sparse") return sparse_shape();
  if (preset == "conical") return conical_shape();
  throw Error("phantom preset '" + preset + "' is unknown; choose dense, sparse or conical");
}

// Fewer, thicker and larger parts: branch spacing follows the cube root, leaf area the number.
void coarsen(TreeShape& shape, double detail) {
  const double spacing = std::cbrt(1.0 / detail), size = std::sqrt(1.0 / detail);
  shape.attractors = std::max(40, int(shape.attractors * detail));
  shape.step *= spacing;
  shape.kill *= spacing;
  shape.influence = std::max(shape.influence, 3.0 * shape.kill);
  shape.shoot_length *= spacing;
  shape.leaf_length *= size / std::sqrt(spacing);
  shape.leaf_width *= size / std::sqrt(spacing);
  shape.twig_radius *= spacing;
  shape.leaf_bearing_radius *= spacing;
}

void resize(TreeShape& shape, double factor) {
  for (double* length :
       {&shape.crown_base, &shape.height, &shape.step, &shape.influence, &shape.kill,
        &shape.leader_height, &shape.twig_radius, &shape.leaf_bearing_radius, &shape.shoot_length,
        &shape.leaf_length, &shape.leaf_width}) {
    *length *= factor;
  }
  for (double& radius : shape.radius_profile) radius *= factor;
}

}  // namespace

TreeShape tree_shape(const std::string& preset, double detail, double height) {
  TreeShape shape = preset_shape(preset);
  coarsen(shape, detail);
  if (height > 0.0) resize(shape, height / shape.height);
  return shape;
}

double envelope_radius(const TreeShape& shape, double z) {
  const double last = double(shape.radius_profile.size() - 1);
  const double t = (z - shape.crown_base) / (shape.height - shape.crown_base) * last;
  if (t < 0.0 || t > last) return 0.0;
  const auto below = std::min(std::size_t(t), shape.radius_profile.size() - 2);
  return glm::mix(shape.radius_profile[below], shape.radius_profile[below + 1], t - double(below));
}

}  // namespace bosk
