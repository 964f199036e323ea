#include "core/radiance/volume_march.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <optional>

#include "core/opacity/ray_cache.h"

namespace bosk {
namespace {

constexpr float kFollowed = 1.0f / 200.0f;  // a ray ends when less light than this is left

struct March {
  glm::vec3 origin{0.0f}, direction{0.0f};  // cell units
  float from = 0.0f, to = 0.0f;
};

// A number in [0, 1) that differs from pixel to pixel, so that the steps show as fine noise and not
// as contour lines.
float pixel_offset(int x, int y) {
  std::uint32_t h = std::uint32_t(x) * 0x9e3779b1u ^ std::uint32_t(y) * 0x85ebca6bu;
  h ^= h >> 15, h *= 0x2c1b3c6du, h ^= h >> 12;
  return float(h >> 8) / float(1 << 24);
}

// Whole steps until the ray leaves the brick of base cells around it.
float steps_to_leave(const glm::vec3& at, const glm::vec3& direction, const glm::ivec3& base) {
  float nearest = 1e9f;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0f) continue;
    const int lower = base[axis] & ~(VolumeSnapshot::kBrick - 1);
    const auto wall = float(direction[axis] > 0.0f ? lower + VolumeSnapshot::kBrick : lower);
    nearest = std::min(nearest, (wall - at[axis]) / direction[axis]);
  }
  return std::max(1.0f, std::ceil(nearest));
}

// What a ray has gathered on its way.
struct Gathered {
  glm::vec3 colour{0.0f};
  float left = 1.0f;  // of the light

  void add(const glm::vec4& sample) {
    if (sample.w <= 0.0f) return;
    const float kept = std::exp(-sample.w);
    colour += glm::vec3(sample) * (left * (1.0f - kept) / sample.w);
    left *= kept;
  }
};

glm::vec4 marched(const VolumeSnapshot& volume, const March& ray) {
  const glm::ivec3 last(volume.side() - 1);
  Gathered gathered;
  for (float s = ray.from; s < ray.to && gathered.left > kFollowed;) {
    const glm::vec3 at = ray.origin + ray.direction * s;
    const glm::ivec3 base = glm::clamp(glm::ivec3(glm::floor(at)), glm::ivec3(-1), last);
    const float end = std::min(s + steps_to_leave(at, ray.direction, base), ray.to);
    const VolumeSnapshot::Brick* brick = brick_around(volume, base);
    if (!brick) {
      s = end;
      continue;
    }
    const glm::vec3 start = ray.origin - glm::vec3(base & ~7);  // from the brick's first cell
    for (; s < end && gathered.left > kFollowed; s += 1.0f) {
      const glm::vec3 in_brick = glm::clamp(start + ray.direction * s, 0.0f, 7.9999f);
      const glm::ivec3 inside(in_brick);
      if (!brick->any(inside)) continue;
      gathered.add(sample_brick(*brick, in_brick - glm::vec3(inside), inside));
    }
  }
  return {gathered.colour, 1.0f - gathered.left};
}

}  // namespace

Image<glm::vec4> premultiplied_picture(const VolumeSnapshot& volume, const Camera& pinhole) {
  const Lens& lens = pinhole.lens;
  Image<glm::vec4> picture(lens.width_px, lens.height_px);
  const glm::dmat3 world_from_camera = glm::transpose(pinhole.camera_from_world.rotation);
  const glm::dvec3 origin =
      cells_from_world(pinhole.centre_in_world(), {volume.origin, volume.size_m}, volume.level);
  const Cube cube{volume.origin, volume.size_m};
  const Box box{cells_from_world(volume.bounds.lower, cube, volume.level) - 0.5,
                cells_from_world(volume.bounds.upper, cube, volume.level) + 0.5};
  const auto pixel = [&](int x, int y) {
    const glm::dvec3 in_camera((glm::dvec2(x, y) - lens.principal_px) / lens.focal_px, 1.0);
    const glm::dvec3 direction = glm::normalize(world_from_camera * in_camera);
    const std::optional<RaySpan> inside = intersect({origin, direction}, box);
    if (!inside) return glm::vec4(0.0f);
    const float from = float(inside->enter) + pixel_offset(x, y);
    return marched(volume, {origin, direction, from, float(inside->leave)});
  };
  tbb::parallel_for(tbb::blocked_range2d<int>(0, picture.height(), 8, 0, picture.width(), 32),
                    [&](const auto& tile) {
                      for (int y = tile.rows().begin(); y < tile.rows().end(); ++y) {
                        for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) {
                          picture(x, y) = pixel(x, y);
                        }
                      }
                    });
  return picture;
}

}  // namespace bosk
