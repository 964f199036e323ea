#include "ui/view_marks.h"

#include <algorithm>
#include <cmath>

namespace bosk {
namespace {

const TreeInstance* nearest_instance(const ForestScene& scene, const glm::dvec3& target) {
  const TreeInstance* nearest = nullptr;
  double least = INFINITY;
  for (const TreeInstance& instance : scene.forest.instances()) {
    const double distance = glm::distance(glm::dvec2(instance.place), glm::dvec2(target));
    if (distance >= least) continue;
    least = distance;
    nearest = &instance;
  }
  return nearest;
}

// Positions of the two views nearest in angle to the eye.
std::pair<std::size_t, std::size_t> mixed_views(const TreeModel& tree, const glm::dvec3& eye) {
  const glm::dvec3 middle = tree.origin + 0.5 * tree.size_m;
  const glm::dvec3 to_eye = glm::normalize(eye - middle);
  std::size_t first = SIZE_MAX, second = SIZE_MAX;
  double highest = -2.0, next = -2.0;
  for (std::size_t i = 0; i < tree.view_positions.size(); ++i) {
    const double cosine = glm::dot(to_eye, glm::normalize(tree.view_positions[i] - middle));
    if (cosine > highest) {
      next = highest;
      second = first;
      highest = cosine;
      first = i;
    } else if (cosine > next) {
      next = cosine;
      second = i;
    }
  }
  return {first, second};
}

bool is_in_picture(const glm::dvec2& pixel, const Lens& lens) {
  return pixel.x >= -0.5 && pixel.y >= -0.5 && pixel.x <= lens.width_px - 0.5 &&
         pixel.y <= lens.height_px - 0.5;
}

void paint_dot(Image<glm::u8vec3>& picture, const ViewMark& mark) {
  const glm::u8vec3 colour = mark.is_mixed ? kMixedMarkColour : kMarkColour;
  const auto low = [](double at) { return std::max(0, int(std::floor(at - kMarkRadius))); };
  const auto high = [](double at, int size) {
    return std::min(size - 1, int(std::ceil(at + kMarkRadius)));
  };
  for (int y = low(mark.pixel.y); y <= high(mark.pixel.y, picture.height()); ++y) {
    for (int x = low(mark.pixel.x); x <= high(mark.pixel.x, picture.width()); ++x) {
      if (glm::distance(glm::dvec2(x, y), mark.pixel) <= kMarkRadius) picture(x, y) = colour;
    }
  }
}

}  // namespace

std::vector<ViewMark> view_marks(const ForestScene& scene, const Camera& camera,
                                 const glm::dvec3& target) {
  const TreeInstance* instance = nearest_instance(scene, target);
  if (!instance) return {};
  const TreeModel& tree = scene.trees[instance->tree]->model;
  const auto [first, second] =
      mixed_views(tree, tree_from_world(*instance, camera.centre_in_world()));
  std::vector<ViewMark> marks;
  for (std::size_t i = 0; i < tree.view_positions.size(); ++i) {
    const auto pixel = project(camera, world_from_tree(*instance, tree.view_positions[i]));
    if (pixel && is_in_picture(*pixel, camera.lens)) {
      marks.push_back({*pixel, i == first || i == second});
    }
  }
  return marks;
}

void paint_marks(Image<glm::u8vec3>& picture, const std::vector<ViewMark>& marks) {
  for (const ViewMark& mark : marks) paint_dot(picture, mark);
}

}  // namespace bosk
