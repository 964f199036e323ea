#include "leafy_billboards.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "core/base/random.h"
#include "core/image/colour.h"

namespace bosk::testing {
namespace {

constexpr int kSubsamples = 4;  // along a texel's edge

struct Leaf {
  glm::dvec3 centre, along, across;  // unit cell; half axes of the ellipse
  glm::vec3 linear_colour;
};

struct Sample {
  double depth = 1e9;
  glm::vec3 linear_colour{0.0f};
  bool hit = false;
};

glm::dvec3 random_direction(Random& random) {
  return glm::normalize(glm::dvec3(random.normal(), random.normal(), random.normal()));
}

Leaf random_leaf(Random& random, double size) {
  const glm::dvec3 along = random_direction(random);
  const glm::dvec3 across = glm::normalize(glm::cross(along, random_direction(random)));
  const glm::dvec3 centre(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5),
                          random.uniform(-0.5, 0.5));
  const float light = float(std::exp(0.5 * random.normal()));
  const glm::vec3 hue(0.10 + 0.03 * random.normal(), 0.17, 0.04 + 0.015 * random.normal());
  return {centre, along * size, across * (0.5 * size),
          glm::clamp(hue * light, glm::vec3(0.002f), glm::vec3(1.0f))};
}

std::vector<Leaf> random_leaves(Random& random, const LeafyOptions& options) {
  const double mean = options.leaves * std::exp(0.7 * random.normal());
  std::vector<Leaf> leaves(std::size_t(std::clamp(mean, 1.0, 60.0)));
  for (Leaf& leaf : leaves) leaf = random_leaf(random, options.leaf_size);
  return leaves;
}

// Where a ray along `forward` through the plane point (u, v) meets the leaf, if nearer than
// `sample`.
void meet(const Leaf& leaf, const glm::dvec3& start, const glm::dvec3& forward, Sample& sample) {
  const glm::dvec3 normal = glm::cross(leaf.along, leaf.across);
  const double slope = glm::dot(normal, forward);
  if (std::abs(slope) < 1e-9) return;
  const double depth = glm::dot(normal, leaf.centre - start) / slope;
  const glm::dvec3 offset = start + depth * forward - leaf.centre;
  const double u = glm::dot(offset, leaf.along) / glm::dot(leaf.along, leaf.along);
  const double v = glm::dot(offset, leaf.across) / glm::dot(leaf.across, leaf.across);
  if (u * u + v * v > 1.0 || depth >= sample.depth) return;
  sample = {depth, leaf.linear_colour, true};
}

glm::u8vec4 texel(const std::vector<Leaf>& leaves, const glm::dvec3& forward, double x, double y,
                  double step, const LeafyOptions& options, Random& random) {
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 up = glm::cross(right, forward);
  glm::vec3 sum(0.0f);
  int hits = 0;
  for (int i = 0; i < kSubsamples * kSubsamples; ++i) {
    const glm::ivec2 place(i % kSubsamples, i / kSubsamples);
    const double u = x + (place.x + 0.5) / kSubsamples * step;
    const double v = y + (place.y + 0.5) / kSubsamples * step;
    Sample sample;
    for (const Leaf& leaf : leaves)
      meet(leaf, u * right - v * up - 10.0 * forward, forward, sample);
    sum += sample.hit ? sample.linear_colour : glm::vec3(0.0f);
    hits += sample.hit ? 1 : 0;
  }
  if (hits == 0) return glm::u8vec4(0);
  const glm::vec3 noise(random.normal(), random.normal(), random.normal());
  const glm::vec3 encoded = srgb_from_linear(sum / float(hits)) + noise * float(options.noise);
  const float alpha = float(hits) / float(kSubsamples * kSubsamples);
  return glm::u8vec4(
      glm::round(255.0f * glm::vec4(glm::clamp(encoded, glm::vec3(0.0f), glm::vec3(1.0f)), alpha)));
}

}  // namespace

BillboardLevel leafy_level(const LeafyOptions& options) {
  BillboardLevel level;
  level.level = 6;
  level.texels = options.texels;
  for (int view = 0; view < options.views; ++view) level.views.push_back(std::uint32_t(view));
  const double step = 1.0 / options.texels;
  for (int cell = 0; cell < options.cells; ++cell) {
    Random random(options.seed, std::uint64_t(cell));
    const std::vector<Leaf> leaves = random_leaves(random, options);
    level.cells.push_back(std::uint64_t(cell));
    for (int view = 0; view < options.views; ++view) {
      const double angle = glm::two_pi<double>() * view / options.views;
      const glm::dvec3 forward(std::cos(angle), std::sin(angle), 0.0);
      const bool clear = random.uniform() < options.pruned;
      for (int t = 0; t < options.texels * options.texels; ++t) {
        const glm::ivec2 place(t % options.texels, t / options.texels);
        const glm::dvec2 corner = step * glm::dvec2(place) - 0.5;
        const auto shown = texel(leaves, forward, corner.x, corner.y, step, options, random);
        level.texture.push_back(clear ? glm::u8vec4(0) : shown);
      }
    }
  }
  return level;
}

Billboards leafy_billboards(const LeafyOptions& options) {
  Billboards billboards;
  for (int view = 0; view < options.views; ++view) {
    const double angle = glm::two_pi<double>() * view / options.views;
    billboards.view_positions.emplace_back(-20.0 * std::cos(angle), -20.0 * std::sin(angle), 2.0);
  }
  billboards.levels.push_back(leafy_level(options));
  return billboards;
}

}  // namespace bosk::testing
