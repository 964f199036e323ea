#include "ui/forest_scene.h"

#include <algorithm>
#include <cmath>

#include "core/render/scatter.h"

namespace bosk {
namespace {

std::vector<std::shared_ptr<const PreparedTree>> prepared_of(const SceneTrees& trees) {
  std::vector<std::shared_ptr<const PreparedTree>> prepared;
  for (const auto& tree : trees) prepared.emplace_back(tree, &tree->prepared);
  return prepared;
}

}  // namespace

SceneTree::SceneTree(std::string tree_name, TreeModel tree_model)
    : name(std::move(tree_name)),
      model(std::move(tree_model)),
      prepared(model),
      crown_radius_m(crown_radius(model)) {}

ForestScene::ForestScene(SceneTrees scene_trees, std::vector<TreeInstance> instances,
                         Terrain ground)
    : trees(std::move(scene_trees)),
      terrain(ground),
      forest(prepared_of(trees), std::move(instances)) {
  // Enclose feet, crowns and tops
  glm::dvec3 low(INFINITY), high(-INFINITY);
  for (const TreeInstance& instance : forest.instances()) {
    const SceneTree& tree = *trees[instance.tree];
    const double reach = instance.scale * tree.crown_radius_m;
    const double top = instance.scale * tree.model.metadata.height_m;
    low = glm::min(low, instance.place - glm::dvec3(reach, reach, 0.0));
    high = glm::max(high, instance.place + glm::dvec3(reach, reach, top));
  }
  if (forest.instances().empty()) low = high = glm::dvec3(0.0);
  middle = {0.5 * (low.x + high.x), 0.5 * (low.y + high.y), low.z};
  radius_m = 0.5 * std::max(high.x - low.x, high.y - low.y);
  height_m = high.z - low.z;
}

double ground_reach(const ForestScene& scene) {
  return std::clamp(4.0 * scene.radius_m, 600.0, 20000.0) + 2.0 * scene.radius_m;
}

Image<glm::vec3> ground_grid(const ForestScene& scene) {
  constexpr double kStep = 1.5;  // metres: fine enough that trunks stand on it within a few cm
  constexpr int kMost = 600;
  const double reach = ground_reach(scene);
  const bool is_plane = scene.terrain.relief_m == 0.0;
  const int points = is_plane ? 2 : std::clamp(int(2.0 * reach / kStep), 64, kMost);
  Image<glm::vec3> grid(points, points);
  for (int row = 0; row < points; ++row) {
    for (int column = 0; column < points; ++column) {
      const glm::dvec2 share = glm::dvec2(column, row) / double(points - 1) - 0.5;
      const double x = scene.middle.x + 2.0 * reach * share.x;
      const double y = scene.middle.y - 2.0 * reach * share.y;
      grid(column, row) = glm::vec3(x, y, height_at(scene.terrain, x, y));
    }
  }
  return grid;
}

ViewCamera framing(const ForestScene& scene, const glm::ivec2& size_px, double view_angle) {
  const double slope = std::tan(0.5 * view_angle);
  const double aspect = double(size_px.x) / double(std::max(1, size_px.y));
  const double height = std::max(scene.height_m, 0.1), radius = std::max(scene.radius_m, 0.05);
  const double back =
      1.1 * std::max(0.5 * height / slope, radius / (slope * aspect)) + 0.5 * radius;
  if (scene.forest.instances().size() <= scene.trees.size()) {
    const glm::dvec3 at = scene.middle + glm::dvec3(0.0, 0.0, 0.5 * height);
    const double eye_height =
        std::max(kClearance, std::min(0.5 * height, std::max(kEyeHeight, 0.2 * height)));
    return looking_at(ViewCamera{}, scene.middle + glm::dvec3(0.0, -back, eye_height), at);
  }
  const glm::dvec3 at = scene.middle + glm::dvec3(0.0, 0.0, 0.3 * height);
  const glm::dvec3 eye(scene.middle.x, scene.middle.y - radius - 1.5 * height,
                       scene.middle.z + 1.1 * height + 0.1 * radius);
  return looking_at(ViewCamera{}, eye, at);
}

}  // namespace bosk
