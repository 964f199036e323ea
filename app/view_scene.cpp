#include "app/view_scene.h"

#include <CLI/Error.hpp>
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

std::vector<TreeInstance> scattered(const SceneArguments& arguments, const SceneTrees& trees,
                                    Console& console) {
  std::vector<double> crowns;
  for (const auto& tree : trees) crowns.push_back(tree->crown_radius_m);
  if (arguments.scatter.trees == 0) return line_up(crowns);
  Image<float> density;
  if (!arguments.density.empty()) density = read_density(arguments.density, console.progress());
  return scatter_trees(crowns, density, arguments.scatter);
}

// The ground that trees of a table stand on: the one they were given, unless the table knows
// heights of its own. Then a plane through their feet.
Terrain ground_under(const std::vector<TreeInstance>& instances, const Terrain& terrain) {
  std::vector<glm::dvec3> feet;
  bool own_heights = false;
  for (const TreeInstance& instance : instances) {
    const glm::dvec3& place = instance.place;
    own_heights = own_heights || place.z != height_at(terrain, place.x, place.y);
    feet.push_back(place);
  }
  return own_heights ? plane_through(feet) : terrain;
}

}  // namespace

ForestScene make_scene(const SceneArguments& arguments, Console& console) {
  check(arguments);
  SceneTrees trees = load_trees(arguments.packages, console);
  Terrain terrain = terrain_of(arguments.scatter);
  std::vector<TreeInstance> instances;
  if (arguments.positions.empty()) {
    instances = scattered(arguments, trees, console);
    stand_on(terrain, instances);
  } else {
    std::vector<std::string> names;
    for (const auto& tree : trees) names.push_back(tree->name);
    instances = read_positions(arguments.positions, names, terrain);
    terrain = ground_under(instances, terrain);
  }
  return ForestScene(std::move(trees), std::move(instances), terrain);
}

}  // namespace bosk
