#include "core/phantom/density.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/phantom/phantom.h"

namespace bosk {
namespace {

TEST(MeasureDensity, KeepsTheAreaOfLeavesAndWood) {
  Progress progress;
  const Tree tree = grow_tree(tree_shape("sparse", 0.05, 3.0), 1, progress);
  double leaf = 0.0, wood = 0.0;
  for (std::size_t i = 0; i < tree.triangles.size(); ++i) {
    const glm::uvec3 t = tree.triangles[i];
    const glm::dvec3 a(tree.vertices[t.x]), b(tree.vertices[t.y]), c(tree.vertices[t.z]);
    (tree.is_wood(i) ? wood : leaf) += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  const TreeDensity density = measure_density(tree, 24);
  const double volume = std::pow(density.voxel_m(), 3.0);
  const auto total = [&](const std::vector<float>& values) {
    return volume * std::accumulate(values.begin(), values.end(), 0.0);
  };
  EXPECT_NEAR(total(density.leaf_area) / leaf, 1.0, 1e-5);  // sums of floats
  EXPECT_NEAR(total(density.wood_area) / wood, 1.0, 1e-5);
}

double depth_along(const TreeDensity& density, const Ray& ray) {
  const auto span = intersect(ray, density.box);
  if (!span) return 0.0;
  const double step = 0.5 * density.voxel_m();
  double depth = 0.0;
  for (double at = span->enter + 0.5 * step; at < span->leave; at += step) {
    const glm::dvec3 point = ray.origin + at * ray.direction;
    const glm::ivec3 voxel = glm::clamp(glm::ivec3((point - density.box.lower) / density.voxel_m()),
                                        0, density.side - 1);
    depth += step * double(density.extinction(density.index(voxel.x, voxel.y, voxel.z)));
  }
  return depth;
}

// Volume and pictures must tell of the same tree in the same frame.
TEST(MeasureDensity, SeenAsAMediumLooksLikeTheMattes) {
  Progress progress;
  const Phantom phantom = make_phantom(tiny_phantom(), progress);
  double sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0, n = 0;
  for (const PhantomView& view : phantom.photos) {
    for (int y = 4; y < view.matte.height(); y += 8) {
      for (int x = 4; x < view.matte.width(); x += 8) {
        double medium = 0.0, alpha = 0.0;
        for (int v = -4; v < 4; ++v) {
          for (int u = -4; u < 4; ++u) {
            const auto ray = world_ray(view.camera, glm::dvec2(x + u, y + v));
            medium += 1.0 - std::exp(-depth_along(phantom.density, *ray));
            alpha += view.matte(x + u, y + v).a / 255.0;
          }
        }
        sx += medium, sy += alpha, sxx += medium * medium, syy += alpha * alpha;
        sxy += medium * alpha, n += 1.0;
      }
    }
  }
  const double correlation =
      (n * sxy - sx * sy) / std::sqrt((n * sxx - sx * sx) * (n * syy - sy * sy));
  // A voxel smears its leaves over its width, so they never agree fully; a shift by a voxel or a
  // flipped axis lands below 0.9.
  EXPECT_GT(correlation, 0.95);
  EXPECT_NEAR(sx / sy, 1.0, 0.2);
}

}  // namespace
}  // namespace bosk
