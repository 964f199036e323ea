#include "core/billboard/visibility.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/billboard/morton.h"

namespace bosk {
namespace {

constexpr int kCoarseLevel = 6;  // of the copy that is marched through

// Mean extinction per metre of the coarse cells, dense.
struct CoarseVolume {
  int side = 1;
  glm::dvec3 origin{0.0};
  double cell_m = 1.0;
  std::vector<float> extinction;

  float at(const glm::dvec3& point) const {
    const glm::ivec3 c(glm::floor((point - origin) / cell_m));
    if (glm::any(glm::lessThan(c, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(c, glm::ivec3(side)))) {
      return 0.0f;
    }
    return extinction[(std::size_t(c.z) * std::size_t(side) + std::size_t(c.y)) *
                          std::size_t(side) +
                      std::size_t(c.x)];
  }
};

CoarseVolume coarsened(const RadianceVolume& volume) {
  const int shift = std::max(0, volume.grid.level() - kCoarseLevel);
  CoarseVolume coarse;
  coarse.side = volume.grid.side() >> shift;
  coarse.origin = volume.origin;
  coarse.cell_m = volume.size_m / coarse.side;
  const auto side = std::size_t(coarse.side);
  coarse.extinction.assign(side * side * side, 0.0f);
  const double per_metre = 1.0 / (volume.cell_m() * double(std::size_t(1) << (3 * shift)));
  for (std::size_t i = 0; i < volume.grid.size(); ++i) {
    const glm::ivec3 c = glm::ivec3(volume.grid.cells()[i]) >> shift;
    coarse.extinction[(std::size_t(c.z) * side + std::size_t(c.y)) * side + std::size_t(c.x)] +=
        float(double(volume.extinction[i]) * per_metre);
  }
  return coarse;
}

float transmittance(const CoarseVolume& coarse, const glm::dvec3& from, const glm::dvec3& eye) {
  const glm::dvec3 to_eye = glm::normalize(eye - from);
  double depth = 0.0;
  for (double s = 1.5; s < 2.0 * coarse.side && depth < 6.0; s += 1.0) {
    const glm::dvec3 point = from + to_eye * (s * coarse.cell_m);
    const glm::dvec3 inside = (point - coarse.origin) / coarse.cell_m;
    const double side = coarse.side;
    if (glm::any(glm::lessThan(inside, glm::dvec3(0.0))) ||
        glm::any(glm::greaterThan(inside, glm::dvec3(side)))) {
      break;
    }
    depth += double(coarse.at(point)) * coarse.cell_m;
  }
  return float(std::exp(-depth));
}

}  // namespace

std::vector<float> transmittance_to_views(const RadianceVolume& volume, int level,
                                          const std::vector<std::uint64_t>& cells,
                                          const std::vector<glm::dvec3>& views,
                                          Progress& progress) {
  const CoarseVolume coarse = coarsened(volume);
  const double cell_m = volume.size_m / double(1 << level);
  std::vector<float> result(cells.size() * views.size());
  progress.begin("Finding what hides what", cells.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const glm::dvec3 centre =
          volume.origin + (glm::dvec3(cell_from_morton(cells[i])) + 0.5) * cell_m;
      for (std::size_t v = 0; v < views.size(); ++v) {
        result[i * views.size() + v] = transmittance(coarse, centre, views[v]);
      }
    }
    progress.advance(range.size());
  });
  return result;
}

}  // namespace bosk
