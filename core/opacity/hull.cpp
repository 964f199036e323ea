#include "core/opacity/hull.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include "core/base/error.h"

namespace bosk {
namespace {

constexpr double kUnexplained = 0.03;  // of the silhouettes' pixels that a stricter hull may lose
constexpr int kCoarseLevel = 6;        // of the carving that finds the crown
constexpr double kMarginCells = 1.0;   // kept free around the crown, cells of kCoarseLevel

// The point with the least sum of squared distances to the cameras' rays through their silhouettes.
glm::dvec3 meeting_point(const std::vector<Silhouette>& silhouettes) {
  glm::dmat3 normal(0.0);
  glm::dvec3 right_side(0.0);
  for (const Silhouette& silhouette : silhouettes) {
    const glm::dvec3 centre = silhouette.camera().centre_in_world();
    const glm::dvec3 axis =
        glm::transpose(silhouette.camera().camera_from_world.rotation) * glm::dvec3(0, 0, 1);
    const glm::dmat3 across = glm::dmat3(1.0) - glm::outerProduct(axis, axis);
    normal += across;
    right_side += across * centre;
  }
  normal += glm::dmat3(1e-9 * double(silhouettes.size()));  // parallel axes: a point on them
  return glm::inverse(normal) * right_side;
}

double farthest_camera(const std::vector<Silhouette>& silhouettes, const glm::dvec3& point) {
  double farthest = 0.0;
  for (const Silhouette& silhouette : silhouettes) {
    farthest = std::max(farthest, glm::length(silhouette.camera().centre_in_world() - point));
  }
  return farthest;
}

Cube around(const std::vector<glm::ivec3>& cells, const Cube& cube, int level) {
  glm::ivec3 lower = cells.front(), upper = cells.front();
  for (const glm::ivec3& cell : cells) {
    lower = glm::min(lower, cell);
    upper = glm::max(upper, cell);
  }
  const double cell_m = cube.size_m / double(1 << level);
  const glm::dvec3 from = cube.origin + (glm::dvec3(lower) - kMarginCells) * cell_m;
  const glm::dvec3 to = cube.origin + (glm::dvec3(upper) + 1.0 + kMarginCells) * cell_m;
  const glm::dvec3 extent = to - from;
  const double edge = std::max({extent.x, extent.y, extent.z});
  return {0.5 * (from + to) - 0.5 * edge, edge};
}

glm::ivec3 child_cell(const glm::ivec3& parent, int child) {
  return parent * 2 + glm::ivec3(child & 1, child >> 1 & 1, child >> 2);
}

// Whether no photo sees the cube empty and at least `needed` see it whole.
bool keep(const std::vector<Silhouette>& silhouettes, const glm::dvec3& lower, double edge_m,
          std::size_t needed) {
  std::size_t seen = 0;
  for (const Silhouette& silhouette : silhouettes) {
    const Silhouette::Verdict verdict = silhouette.look_at(lower, edge_m);
    if (verdict == Silhouette::Verdict::empty) return false;
    if (verdict == Silhouette::Verdict::occupied) ++seen;
  }
  return seen >= needed;
}

// Children at `level` of the given cells that are kept.
std::vector<glm::ivec3> carve_once(const std::vector<Silhouette>& silhouettes, const Cube& cube,
                                   const std::vector<glm::ivec3>& parents, int level,
                                   std::size_t needed, Progress& progress) {
  const double edge = cube.size_m / double(1 << level);
  std::vector<std::uint8_t> kept(parents.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parents.size(), 64), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      progress.check();
      for (int child = 0; child < 8; ++child) {
        const glm::dvec3 lower = cube.origin + glm::dvec3(child_cell(parents[i], child)) * edge;
        if (keep(silhouettes, lower, edge, needed)) kept[i] |= std::uint8_t(1 << child);
      }
    }
    progress.advance(range.size());
  });
  std::vector<glm::ivec3> children;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    for (int child = 0; child < 8; ++child) {
      if ((kept[i] >> child & 1) != 0) children.push_back(child_cell(parents[i], child));
    }
  }
  return children;
}

std::vector<glm::ivec3> carve(const std::vector<Silhouette>& silhouettes, const Cube& cube,
                              int level, std::size_t needed, Progress& progress) {
  std::vector<glm::ivec3> cells{glm::ivec3(0)};
  for (int at = 1; at <= level && !cells.empty(); ++at) {
    progress.begin("Carving the crown's hull", cells.size(), double(at - 1) / level,
                   double(at) / level);
    cells = carve_once(silhouettes, cube, cells, at, at == level ? needed : 0, progress);
  }
  return cells;
}

// Share of all photos' silhouette pixels that no cell's footprint covers.
double unexplained(const std::vector<Silhouette>& silhouettes, const Cube& cube, int level,
                   const std::vector<glm::ivec3>& cells) {
  const double edge = cube.size_m / double(1 << level);
  std::vector<std::size_t> missed(silhouettes.size());
  std::size_t all = 0;
  for (const Silhouette& silhouette : silhouettes) all += silhouette.pixels_above();
  tbb::parallel_for(std::size_t(0), silhouettes.size(), [&](std::size_t i) {
    Image<std::uint8_t> covered(silhouettes[i].width(), silhouettes[i].height());
    for (const glm::ivec3& cell : cells) {
      const glm::dvec3 lower = cube.origin + glm::dvec3(cell) * edge;
      const auto rectangle = silhouettes[i].footprint(lower, edge);
      if (!rectangle) continue;
      for (int y = std::max(rectangle->y0, 0); y < std::min(rectangle->y1, covered.height()); ++y) {
        for (int x = std::max(rectangle->x0, 0); x < std::min(rectangle->x1, covered.width());
             ++x) {
          covered(x, y) = 1;
        }
      }
    }
    for (int y = 0; y < covered.height(); ++y) {
      for (int x = 0; x < covered.width(); ++x) {
        if (covered(x, y) == 0 && silhouettes[i].count({x, y, x + 1, y + 1}) > 0) ++missed[i];
      }
    }
  });
  return double(std::accumulate(missed.begin(), missed.end(), std::size_t(0))) / double(all);
}

}  // namespace

Silhouette::Silhouette(const Camera& pinhole, const Image<glm::vec4>& matte, float alpha_threshold)
    : camera_(pinhole), sums_(matte.width() + 1, matte.height() + 1) {
  for (int y = 0; y < matte.height(); ++y) {
    std::uint32_t row = 0;
    for (int x = 0; x < matte.width(); ++x) {
      row += matte(x, y).a > alpha_threshold ? 1u : 0u;
      sums_(x + 1, y + 1) = sums_(x + 1, y) + row;
    }
  }
}

std::optional<Silhouette::Rectangle> Silhouette::footprint(const glm::dvec3& lower_in_world,
                                                           double edge_m) const {
  const RigidTransform& pose = camera_.camera_from_world;
  const glm::dvec3 corner = pose * lower_in_world;
  glm::dvec2 least(1e300), most(-1e300);
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 p = corner + edge_m * (double(i & 1) * pose.rotation[0] +
                                            double(i >> 1 & 1) * pose.rotation[1] +
                                            double(i >> 2) * pose.rotation[2]);
    if (p.z <= 1e-9) return std::nullopt;
    const glm::dvec2 pixel =
        camera_.lens.focal_px * glm::dvec2(p) / p.z + camera_.lens.principal_px;
    least = glm::min(least, pixel);
    most = glm::max(most, pixel);
  }
  least = glm::clamp(glm::floor(least + 0.5), -1e6, 1e6);
  most = glm::clamp(glm::floor(most + 0.5), -1e6, 1e6);
  return Rectangle{int(least.x), int(least.y), int(most.x) + 1, int(most.y) + 1};
}

Silhouette::Verdict Silhouette::look_at(const glm::dvec3& lower_in_world, double edge_m) const {
  if (const auto verdict = glance_at(lower_in_world, edge_m)) return *verdict;
  const std::optional<Rectangle> seen = footprint(lower_in_world, edge_m);
  if (!seen || !holds(*seen)) return Verdict::unseen;
  return count(*seen) == 0 ? Verdict::empty : Verdict::occupied;
}

// A corner at c + d, |d| <= r, is seen at most r (1 + |x / z|) / (z - r) from the centre c = (x, y,
// z), in focal lengths: (x + dx) / (z + dz) - x / z = (dx - x / z dz) / (z + dz).
std::optional<Silhouette::Verdict> Silhouette::glance_at(const glm::dvec3& lower_in_world,
                                                         double edge_m) const {
  const glm::dvec3 centre = camera_.camera_from_world * (lower_in_world + 0.5 * edge_m);
  const double radius = 0.8661 * edge_m;
  if (!(centre.z - radius > 1e-9)) return std::nullopt;
  const glm::dvec2 seen = glm::dvec2(centre) / centre.z;
  const glm::dvec2 pixel = camera_.lens.focal_px * seen + camera_.lens.principal_px + 0.5;
  const glm::dvec2 reach =
      camera_.lens.focal_px * (1.0 + glm::abs(seen)) * (radius / (centre.z - radius));
  const glm::dvec2 low = pixel - reach, high = pixel + reach;
  if (!(low.x >= 0.0 && low.y >= 0.0 && high.x < width() - 1.0 && high.y < height() - 1.0))
    return std::nullopt;
  if (count({int(low.x), int(low.y), int(high.x) + 1, int(high.y) + 1}) == 0) return Verdict::empty;
  const int x = int(pixel.x), y = int(pixel.y);
  if (count({x, y, x + 1, y + 1}) > 0) return Verdict::occupied;
  return std::nullopt;
}

std::vector<glm::ivec3> carve_hull(const std::vector<Silhouette>& silhouettes, const Cube& cube,
                                   int level, Progress& progress) {
  constexpr std::array<double, 3> kShares{0.34, 0.5, 0.75};  // of the photos that see a cell whole
  const int coarse = std::min(level, kCoarseLevel);
  std::size_t needed = 2;
  double least_unexplained = 1.0;
  for (const double share : kShares) {
    const auto stricter =
        std::max<std::size_t>(2, std::size_t(std::ceil(share * double(silhouettes.size()))));
    const double missed = unexplained(silhouettes, cube, coarse,
                                      carve(silhouettes, cube, coarse, stricter, progress));
    if (share == kShares.front()) least_unexplained = missed;
    if (missed > least_unexplained + kUnexplained) break;
    needed = stricter;
  }
  return carve(silhouettes, cube, level, needed, progress);
}

std::vector<glm::ivec3> carve_children(const std::vector<Silhouette>& silhouettes, const Cube& cube,
                                       const std::vector<glm::ivec3>& parents, int level,
                                       Progress& progress) {
  progress.begin("Carving finer cells", parents.size());
  return carve_once(silhouettes, cube, parents, level, 0, progress);
}

Cube find_crown(const std::vector<Silhouette>& silhouettes, Progress& progress) {
  const glm::dvec3 centre = meeting_point(silhouettes);
  const double reach = farthest_camera(silhouettes, centre);
  Cube cube{centre - reach, 2.0 * reach};
  for (int round = 0; round < 6; ++round) {
    const std::vector<glm::ivec3> cells = carve_hull(silhouettes, cube, kCoarseLevel, progress);
    if (cells.empty()) {
      throw Error(
          "the mattes have no volume in common: check that cameras and photos belong together (a "
          "mixed-up name, a flipped axis) and that no matte is clear");
    }
    const Cube tighter = around(cells, cube, kCoarseLevel);
    const bool settled = tighter.size_m > 0.97 * cube.size_m;
    cube = tighter;
    if (settled) break;
  }
  return cube;
}

}  // namespace bosk
