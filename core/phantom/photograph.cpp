#include "core/phantom/photograph.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/image/colour.h"
#include "core/image/image_io.h"
#include "core/phantom/noise.h"
#include "core/phantom/pixel_reach.h"

namespace bosk {
namespace {

constexpr float kDistantTreesBelow = 0.35f;  // sine of the elevation
constexpr float kNoiseVariancePerLight = 2.2e-4f, kNoiseVariance = 1e-6f;

// Where on the plane z = 1 of the camera each pixel looks, one pixel of margin all round. Between
// pixels it is near enough straight: the lens bends by less than 1e-4 px within one.
Image<glm::vec2> pixel_plane(const Lens& lens) {
  Image<glm::vec2> plane(lens.width_px + 2, lens.height_px + 2);
  tbb::parallel_for(0, plane.height(), [&](int y) {
    for (int x = 0; x < plane.width(); ++x) {
      const auto seen = camera_from_pixel(lens, glm::dvec2(x - 1, y - 1));
      if (!seen || seen->z <= 0.0) {
        throw Error(
            "phantom: the lens sees nothing in a corner of the picture; use less distortion");
      }
      plane(x, y) = glm::vec2(seen->x / seen->z, seen->y / seen->z);
    }
  });
  return plane;
}

// The point of [-1, 1] below which a share `u` of the filter (1 3 3 1)/8 lies.
float filter_quantile(float u) {
  if (u < 0.125f) return -1.0f + 4.0f * u;
  if (u < 0.875f) return -0.5f + (u - 0.125f) * (4.0f / 3.0f);
  return 0.5f + (u - 0.875f) * 4.0f;
}

struct PixelSums {
  glm::vec3 tree{0.0f}, seen{0.0f};  // linear; `seen` is the tree less what hides it
  int tree_hits = 0, open = 0, in_front = 0, samples = 0;
};

class Shutter {
 public:
  Shutter(const Studio& studio, const Camera& camera, const Shot& shot, const RayScene& rays,
          const Image<glm::vec2>& plane, const Image<std::uint8_t>& reach)
      : studio_(studio),
        shot_(shot),
        rays_(rays),
        plane_(plane),
        reach_(reach),
        seed_(std::uint32_t(Random(shot.seed, 6).bits())) {
    const RigidTransform world_from_camera = inverse(camera.camera_from_world);
    turn_ = glm::mat3(world_from_camera.rotation);
    origin_ = glm::vec3(world_from_camera.translation);
    pixel_angle_ = float(1.0 / camera.lens.focal_px.x);
  }

  void expose(int x, int y, Exposure& exposure) const {
    const std::uint8_t near = reach_(x, y);
    PixelSums sums;
    sums.samples = sums.open = shot_.samples * shot_.samples;
    if (near != 0) gather(x, y, near, sums);
    const float alpha = float(sums.tree_hits) / float(sums.samples);
    if (sums.tree_hits > 0) exposure.matte(x, y) = matte_pixel(sums, alpha);
    glm::vec3 light = sums.seen / float(sums.samples);
    if (shot_.background && sums.open > 0) {
      light += background(x, y) * (float(sums.open) / float(sums.samples));
    }
    exposure.photograph(x, y) = developed(light, x, y);
    exposure.in_front(x, y) = byte_from_unit(float(sums.in_front) / float(sums.samples));
  }

 private:
  // Direction in the world of sample (i, j) of n x n in the pixel, not of unit length.
  glm::vec3 direction(int x, int y, int i, int j, int n) const {
    const std::uint32_t pixel = std::uint32_t(y) * 65536u + std::uint32_t(x) + seed_;
    const auto sample = std::uint32_t(j * n + i);
    const float u = (float(i) + hashed_unit(pixel, sample, 1u)) / float(n);
    const float v = (float(j) + hashed_unit(pixel, sample, 2u)) / float(n);
    const float px = float(x) + 1.0f + filter_quantile(u),
                py = float(y) + 1.0f + filter_quantile(v);
    const int left = int(px), top = int(py);
    const int right = std::min(left + 1, plane_.width() - 1),
              below = std::min(top + 1, plane_.height() - 1);
    const float tx = px - float(left), ty = py - float(top);
    const glm::vec2 at = glm::mix(glm::mix(plane_(left, top), plane_(right, top), tx),
                                  glm::mix(plane_(left, below), plane_(right, below), tx), ty);
    return turn_ * glm::vec3(at, 1.0f);
  }

  void gather(int x, int y, std::uint8_t near, PixelSums& sums) const {
    const int n = shot_.samples;
    for (int first = 0; first < n * n; first += kPacketRays) {
      PacketDirections directions;
      for (int k = 0; k < kPacketRays; ++k) {
        directions[std::size_t(k)] = direction(x, y, (first + k) % n, (first + k) / n, n);
      }
      PacketHits hits;
      if ((near & kTreeNear) != 0) hits = rays_.first_hits(origin_, directions);
      for (std::size_t k = 0; k < kPacketRays; ++k) add(directions[k], hits[k], near, sums);
    }
  }

  void add(const glm::vec3& direction, const RayHit& hit, std::uint8_t near,
           PixelSums& sums) const {
    const World& world = studio_.world;
    SolidHit solid;
    if ((near & kSolidNear) != 0 && shot_.background)
      solid = solid_along(world, origin_, direction);
    glm::vec3 light(0.0f);
    if (hit) {
      light = tree_radiance(studio_.tree, studio_.tree_light, world, hit, direction);
      sums.tree += light;
      ++sums.tree_hits;
    }
    if (solid && (!hit || solid.distance < hit.distance)) {
      const glm::vec3 point = origin_ + solid.distance * direction;
      light = solid_radiance(world, studio_.resting_rays, solid, point);
      ++sums.in_front;
    }
    sums.seen += light;
    if (hit || solid) --sums.open;
  }

  glm::vec3 background(int x, int y) const {
    // The sky is smooth within a pixel: one look does.
    const glm::vec3 centre = glm::normalize(direction(x, y, 0, 0, 1));
    const glm::vec3 sky = centre.z > -0.01f ? sky_radiance(studio_.world, centre) : glm::vec3(0.0f);
    if (centre.z > kDistantTreesBelow) return sky;
    const int rays = std::abs(centre.z) < 0.15f ? 8 : 4;
    glm::vec3 sum(0.0f);
    for (int i = 0; i < rays; ++i) {
      const int j = (3 * i + 1) % rays;  // no two share a row or column
      sum += behind_tree(glm::normalize(direction(x, y, i, j, rays)), sky);
    }
    return sum / float(rays);
  }

  glm::vec3 behind_tree(const glm::vec3& direction, const glm::vec3& sky) const {
    const World& world = studio_.world;
    if (std::abs(direction.z) < kDistantTreesBelow && !world.distant_trees.empty()) {
      const RayHit hit = studio_.distant_rays.first_hit(origin_, direction);
      if (hit) {
        const glm::vec3 light =
            tree_radiance(studio_.tree, studio_.tree_light, world, hit, direction);
        return through_haze(light, hit.distance);
      }
    }
    if (direction.z >= -1e-4f) return sky;
    const float distance = -origin_.z / direction.z;
    const glm::vec3 at = origin_ + distance * direction;
    const float footprint = distance * pixel_angle_ / std::sqrt(std::max(-direction.z, 1e-3f));
    return through_haze(ground_radiance(world, studio_.ground_light, glm::vec2(at), footprint),
                        distance);
  }

  glm::u8vec4 matte_pixel(const PixelSums& sums, float alpha) const {
    const glm::vec3 linear = sums.tree * (float(shot_.exposure) / float(sums.tree_hits));
    const glm::vec3 srgb = srgb_from_linear(glm::min(linear, 1.0f));
    return {byte_from_unit(srgb.r), byte_from_unit(srgb.g), byte_from_unit(srgb.b),
            byte_from_unit(alpha)};
  }

  glm::u8vec3 developed(const glm::vec3& light, int x, int y) const {
    glm::vec3 exposed = light * float(shot_.exposure);
    if (shot_.noise > 0.0) {
      Random random(shot_.seed, 7 + std::uint64_t(y) * 65536u + std::uint64_t(x));
      for (int c = 0; c < 3; ++c) {
        const float variance = kNoiseVariancePerLight * exposed[c] + kNoiseVariance;
        exposed[c] += float(shot_.noise * random.normal()) * std::sqrt(variance);
      }
    }
    const glm::vec3 srgb = srgb_from_linear(glm::clamp(exposed, 0.0f, 1.0f));
    return {byte_from_unit(srgb.r), byte_from_unit(srgb.g), byte_from_unit(srgb.b)};
  }

  const Studio& studio_;
  const Shot& shot_;
  const RayScene& rays_;
  const Image<glm::vec2>& plane_;
  const Image<std::uint8_t>& reach_;
  std::uint32_t seed_;
  glm::mat3 turn_{1.0f};
  glm::vec3 origin_{0.0f};
  float pixel_angle_ = 1e-3f;
};

}  // namespace

Studio set_up_studio(Tree tree, World world, int ground_map, Progress& progress) {
  const RayScene rays(tree.vertices, tree.triangles);
  const RayScene distant(rays, world.distant_trees);
  GroundLight ground = light_ground(rays, world, ground_map, progress);
  TreeLight light = light_tree(tree, rays, world, ground, progress);
  return {std::move(tree), rays, distant, std::move(world), std::move(ground), std::move(light)};
}

Exposure photograph(const Studio& studio, const Camera& camera, const Shot& shot,
                    Progress& progress) {
  const bool windy = shot.wind > 0.0;
  const std::vector<glm::vec3> blown =
      windy ? wind_blown(studio.tree, shot.wind, shot.seed) : std::vector<glm::vec3>{};
  const std::vector<glm::vec3>& vertices = windy ? blown : studio.tree.vertices;
  const RayScene rays = windy ? RayScene(blown, studio.tree.triangles) : studio.resting_rays;
  progress.check();
  const Image<glm::vec2> plane = pixel_plane(camera.lens);
  const Image<std::uint8_t> reach =
      pixel_reach(camera, vertices, studio.tree.triangles, studio.world);
  const Shutter shutter(studio, camera, shot, rays, plane, reach);
  const int width = camera.lens.width_px, height = camera.lens.height_px;
  Exposure exposure{Image<glm::u8vec3>(width, height), Image<glm::u8vec4>(width, height),
                    Image<std::uint8_t>(width, height)};
  tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) shutter.expose(x, y, exposure);
    progress.advance();
  });
  return exposure;
}

double visible_share(const Studio& studio, const Camera& camera, std::size_t marker) {
  const Marker& ball = studio.world.markers[marker];
  const glm::vec3 eye(camera.centre_in_world());
  const glm::vec3 towards = glm::normalize(glm::vec3(ball.centre) - eye);
  const glm::vec3 side = glm::normalize(glm::cross(towards, glm::vec3(0, 0, 1)));
  const glm::vec3 up = glm::cross(side, towards);
  constexpr int kPoints = 64;
  int seen = 0;
  for (int k = 0; k < kPoints; ++k) {
    const float radius = float(ball.radius) * 0.98f * std::sqrt((float(k) + 0.5f) / kPoints);
    const float angle = 2.39996323f * float(k);
    const glm::vec3 point =
        glm::vec3(ball.centre) + radius * (std::cos(angle) * side + std::sin(angle) * up);
    const auto pixel = project(camera, glm::dvec3(point));
    const bool inside = pixel && pixel->x > -0.5 && pixel->y > -0.5 &&
                        pixel->x < camera.lens.width_px - 0.5 &&
                        pixel->y < camera.lens.height_px - 0.5;
    if (!inside) continue;
    const SolidHit first = solid_along(studio.world, eye, point - eye);
    const bool own = first.distance * glm::distance(point, eye) >
                     glm::distance(point, eye) - 1.01f * float(ball.radius);
    if (own && !studio.resting_rays.blocked(eye, point - eye, first.distance)) ++seen;
  }
  return double(seen) / kPoints;
}

}  // namespace bosk
