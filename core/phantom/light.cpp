#include "core/phantom/light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/phantom/noise.h"

namespace bosk {
namespace {

constexpr std::uint32_t kSkyRays = 8, kSunRays = 3;
constexpr float kSunSpread = 0.012f;  // tangent; wider than the real sun's 0.0047, which softens
constexpr std::uint32_t kGroundSunRays = 4, kGroundSkyRays = 24;
constexpr float kTau = 6.28318531f;

struct Frame {
  glm::vec3 x, y, z;
};

Frame frame_round(const glm::vec3& z) {
  const glm::vec3 other = std::abs(z.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  const glm::vec3 x = glm::normalize(glm::cross(z, other));
  return {x, glm::cross(z, x), z};
}

// Direction k of n, spread like a cosine round the frame's z and turned by a number of the place.
glm::vec3 cosine_direction(const Frame& frame, std::uint32_t k, std::uint32_t n,
                           std::uint32_t place) {
  const float square = (float(k) + hashed_unit(place, k, 11u)) / float(n);
  const float angle = kTau * (0.618034f * float(k) + hashed_unit(place, 0u, 12u));
  const float radius = std::sqrt(square), height = std::sqrt(1.0f - square);
  return radius * std::cos(angle) * frame.x + radius * std::sin(angle) * frame.y + height * frame.z;
}

glm::vec3 towards_sun(const Frame& sun, std::uint32_t k, std::uint32_t place) {
  const float radius = kSunSpread * std::sqrt(hashed_unit(place, k, 21u));
  const float angle = kTau * hashed_unit(place, k, 22u);
  return sun.z + radius * (std::cos(angle) * sun.x + std::sin(angle) * sun.y);
}

float sampled(const Image<float>& map, float half_size, const glm::vec2& point) {
  const float side = float(map.width());
  const glm::vec2 at = (point + half_size) / (2.0f * half_size) * side - 0.5f;
  if (at.x < 0.0f || at.y < 0.0f || at.x >= side - 1.0f || at.y >= side - 1.0f) return 1.0f;
  const int x = int(at.x), y = int(at.y);
  const float tx = at.x - float(x), ty = at.y - float(y);
  return glm::mix(glm::mix(map(x, y), map(x + 1, y), tx),
                  glm::mix(map(x, y + 1), map(x + 1, y + 1), tx), ty);
}

// Leaves differ a little in brightness and in how yellow they are.
glm::vec3 leaf_tint(std::size_t leaf) {
  const auto i = std::uint32_t(leaf);
  const float brightness = 0.72f + 0.56f * hashed_unit(i, 1u);
  const float yellow = hashed_unit(i, 2u) - 0.5f;
  return brightness * glm::vec3(1.0f + 0.5f * yellow, 1.0f, 1.0f - 0.4f * yellow);
}

struct Lighting {
  const Tree& tree;
  const RayScene& rays;
  const World& world;
  const GroundLight& ground;
  Frame sun;
  std::vector<float> facet_sun;
};

float visible_sun(const Lighting& l, std::size_t first_triangle, std::size_t count,
                  std::uint32_t place) {
  std::uint32_t seen = 0;
  for (std::uint32_t k = 0; k < kSunRays; ++k) {
    const float a = hashed_unit(place, k, 31u), b = hashed_unit(place, k, 32u);
    const std::size_t triangle = first_triangle + std::size_t(k) * count / kSunRays;
    const glm::vec3 point = l.tree.point(triangle, 0.9f * a * (1.0f - b), 0.9f * a * b);
    const glm::vec3 direction = towards_sun(l.sun, k, place);
    seen += l.rays.blocked(point + 2e-3f * direction, direction) ? 0u : 1u;
  }
  return float(seen) / float(kSunRays);
}

// Sunlight that a leaf sends on, seen from outside along `direction`, plus a guess at its skylight.
glm::vec3 bounced_from_tree(const Lighting& l, const RayHit& hit, const glm::vec3& direction) {
  const TreeShape& shape = l.tree.shape;
  if (l.tree.is_wood(hit.triangle)) return shape.bark_albedo * 0.25f;
  const glm::vec3 normal = l.tree.normal(hit.triangle);
  const float sun = glm::dot(normal, l.world.sun_direction);
  const bool same_side = (glm::dot(normal, direction) < 0.0f) == (sun > 0.0f);
  const glm::vec3 share = same_side ? shape.leaf_albedo : shape.leaf_transmission;
  const float seen = l.facet_sun[l.tree.facet_of(hit.triangle)];
  return share * (l.world.sun_light * (std::abs(sun) * seen)) + 0.3f * shape.leaf_albedo;
}

glm::vec3 arriving(const Lighting& l, const glm::vec3& point, const glm::vec3& direction) {
  const RayHit hit = l.rays.first_hit(point, direction);
  if (hit) return bounced_from_tree(l, hit, direction);
  if (direction.z >= 0.0f) return sky_radiance(l.world, direction);
  const glm::vec3 at = point - direction * (point.z / direction.z);
  return ground_radiance(l.world, l.ground, glm::vec2(at), 1.0f);
}

// Skylight and bounced light on a surface, as the radiance of a white wall in its place.
glm::vec3 indirect(const Lighting& l, const glm::vec3& point, const glm::vec3& normal,
                   std::uint32_t place) {
  const Frame frame = frame_round(normal);
  glm::vec3 sum(0.0f);
  for (std::uint32_t k = 0; k < kSkyRays; ++k) {
    sum += arriving(l, point + 2e-3f * normal, cosine_direction(frame, k, kSkyRays, place));
  }
  return sum / float(kSkyRays);
}

void light_facet(const Lighting& l, std::size_t facet, TreeLight& light) {
  const std::size_t triangle = l.tree.wood_triangles + facet * l.tree.triangles_per_facet;
  const std::size_t middle = triangle + l.tree.triangles_per_facet / 2;
  const glm::vec3 normal = l.tree.normal(middle);
  if (normal == glm::vec3(0.0f)) return;
  const glm::vec3 point = l.tree.point(middle, 0.33f, 0.33f);
  const auto place = std::uint32_t(2 * facet);
  glm::vec3 front = indirect(l, point, normal, place);
  glm::vec3 back = indirect(l, point, -normal, place + 1u);
  const float sun = glm::dot(normal, l.world.sun_direction);
  (sun > 0.0f ? front : back) += l.world.sun_light * (std::abs(sun) * l.facet_sun[facet]);
  const glm::vec3 tint = leaf_tint(facet / l.tree.facets_per_leaf);
  const glm::vec3 albedo = l.tree.shape.leaf_albedo * tint;
  const glm::vec3 through = l.tree.shape.leaf_transmission * tint;
  light.facet_front[facet] = albedo * front + through * back;
  light.facet_back[facet] = 1.15f * albedo * back + through * front;
}

void light_wood_vertex(const Lighting& l, std::size_t vertex, TreeLight& light) {
  const glm::vec3 normal = l.tree.wood_normals[vertex];
  const glm::vec3 point = l.tree.vertices[vertex] + 4e-3f * normal;
  const auto place = 0x80000000u + std::uint32_t(vertex);
  glm::vec3 sum = indirect(l, point, normal, place);
  const float facing = glm::dot(normal, l.world.sun_direction);
  if (facing > 0.0f) {
    std::uint32_t seen = 0;
    for (std::uint32_t k = 0; k < 2; ++k) {
      seen += l.rays.blocked(point, towards_sun(l.sun, k, place)) ? 0u : 1u;
    }
    sum += l.world.sun_light * (facing * float(seen) / 2.0f);
  }
  light.wood[vertex] = sum;
}

template <class Body>
void for_blocks(std::size_t count, Progress& progress, Body&& body) {
  constexpr std::size_t kBlock = 256;
  tbb::parallel_for(std::size_t(0), (count + kBlock - 1) / kBlock, [&](std::size_t block) {
    progress.check();
    const std::size_t last = std::min(count, (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < last; ++i) body(i);
  });
}

// Share of `rays` from each square of the ground that are not blocked.
template <class Blocked>
Image<float> open_map(float half_size, int side, std::uint32_t rays, Progress& progress,
                      Blocked&& blocked) {
  Image<float> map(side, side);
  tbb::parallel_for(0, side, [&](int y) {
    progress.check();
    for (int x = 0; x < side; ++x) {
      const auto place = std::uint32_t(y * side + x);
      std::uint32_t dark = 0;
      for (std::uint32_t k = 0; k < rays; ++k) {
        const glm::vec2 jitter{hashed_unit(place, k, 41u), hashed_unit(place, k, 42u)};
        const glm::vec2 share = (glm::vec2(x, y) + jitter) / float(side);
        const glm::vec3 point((2.0f * share - 1.0f) * half_size, 0.0f);
        dark += blocked(point, k, place) ? 1u : 0u;
      }
      map(x, y) = 1.0f - float(dark) / float(rays);
    }
  });
  return map;
}

}  // namespace

GroundLight light_ground(const RayScene& tree, const World& world, int map_side,
                         Progress& progress) {
  const Frame sun = frame_round(world.sun_direction), up = frame_round({0, 0, 1});
  const float half_size = 1.6f * world.tree_height;
  const auto sun_blocked = [&](const glm::vec3& point, std::uint32_t k, std::uint32_t place) {
    const glm::vec3 ray = towards_sun(sun, k, place);
    return tree.blocked(point, ray) || solid_along(world, point, ray);
  };
  const auto sky_blocked = [&](const glm::vec3& point, std::uint32_t k, std::uint32_t place) {
    return tree.blocked(point, cosine_direction(up, k, kGroundSkyRays, place));
  };
  // The shade from the sky has no edges, so a coarse map will do.
  return {half_size, open_map(half_size, map_side, kGroundSunRays, progress, sun_blocked),
          open_map(half_size, std::max(map_side / 8, 8), kGroundSkyRays, progress, sky_blocked)};
}

TreeLight light_tree(const Tree& tree, const RayScene& rays, const World& world,
                     const GroundLight& ground, Progress& progress) {
  Lighting l{tree, rays, world, ground, frame_round(world.sun_direction), {}};
  const std::size_t facets = tree.facet_count();
  l.facet_sun.resize(facets);
  for_blocks(facets, progress, [&](std::size_t facet) {
    const std::size_t first = tree.wood_triangles + facet * tree.triangles_per_facet;
    l.facet_sun[facet] = visible_sun(l, first, tree.triangles_per_facet, std::uint32_t(facet));
  });
  TreeLight light;
  light.facet_front.assign(facets, glm::vec3(0.0f));
  light.facet_back = light.facet_front;
  light.wood.resize(tree.wood_vertices);
  for_blocks(facets, progress, [&](std::size_t facet) { light_facet(l, facet, light); });
  for_blocks(tree.wood_vertices, progress, [&](std::size_t v) { light_wood_vertex(l, v, light); });
  light.facet_sun = std::move(l.facet_sun);
  return light;
}

glm::vec3 ground_radiance(const World& world, const GroundLight& ground, const glm::vec2& point,
                          float footprint) {
  const float sun = sampled(ground.sun, ground.half_size, point) * distant_shadow(world, point);
  const float sky = sampled(ground.sky, ground.half_size, point);
  const glm::vec3 light =
      world.sun_light * (world.sun_direction.z * sun) + mean_sky_radiance() * (0.15f + 0.85f * sky);
  return ground_albedo(world, point, footprint) * light;
}

glm::vec3 tree_radiance(const Tree& tree, const TreeLight& light, const World& world,
                        const RayHit& hit, const glm::vec3& direction) {
  if (tree.is_wood(hit.triangle)) {
    const glm::uvec3 t = tree.triangles[hit.triangle];
    const glm::vec3 lit = (1.0f - hit.u - hit.v) * light.wood[t.x] + hit.u * light.wood[t.y] +
                          hit.v * light.wood[t.z];
    const glm::vec3 at = tree.point(hit.triangle, hit.u, hit.v);
    const float bark = fractal_noise(at * glm::vec3(38.0f, 38.0f, 9.0f), 3);
    return tree.shape.bark_albedo * (0.45f + 1.1f * bark) * lit;
  }
  const std::size_t facet = tree.facet_of(hit.triangle);
  const glm::vec3 view = -glm::normalize(direction);
  const glm::vec3 outward = glm::normalize(hit.normal);
  const bool front = glm::dot(outward, view) > 0.0f;
  const glm::vec3 normal = front ? outward : -outward;
  const glm::vec3 matt = front ? light.facet_front[facet] : light.facet_back[facet];
  // A waxy sheen where the blade mirrors the sun.
  const glm::vec3 half = glm::normalize(view + world.sun_direction);
  const float mirror = std::max(glm::dot(normal, half), 0.0f);
  const float fourth = mirror * mirror * mirror * mirror,
              sixteenth = fourth * fourth * fourth * fourth;
  return matt + world.sun_light * (0.045f * sixteenth * light.facet_sun[facet]);
}

glm::vec3 solid_radiance(const World& world, const RayScene& tree, const SolidHit& hit,
                         const glm::vec3& point) {
  const float facing = std::max(glm::dot(hit.normal, world.sun_direction), 0.0f);
  const bool lit = facing > 0.0f && !tree.blocked(point + 2e-3f * hit.normal, world.sun_direction);
  const glm::vec3 ambient = mean_sky_radiance() * (0.45f + 0.3f * hit.normal.z);
  return hit.albedo * (ambient + world.sun_light * (lit ? facing : 0.0f));
}

}  // namespace bosk
