#include "core/phantom/density.h"

#include <algorithm>
#include <cmath>

namespace bosk {
namespace {

Box cube_round(const std::vector<glm::vec3>& points) {
  glm::dvec3 lower(1e30), upper(-1e30);
  for (const glm::vec3& point : points) {
    lower = glm::min(lower, glm::dvec3(point));
    upper = glm::max(upper, glm::dvec3(point));
  }
  const glm::dvec3 size = upper - lower, centre = 0.5 * (lower + upper);
  const double half = 0.51 * std::max({size.x, size.y, size.z});
  return {centre - half, centre + half};
}

// Adds the area of one triangle, cut into n x n similar ones.
void add_triangle(const Tree& tree, std::size_t triangle, TreeDensity& density,
                  std::vector<double>& areas) {
  const glm::uvec3 t = tree.triangles[triangle];
  const glm::dvec3 a(tree.vertices[t.x]);
  const glm::dvec3 ab = glm::dvec3(tree.vertices[t.y]) - a, ac = glm::dvec3(tree.vertices[t.z]) - a;
  const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ab - ac)});
  const int n = std::max(1, int(std::ceil(4.0 * longest / density.voxel_m())));
  const double piece = 0.5 * glm::length(glm::cross(ab, ac)) / (double(n) * n);
  const auto add = [&](double u, double v) {
    const glm::dvec3 at = (a + u * ab + v * ac - density.box.lower) / density.voxel_m();
    const glm::ivec3 voxel = glm::clamp(glm::ivec3(at), 0, density.side - 1);
    areas[density.index(voxel.x, voxel.y, voxel.z)] += piece;
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      add((i + 1.0 / 3.0) / n, (j + 1.0 / 3.0) / n);
      if (i + j + 1 < n) add((i + 2.0 / 3.0) / n, (j + 2.0 / 3.0) / n);
    }
  }
}

}  // namespace

TreeDensity measure_density(const Tree& tree, int side) {
  TreeDensity density;
  density.box = cube_round(tree.vertices);
  density.side = side;
  const std::size_t voxels = std::size_t(side) * std::size_t(side) * std::size_t(side);
  std::vector<double> leaf(voxels, 0.0), wood(voxels, 0.0);
  for (std::size_t i = 0; i < tree.triangles.size(); ++i) {
    add_triangle(tree, i, density, tree.is_wood(i) ? wood : leaf);
  }
  const double volume = std::pow(density.voxel_m(), 3.0);
  const auto per_volume = [&](const std::vector<double>& areas) {
    std::vector<float> result(voxels);
    std::transform(areas.begin(), areas.end(), result.begin(),
                   [&](double area) { return float(area / volume); });
    return result;
  };
  density.leaf_area = per_volume(leaf);
  density.wood_area = per_volume(wood);
  return density;
}

}  // namespace bosk
