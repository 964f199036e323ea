#include "ui/forest_scene.h"

#include <algorithm>
#include <cmath>

#include "core/render/billboard_geometry.h"

namespace bosk {
namespace {

std::vector<std::shared_ptr<const PreparedTree>> prepared_of(const SceneTrees& trees) {
  std::vector<std::shared_ptr<const PreparedTree>> prepared;
  for (const auto& tree : trees) prepared.emplace_back(tree, &tree->prepared);
  return prepared;
}

// Centres of the finest cells, world frame.
std::vector<glm::dvec3> finest_centres(const TreeModel& model) {
  std::vector<glm::dvec3> centres;
  if (model.levels.empty()) return centres;
  const TreeLevel& finest = model.levels.back();
  centres.reserve(finest.cells.size());
  for (const std::uint64_t code : finest.cells)
    centres.push_back(cell_centre_in_world(model, finest.level, code));
  return centres;
}

// Cameras from elsewhere may have an origin far from the tree. Then the tree is moved: the middle
// of its lowest twentieth to the origin.
TreeModel on_its_foot(TreeModel model) {
  const std::vector<glm::dvec3> centres = finest_centres(model);
  if (centres.empty()) return model;
  glm::dvec3 low = centres.front(), high = low;
  for (const glm::dvec3& centre : centres) {
    low = glm::min(low, centre);
    high = glm::max(high, centre);
  }
  const double height = high.z - low.z;
  const bool stands = low.x <= 0.0 && low.y <= 0.0 && high.x >= 0.0 && high.y >= 0.0 &&
                      std::abs(low.z) <= 0.25 * height;
  if (stands) return model;
  glm::dvec3 sum(0.0);
  double count = 0.0;
  for (const glm::dvec3& centre : centres) {
    if (centre.z > low.z + 0.05 * height) continue;
    sum += centre;
    count += 1.0;
  }
  const glm::dvec3 foot(sum.x / count, sum.y / count, low.z);
  model.origin -= foot;
  for (glm::dvec3& view : model.view_positions) view -= foot;
  model.metadata.height_m -= foot.z;
  return model;
}

double radius_of(const std::vector<TreeInstance>& instances) {
  glm::dvec2 low(INFINITY), high(-INFINITY);
  for (const TreeInstance& instance : instances) {
    low = glm::min(low, glm::dvec2(instance.place));
    high = glm::max(high, glm::dvec2(instance.place));
  }
  return instances.empty() ? 0.0 : 0.5 * std::max(high.x - low.x, high.y - low.y);
}

}  // namespace

SceneTree::SceneTree(std::string tree_name, TreeModel tree_model)
    : name(std::move(tree_name)),
      model(on_its_foot(std::move(tree_model))),
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

GroundGrid ground_grid(const Terrain& terrain, double radius_m) {
  constexpr double kFinestStep = 1.5, kMostSteps = 800.0;
  const bool is_plane = terrain.relief_m == 0.0;
  GroundGrid grid;
  grid.reach_m = radius_m + std::max(is_plane ? 3000.0 : 1000.0, 0.5 * radius_m);
  grid.step_m = std::max(kFinestStep, 2.0 * grid.reach_m / kMostSteps);
  if (is_plane) grid.step_m = 2.0 * grid.reach_m;
  return grid;
}

Terrain drawn_terrain(const Terrain& terrain, double radius_m) {
  constexpr double kStepsOfAHill = 4.0;
  Terrain drawn = terrain;
  drawn.finest_m = kStepsOfAHill * ground_grid(terrain, radius_m).step_m;
  return drawn;
}

std::vector<TreeInstance> places_of(const SceneTrees& trees, const Image<float>& density,
                                    const ScatterOptions& options) {
  std::vector<double> crowns;
  for (const auto& tree : trees) crowns.push_back(tree->crown_radius_m);
  return options.trees == 0 ? line_up(crowns) : scatter_trees(crowns, density, options);
}

ForestScene scene_on(const Terrain& hills, SceneTrees trees, std::vector<TreeInstance> instances) {
  const Terrain terrain = drawn_terrain(hills, radius_of(instances));
  stand_on(terrain, instances);
  return ForestScene(std::move(trees), std::move(instances), terrain);
}

Image<glm::vec3> ground_points(const ForestScene& scene) {
  const GroundGrid grid = ground_grid(scene.terrain, scene.radius_m);
  const int points = 1 + int(std::lround(2.0 * grid.reach_m / grid.step_m));
  Image<glm::vec3> ground(points, points);
  for (int row = 0; row < points; ++row) {
    for (int column = 0; column < points; ++column) {
      const glm::dvec2 share = glm::dvec2(column, row) / double(points - 1) - 0.5;
      const double x = scene.middle.x + 2.0 * grid.reach_m * share.x;
      const double y = scene.middle.y - 2.0 * grid.reach_m * share.y;
      ground(column, row) = glm::vec3(x, y, height_at(scene.terrain, x, y));
    }
  }
  return ground;
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
  const double clear = std::clamp(radius / (slope * aspect), 1.5 * height, 3.5 * height);
  const glm::dvec3 eye =
      scene.middle + glm::dvec3(0.0, -radius - clear, 1.1 * height + 0.1 * radius);
  return looking_at(ViewCamera{}, eye, at);
}

}  // namespace bosk
