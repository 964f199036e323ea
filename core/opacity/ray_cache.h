#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/matte/matte.h"
#include "core/opacity/hull.h"
#include "core/opacity/sparse_grid.h"
#include "core/photo/photo.h"

namespace bosk {

// The cells between whose centres the volume is interpolated: for each base cell b with any present
// corner b + {0,1}^3, the numbers of its eight corners (x fastest); absent corners have the number
// `grid.size()`, a cell that is always empty.
class TrilinearSupport {
 public:
  explicit TrilinearSupport(const SparseGrid& grid);

  struct Corners {
    std::int32_t number[8];
  };
  // Base cells are shifted by one, so that b = -1 is representable: find(b + 1).
  std::int32_t find(const glm::ivec3& base) const {
    return supported_.find(base.x + 1, base.y + 1, base.z + 1);
  }
  // As SparseGrid::empty_block, of base cells.
  int empty_block(const glm::ivec3& base) const {
    return supported_.empty_block(base.x + 1, base.y + 1, base.z + 1);
  }
  int side() const { return supported_.side(); }
  const Corners& corners(std::int32_t support) const { return corners_[std::size_t(support)]; }
  std::size_t size() const { return corners_.size(); }

 private:
  SparseGrid supported_;
  std::vector<Corners> corners_;
};

// One pixel's ray through the volume, in cell units: cell (i, j, k)'s centre is at the point (i, j,
// k). Sample s of the ray is at origin + direction * (first_sample + s); samples are one cell
// apart.
struct CachedRay {
  glm::vec3 direction{0.0f};     // unit length
  float first_sample = 0.0f;     // distance of sample 0 from the ray's origin
  std::uint32_t first_span = 0;  // runs of supported samples, into RayCache::spans
  std::uint16_t span_count = 0;
  std::uint16_t photo = 0;
  glm::vec4 target{0.0f};  // premultiplied sRGB-encoded colour and alpha of the pixel
};

struct SampleSpan {
  std::uint16_t first = 0, last = 0;  // samples first .. last - 1
};

// All rays that can meet the volume, walked once: which samples of each ray have any support. Rays
// stand in tiles of kTilePx x kTilePx pixels, photo by photo: neighbours meet the same cells, so a
// tile's later rays find them in the processor's caches.
inline constexpr int kTilePx = 8;
struct RayCache {
  std::vector<CachedRay> rays;
  std::vector<SampleSpan> spans;
  std::vector<glm::vec3> origins;         // of each photo, in cell units
  std::vector<std::uint32_t> first_rays;  // of each tile, and one past the last

  std::size_t tiles() const { return first_rays.size() - 1; }
  std::span<const CachedRay> tile(std::size_t number) const {
    return {rays.data() + first_rays[number], rays.data() + first_rays[number + 1]};
  }
};

// The tiles in an order that depends on the seed alone; a stretch of it is a fair sample of all
// photos.
std::vector<std::uint32_t> shuffled_tiles(const RayCache& cache, std::uint64_t seed);

// A photo's pixels averaged over step x step blocks, premultiplied: what a coarse level is fitted
// to.
Image<glm::vec4> premultiplied_at(const Matte& matte, int step);

// Walks the rays of every `step`-th pixel block of all photos (see premultiplied_at).
RayCache cache_rays(const Photos& photos, const Mattes& mattes, int step, const Cube& cube,
                    int level, const TrilinearSupport& support, Progress& progress);

// Cell units of a level: cell (i, j, k)'s centre is (i, j, k).
inline glm::dvec3 cells_from_world(const glm::dvec3& point, const Cube& cube, int level) {
  return (point - cube.origin) * (double(1 << level) / cube.size_m) - 0.5;
}

// Trilinear weights of the corners (x fastest) for a point at `fraction` of the base cell.
inline void trilinear_weights(const glm::vec3& fraction, float (&weights)[8]) {
  const glm::vec3 f = fraction, g = 1.0f - fraction;
  const float a = g.y * g.z, b = f.y * g.z, c = g.y * f.z, d = f.y * f.z;
  weights[0] = g.x * a, weights[1] = f.x * a, weights[2] = g.x * b, weights[3] = f.x * b;
  weights[4] = g.x * c, weights[5] = f.x * c, weights[6] = g.x * d, weights[7] = f.x * d;
}

// Calls visit(support number, fraction within the base cell) for the ray's samples, front to back,
// until visit returns false.
template <class Visit>
[[gnu::always_inline]] inline void for_each_sample(const RayCache& cache, const CachedRay& ray,
                                                   const TrilinearSupport& support, Visit&& visit) {
  const glm::vec3 origin = cache.origins[ray.photo];
  for (std::uint32_t i = 0; i < ray.span_count; ++i) {
    const SampleSpan span = cache.spans[ray.first_span + i];
    for (int s = span.first; s < span.last; ++s) {
      const glm::vec3 at = origin + ray.direction * (ray.first_sample + float(s));
      const glm::vec3 base = glm::floor(at);
      const std::int32_t number = support.find(glm::ivec3(base));
      if (number < 0) continue;
      if (!visit(number, at - base)) return;
    }
  }
}

}  // namespace bosk
