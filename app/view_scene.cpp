#include "app/view_scene.h"

#include <CLI/Error.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/system_error.h"
#include "core/package/reader.h"
#include "core/photo/decode.h"
#include "core/render/positions_csv.h"

namespace bosk {
namespace {

void check(const SceneArguments& arguments) {
  if (!arguments.positions.empty() && !arguments.density.empty()) {
    throw CLI::ValidationError(
        "--positions says where trees stand, so --density can't: leave one out");
  }
  if (!arguments.positions.empty() && arguments.scatter.trees > 0) {
    throw CLI::ValidationError("--positions says how many trees there are: leave --trees out");
  }
  if (!arguments.density.empty() && arguments.scatter.trees == 0) {
    throw CLI::ValidationError("--density thins a forest: say with --trees how many trees it has");
  }
}

SceneTrees load_trees(const std::vector<std::string>& packages, Console& console) {
  console.progress().begin("Reading trees", packages.size());
  SceneTrees trees;
  for (const std::string& package : packages) {
    trees.push_back(std::make_shared<const SceneTree>(
        std::filesystem::path(package).stem().string(), load_tree(package)));
    console.progress().advance();
  }
  return trees;
}

// Grey values as they are in the file, 0 to 1; colours count by their mean.
Image<float> read_density(const std::string& path, const Progress& progress) {
  const Image<glm::vec3> map = srgb_of(decode_photo(path, {}, progress));
  Image<float> density(map.width(), map.height());
  for (std::size_t i = 0; i < map.size(); ++i) {
    const glm::vec3& colour = map.pixels()[i];
    density.pixels()[i] = (colour.r + colour.g + colour.b) / 3.0f;
  }
  return density;
}

// Whether a table told heights other than those of the terrain that it was read with.
bool has_own_heights(const std::vector<TreeInstance>& instances, const Terrain& terrain) {
  return std::any_of(instances.begin(), instances.end(), [&](const TreeInstance& instance) {
    return instance.place.z != height_at(terrain, instance.place.x, instance.place.y);
  });
}

// A plane through the trees' feet.
Terrain ground_through(const std::vector<TreeInstance>& instances) {
  std::vector<glm::dvec3> feet;
  feet.reserve(instances.size());
  for (const TreeInstance& instance : instances) feet.push_back(instance.place);
  return plane_through(feet);
}

}  // namespace

ForestScene make_scene(const SceneArguments& arguments, Console& console) {
  check(arguments);
  SceneTrees trees = load_trees(arguments.packages, console);
  const Terrain hills = terrain_of(arguments.scatter);
  if (arguments.positions.empty()) {
    Image<float> density;
    if (!arguments.density.empty()) density = read_density(arguments.density, console.progress());
    std::vector<TreeInstance> instances = places_of(trees, density, arguments.scatter);
    return scene_on(hills, std::move(trees), std::move(instances));
  }
  std::vector<std::string> names;
  for (const auto& tree : trees) names.push_back(tree->name);
  std::vector<TreeInstance> instances = read_positions(arguments.positions, names, hills);
  if (!has_own_heights(instances, hills)) {
    return scene_on(hills, std::move(trees), std::move(instances));
  }
  const Terrain plane = ground_through(instances);
  return ForestScene(std::move(trees), std::move(instances), plane);
}

}  // namespace bosk
