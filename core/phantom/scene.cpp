#include "core/phantom/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/random.h"
#include "core/image/colour.h"
#include "core/phantom/noise.h"

namespace bosk {
namespace {

constexpr glm::vec3 kHorizon{0.62f, 0.70f, 0.80f};
constexpr glm::vec3 kZenith{0.13f, 0.26f, 0.58f};
constexpr glm::vec3 kCloud{0.98f, 0.97f, 0.96f};
constexpr float kHazeLength = 800.0f;
constexpr float kStickRadius = 0.012f;

// A layer of clouds at unit height, thinning towards the horizon.
float cloud_cover(const World& world, const glm::vec3& direction) {
  const glm::vec2 at = glm::vec2(direction) / (direction.z + 0.12f);
  const float shift = 7.3f * float(world.seed % 1000u);
  const float noise = fractal_noise({1.1f * at.x + shift, 0.7f * at.y, 0.37f * shift}, 5);
  return glm::smoothstep(0.5f, 0.72f, noise) * glm::smoothstep(0.0f, 0.12f, direction.z);
}

void keep_nearer(SolidHit& best, float distance, const glm::vec3& normal, const glm::vec3& albedo) {
  if (distance > 1e-3f && distance < best.distance) best = {distance, normal, albedo};
}

void meet_ball(const Marker& marker, const glm::vec3& origin, const glm::vec3& direction,
               SolidHit& best) {
  const glm::vec3 centre(marker.centre);
  const glm::vec3 from_centre = origin - centre;
  const float a = glm::dot(direction, direction), b = glm::dot(direction, from_centre);
  // Distance of the line from the centre, taken from the closest point: no cancellation far away.
  const glm::vec3 closest = from_centre - direction * (b / a);
  const float radius = float(marker.radius);
  const float inside = radius * radius - glm::dot(closest, closest);
  if (inside < 0.0f) return;
  const float distance = -b / a - std::sqrt(inside / a);
  const glm::vec3 colour = glm::vec3(marker.colour_srgb) / 255.0f;
  const glm::vec3 normal = (from_centre + distance * direction) / radius;
  keep_nearer(best, distance, normal, linear_from_srgb(colour));
}

// A stick is an upright cylinder from the ground to the ball's centre.
void meet_stick(const Marker& marker, const glm::vec3& origin, const glm::vec3& direction,
                SolidHit& best) {
  const glm::vec2 from_axis = glm::vec2(origin) - glm::vec2(marker.centre);
  const glm::vec2 flat(direction);
  const float a = glm::dot(flat, flat);
  if (a < 1e-12f) return;
  const float b = glm::dot(flat, from_axis);
  const glm::vec2 closest = from_axis - flat * (b / a);
  const float radius = kStickRadius * float(marker.radius / 0.11);
  const float inside = radius * radius - glm::dot(closest, closest);
  if (inside < 0.0f) return;
  const float distance = -b / a - std::sqrt(inside / a);
  const float z = origin.z + distance * direction.z;
  if (z < 0.0f || z > float(marker.centre.z)) return;
  const glm::vec2 normal = (from_axis + distance * flat) / radius;
  keep_nearer(best, distance, glm::vec3(normal, 0.0f), {0.32f, 0.25f, 0.16f});
}

void meet_board(const Board& board, const glm::vec3& origin, const glm::vec3& direction,
                SolidHit& best) {
  const glm::dmat3& turn = board.world_from_board.rotation;
  const glm::vec3 normal(turn[2]);
  const float towards = glm::dot(direction, normal);
  if (towards == 0.0f) return;
  const glm::vec3 corner(board.world_from_board.translation);
  const float distance = glm::dot(corner - origin, normal) / towards;
  const glm::vec3 at = origin + distance * direction - corner;
  const float x = glm::dot(at, glm::vec3(turn[0])) / float(board.square) + 1.0f;
  const float y = glm::dot(at, glm::vec3(turn[1])) / float(board.square) + 1.0f;
  const float columns = float(board.columns), rows = float(board.rows);
  if (x < -1.0f || y < -1.0f || x > columns + 1.0f || y > rows + 1.0f) return;
  const bool on_squares = x >= 0.0f && y >= 0.0f && x < columns && y < rows;
  const bool dark = on_squares && (int(x) + int(y)) % 2 == 0;
  const bool front = towards < 0.0f;
  const float grey = !front ? 0.3f : dark ? 0.03f : 0.75f;
  keep_nearer(best, distance, front ? normal : -normal, glm::vec3(grey));
}

}  // namespace

glm::vec3 sky_radiance(const World& world, const glm::vec3& direction) {
  const float up = std::max(direction.z, 0.0f);
  glm::vec3 sky = glm::mix(kHorizon, kZenith, 1.0f - std::pow(1.0f - up, 2.6f));
  const float towards_sun = std::max(glm::dot(direction, world.sun_direction), 0.0f);
  const float square = towards_sun * towards_sun, fourth = square * square;
  sky += glm::vec3(0.35f, 0.32f, 0.27f) * fourth * fourth;
  const float cover = direction.z > 0.0f ? cloud_cover(world, direction) : 0.0f;
  return glm::mix(sky, kCloud * (0.8f + 0.25f * fourth), 0.85f * cover);
}

glm::vec3 mean_sky_radiance() { return {0.38f, 0.47f, 0.62f}; }

glm::vec3 ground_albedo(const World& world, const glm::vec2& point, float footprint) {
  const float shift = float(world.seed % 977u);
  const auto layer = [&](float metres, int octaves) {
    return fractal_noise({point.x / metres + shift, point.y / metres, 3.7f}, octaves);
  };
  const float fine = footprint < 0.12f ? 1.0f - footprint / 0.12f : 0.0f;
  const float dry = glm::smoothstep(0.48f, 0.68f, layer(5.0f, 3));
  glm::vec3 grass =
      glm::mix(glm::vec3(0.075f, 0.115f, 0.03f), glm::vec3(0.19f, 0.17f, 0.065f), dry);
  grass *= 0.72f + 0.56f * layer(0.6f, 3);
  if (fine > 0.0f) {
    const float blades = value_noise({point.x / 0.035f, point.y / 0.035f, 0.5f});
    grass *= 1.0f + fine * 1.1f * (blades - 0.5f);
  }
  const float bare = 1.0f - glm::smoothstep(0.3f, 0.9f,
                                            glm::length(point) / (0.09f * world.tree_height) +
                                                0.5f * (layer(0.4f, 2) - 0.5f));
  return glm::mix(grass, glm::vec3(0.13f, 0.095f, 0.06f), bare);
}

float distant_shadow(const World& world, const glm::vec2& point) {
  const glm::vec2 away = -glm::vec2(world.sun_direction) / world.sun_direction.z;
  float light = 1.0f;
  for (const MeshCopy& tree : world.distant_trees) {
    const glm::vec2 centre = glm::vec2(tree.shift) + away * (0.5f * tree.scale * world.tree_height);
    const glm::vec2 off = (point - centre) / (world.crown_radius * tree.scale);
    const float square = glm::dot(off, off);
    if (square < 1.3f) light *= 1.0f - 0.85f * (1.0f - glm::smoothstep(0.6f, 1.3f, square));
  }
  return light;
}

SolidHit solid_along(const World& world, const glm::vec3& origin, const glm::vec3& direction) {
  SolidHit best;
  for (const Marker& marker : world.markers) {
    meet_ball(marker, origin, direction, best);
    meet_stick(marker, origin, direction, best);
  }
  for (const Board& board : world.boards) meet_board(board, origin, direction, best);
  return best;
}

glm::vec3 through_haze(const glm::vec3& radiance, float distance) {
  return glm::mix(kHorizon, radiance, std::exp(-distance / kHazeLength));
}

std::vector<Marker> place_markers(int count, double crown_radius, double scale,
                                  std::uint64_t seed) {
  struct Paint {
    const char* name;
    glm::u8vec3 srgb;
  };
  constexpr std::array<Paint, 8> paints{{{"red", {214, 24, 24}},
                                         {"yellow", {244, 214, 10}},
                                         {"blue", {22, 60, 214}},
                                         {"magenta", {222, 24, 170}},
                                         {"cyan", {10, 196, 214}},
                                         {"orange", {246, 120, 10}},
                                         {"violet", {110, 30, 200}},
                                         {"white", {235, 235, 235}}}};
  Random random(seed, 4);
  std::vector<Marker> markers;
  for (int i = 0; i < std::min(count, int(paints.size())); ++i) {
    const double angle = 6.283185307179586 * (i + random.uniform(-0.25, 0.25)) / count;
    const double distance = crown_radius * random.uniform(0.8, 1.05);
    const double height = scale * random.uniform(0.35, 1.2);
    const Paint& paint = paints[std::size_t(i)];
    markers.push_back({paint.name,
                       paint.srgb,
                       {distance * std::cos(angle), distance * std::sin(angle), height},
                       0.11 * scale});
  }
  return markers;
}

std::vector<MeshCopy> place_distant_trees(int count, double tree_height, std::uint64_t seed) {
  Random random(seed, 5);
  std::vector<MeshCopy> copies;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * (i + random.uniform(-0.35, 0.35)) / count;
    const double distance = tree_height * random.uniform(4.5, 13.0);
    copies.push_back({glm::vec3(distance * std::cos(angle), distance * std::sin(angle), 0.0),
                      float(random.uniform(0.7, 1.25))});
  }
  return copies;
}

}  // namespace bosk
