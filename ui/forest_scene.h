#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/render/forest.h"
#include "core/render/scatter.h"
#include "core/render/terrain.h"
#include "ui/camera_controls.h"

namespace bosk {

// A package made ready for drawing. A tree whose foot is far from its origin is moved there.
struct SceneTree {
  SceneTree(std::string tree_name, TreeModel tree_model);
  SceneTree(const SceneTree&) = delete;
  SceneTree& operator=(const SceneTree&) = delete;

  std::string name;
  TreeModel model;
  PreparedTree prepared;
  double crown_radius_m = 0.0;
};
using SceneTrees = std::vector<std::shared_ptr<const SceneTree>>;

// All that a viewer shows: trees where they stand, on the ground.
struct ForestScene {
  ForestScene(SceneTrees scene_trees, std::vector<TreeInstance> instances, Terrain ground);

  SceneTrees trees;
  Terrain terrain;
  Forest forest;
  // An upright cylinder that holds the forest, about.
  glm::dvec3 middle{0.0};  // of its foot
  double radius_m = 0.0, height_m = 0.0;
};

// The ground is drawn as a square grid of points. A forest's is coarser the wider it is.
struct GroundGrid {
  double reach_m = 0.0;  // from the scene's middle to its edges
  double step_m = 0.0;   // from point to point
};
// For a scene within `radius_m` of its middle.
GroundGrid ground_grid(const Terrain& terrain, double radius_m);
// The terrain without what such a grid cannot show, so that trunks stand on the ground that is
// drawn.
Terrain drawn_terrain(const Terrain& terrain, double radius_m);

// Places for the trees: in a row, or scattered (core/render/scatter.h), as `options.trees` says.
std::vector<TreeInstance> places_of(const SceneTrees& trees, const Image<float>& density,
                                    const ScatterOptions& options);
// The trees put on the hills, as far as those can be drawn.
ForestScene scene_on(const Terrain& hills, SceneTrees trees, std::vector<TreeInstance> instances);

// Rows from north to south, columns from west to east.
Image<glm::vec3> ground_points(const ForestScene& scene);

// Outside the scene, from the south: all of a tree, or of a row, from about a person's height; a
// forest from above its crowns, all of it where it isn't wide.
ViewCamera framing(const ForestScene& scene, const glm::ivec2& size_px, double view_angle);

}  // namespace bosk
