#include "core/opacity/ray_cache.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/random.h"
#include "core/geometry/box.h"

namespace bosk {
namespace {

constexpr int kMaxGap = 3;  // shorter runs of unsupported samples are not worth a span of their own

struct PhotoRays {
  std::vector<CachedRay> rays;  // first_span counts within `spans`
  std::vector<SampleSpan> spans;
  std::vector<std::uint32_t> first_rays;  // of the tiles that have any
};

// A number in [0, 1) that differs from pixel to pixel: offsets the samples, so that their spacing
// shows as fine noise and not as contour lines.
float pixel_offset(int x, int y) {
  std::uint32_t h = std::uint32_t(x) * 0x9e3779b1u ^ std::uint32_t(y) * 0x85ebca6bu;
  h ^= h >> 15, h *= 0x2c1b3c6du, h ^= h >> 12;
  return float(h >> 8) / float(1 << 24);
}

// Samples to skip from `at` until the ray leaves the aligned block of base cells around it.
int samples_to_leave(const glm::vec3& at, const glm::vec3& direction, const glm::ivec3& base,
                     int block) {
  float nearest = 1e9f;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0f) continue;
    const int lower = (base[axis] + 1) & ~(block - 1);
    const float wall = float((direction[axis] > 0.0f ? lower + block : lower) - 1);
    nearest = std::min(nearest, (wall - at[axis]) / direction[axis]);
  }
  return std::max(1, int(std::ceil(nearest)));
}

void append_spans(const CachedRay& ray, const glm::vec3& origin, int samples,
                  const TrilinearSupport& support, std::vector<SampleSpan>& spans) {
  const std::size_t before = spans.size();
  const auto limit = support.side() - 1;
  for (int s = 0; s < samples;) {
    const glm::vec3 at = origin + ray.direction * (ray.first_sample + float(s));
    const glm::ivec3 base(glm::floor(at));
    const bool inside = glm::all(glm::greaterThanEqual(base, glm::ivec3(-1))) &&
                        glm::all(glm::lessThan(base, glm::ivec3(limit)));
    if (!inside) {
      ++s;
      continue;
    }
    if (const int block = support.empty_block(base); block > 0) {
      s += samples_to_leave(at, ray.direction, base, block);
      continue;
    }
    if (support.find(base) >= 0) {
      const bool extend = spans.size() > before && s - spans.back().last <= kMaxGap;
      if (!extend) spans.push_back({std::uint16_t(s), std::uint16_t(s)});
      spans.back().last = std::uint16_t(s + 1);
    }
    ++s;
  }
}

// Turns pixels of one photo into rays of the volume.
class RayCaster {
 public:
  RayCaster(const Photo& photo, int photo_number, int step, const Cube& cube, int level,
            const TrilinearSupport& support)
      : world_from_camera_(glm::transpose(photo.camera.camera_from_world.rotation)),
        origin_(cells_from_world(photo.camera.centre_in_world(), cube, level)),
        lens_(photo.camera.lens),
        box_{glm::dvec3(-1.0), glm::dvec3(double(1 << level))},
        step_(step),
        photo_number_(photo_number),
        support_(support) {}

  void cast(int x, int y, const glm::vec4& target, PhotoRays& result) const {
    const glm::dvec2 pixel = (glm::dvec2(x, y) + 0.5) * double(step_) - 0.5;
    const glm::dvec3 in_camera((pixel - lens_.principal_px) / lens_.focal_px, 1.0);
    const glm::dvec3 direction = glm::normalize(world_from_camera_ * in_camera);
    const std::optional<RaySpan> inside = intersect({origin_, direction}, box_);
    if (!inside) return;
    CachedRay ray;
    ray.direction = direction;
    ray.first_sample = float(inside->enter) + pixel_offset(x, y);
    ray.first_span = std::uint32_t(result.spans.size());
    ray.photo = std::uint16_t(photo_number_);
    ray.target = target;
    const int samples = int(std::ceil(inside->leave - inside->enter));
    append_spans(ray, origin_, samples, support_, result.spans);
    ray.span_count = std::uint16_t(result.spans.size() - ray.first_span);
    if (ray.span_count > 0) result.rays.push_back(ray);
  }

 private:
  glm::dmat3 world_from_camera_;
  glm::dvec3 origin_;
  Lens lens_;
  Box box_;
  int step_, photo_number_;
  const TrilinearSupport& support_;
};

PhotoRays rays_of(const RayCaster& caster, const Image<glm::vec4>& target, Progress& progress) {
  PhotoRays result;
  for (int top = 0; top < target.height(); top += kTilePx) {
    progress.advance();
    for (int left = 0; left < target.width(); left += kTilePx) {
      const std::size_t before = result.rays.size();
      for (int y = top; y < std::min(top + kTilePx, target.height()); ++y) {
        for (int x = left; x < std::min(left + kTilePx, target.width()); ++x) {
          caster.cast(x, y, target(x, y), result);
        }
      }
      if (result.rays.size() > before) result.first_rays.push_back(std::uint32_t(before));
    }
  }
  return result;
}

void append(PhotoRays&& part, RayCache& cache) {
  const auto first_span = std::uint32_t(cache.spans.size());
  const auto first_ray = std::uint32_t(cache.rays.size());
  for (CachedRay ray : part.rays) {
    ray.first_span += first_span;
    cache.rays.push_back(ray);
  }
  for (const std::uint32_t first : part.first_rays) cache.first_rays.push_back(first_ray + first);
  cache.spans.insert(cache.spans.end(), part.spans.begin(), part.spans.end());
  part = {};
}

}  // namespace

TrilinearSupport::TrilinearSupport(const SparseGrid& grid) {
  // Base cell b is cell - {0, 1}^3, kept at b + 1: one level finer, the smallest cube that holds
  // side
  // + 1 of them
  supported_ = grid.grown();
  corners_.resize(supported_.size());
  const auto& supports = supported_.cells();
  tbb::parallel_for(std::size_t(0), supports.size(), [&](std::size_t s) {
    const glm::ivec3 base = glm::ivec3(supports[s]) - 1;
    for (int i = 0; i < 8; ++i) {
      const glm::ivec3 c = base + glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
      const std::int32_t number = grid.find(c.x, c.y, c.z);
      corners_[s].number[i] = number >= 0 ? number : std::int32_t(grid.size());
    }
  });
}

Image<glm::vec4> premultiplied_at(const Matte& matte, int step) {
  const int width = matte.rgba.width() / step, height = matte.rgba.height() / step;
  Image<glm::vec4> result(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      glm::vec4 sum(0.0f);
      for (int j = 0; j < step; ++j) {
        for (int i = 0; i < step; ++i) {
          const glm::vec4 straight = matte.rgba(x * step + i, y * step + j);
          sum += glm::vec4(glm::vec3(straight) * straight.a, straight.a);
        }
      }
      result(x, y) = sum / float(step * step);
    }
  }
  return result;
}

std::vector<std::uint32_t> shuffled_tiles(const RayCache& cache, std::uint64_t seed) {
  std::vector<std::uint32_t> order(cache.tiles());
  std::iota(order.begin(), order.end(), 0u);
  Random random(seed);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[std::size_t(random.below(i))]);
  }
  return order;
}

RayCache cache_rays(const Photos& photos, const Mattes& mattes, int step, const Cube& cube,
                    int level, const TrilinearSupport& support, Progress& progress) {
  assert(photos.size() == mattes.size());
  std::vector<PhotoRays> parts(photos.size());
  std::size_t rows = 0;
  for (const Matte& matte : mattes) rows += std::size_t(matte.rgba.height() / step / kTilePx);
  progress.begin("Casting the photos' rays", rows);
  tbb::parallel_for(std::size_t(0), photos.size(), [&](std::size_t i) {
    const RayCaster caster(photos[i], int(i), step, cube, level, support);
    parts[i] = rays_of(caster, premultiplied_at(mattes[i], step), progress);
  });

  RayCache cache;
  std::size_t rays = 0, spans = 0;
  for (const PhotoRays& part : parts) rays += part.rays.size(), spans += part.spans.size();
  cache.rays.reserve(rays);
  cache.spans.reserve(spans);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    cache.origins.emplace_back(cells_from_world(photos[i].camera.centre_in_world(), cube, level));
    append(std::move(parts[i]), cache);
  }
  cache.first_rays.push_back(std::uint32_t(cache.rays.size()));
  return cache;
}

}  // namespace bosk
