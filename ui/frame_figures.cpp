#include "ui/frame_figures.h"

#include <algorithm>
#include <cmath>

#include "core/render/billboard_geometry.h"
#include "core/render/reference.h"

namespace bosk {
namespace {

// Of the instance's billboards at that level, in pixels.
double side_px(const TreeInstance& instance, const TreeModel& tree, const TreeLevel& level,
               const Viewpoint& viewpoint) {
  const glm::dvec3 middle = world_from_tree(instance, tree.origin + 0.5 * tree.size_m);
  const double size = instance.scale * double(level.side_factor) * cell_size_m(tree, level.level);
  const double depth = glm::dot(middle - viewpoint.eye, viewpoint.forward);
  return viewpoint.focal_px * size / std::max(depth, 0.5 * instance.scale * tree.size_m);
}

}  // namespace

double overdraw_estimate(const Forest& forest, const ForestDrawList& list, const Camera& camera) {
  const Viewpoint viewpoint = viewpoint_of(camera);
  double area_px = 0.0;
  for (const DrawRange& range : list.ranges) {
    if (range.high != 0) continue;  // a divided range names its cells in each of its parts
    const TreeInstance& instance = forest.instances()[range.instance];
    const PreparedTree& tree = *forest.trees()[instance.tree];
    const TreeLevel& level = tree.level_of_cut(range.cut);
    const double side = side_px(instance, tree.model(), level, viewpoint);
    area_px += double(range.count) * side * side;
  }
  const double picture_px = double(camera.lens.width_px) * double(camera.lens.height_px);
  return picture_px > 0.0 ? area_px / picture_px : 0.0;
}

double half_angle_of(const Camera& camera) {
  const glm::dvec2 size(camera.lens.width_px, camera.lens.height_px);
  const glm::dvec2 farthest =
      glm::max(camera.lens.principal_px + 0.5, size - 0.5 - camera.lens.principal_px);
  return std::atan(glm::length(farthest / camera.lens.focal_px));
}

}  // namespace bosk
