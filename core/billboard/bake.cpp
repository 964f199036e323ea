#include "core/billboard/bake.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/billboard/morton.h"
#include "core/geometry/box.h"
#include "core/radiance/harmonics.h"

namespace bosk {
namespace {

constexpr int kTexelSamples = 2;  // rays along each edge of a texel

struct Axes {
  glm::dvec3 forward, right, up;
};

// As package/tree_model.h defines them.
Axes axes_towards(const glm::dvec3& centre, const glm::dvec3& viewpoint) {
  const glm::dvec3 forward = glm::normalize(centre - viewpoint);
  const glm::dvec3 across = glm::cross(forward, glm::dvec3(0, 0, 1));
  const double size = glm::length(across);
  const glm::dvec3 right = size > 1e-6 ? across / size : glm::dvec3(1, 0, 0);
  return {forward, right, glm::cross(right, forward)};
}

glm::u8vec4 texel_of(const glm::vec3& straight, float alpha) {
  const glm::vec4 rounded =
      glm::floor(glm::clamp(glm::vec4(straight, alpha), 0.0f, 1.0f) * 255.0f + 0.5f);
  return glm::u8vec4(rounded);
}

glm::vec3 cell_colour(const RadianceVolume& volume, std::size_t cell, const glm::vec3& direction) {
  const auto basis = harmonics(direction);
  const auto terms = std::size_t(volume.coefficients());
  glm::vec3 colour(0.0f);
  for (std::size_t j = 0; j < terms; ++j) {
    const float* c = &volume.colour[(cell * terms + j) * 3];
    colour += basis[j] * glm::vec3(c[0], c[1], c[2]);
  }
  return colour;
}

// The tent kernel's means over the four texels of two cells.
constexpr std::array<float, 4> kTent{0.25f, 0.75f, 0.75f, 0.25f};

void bake_cube(const RadianceVolume& volume, const VolumeSampler& sampler,
               const BillboardLevel& level, const glm::dvec3& lower, double edge,
               const glm::dvec3& view, glm::u8vec4* texture) {
  const glm::dvec3 centre = lower + 0.5 * edge;
  const Axes axes = axes_towards(centre, view);
  const auto basis = harmonics(glm::vec3(axes.forward));
  const Cube cube{volume.origin, volume.size_m};
  const double cell_m = volume.cell_m();
  const Box box{lower, lower + edge};
  const double texel_m = double(level.side_factor) * edge / level.texels;
  const double far = 2.0 * edge;
  for (int row = 0; row < level.texels; ++row) {
    for (int column = 0; column < level.texels; ++column) {
      glm::vec4 sum(0.0f);
      for (int s = 0; s < kTexelSamples * kTexelSamples; ++s) {
        const glm::ivec2 sample(s % kTexelSamples, s / kTexelSamples);
        const glm::dvec2 in_texel = (glm::dvec2(sample) + 0.5) / double(kTexelSamples);
        const glm::dvec2 offset =
            (glm::dvec2(column, row) + in_texel - 0.5 * level.texels) * texel_m;
        const glm::dvec3 start =
            centre + offset.x * axes.right - offset.y * axes.up - far * axes.forward;
        const auto inside = intersect({start, axes.forward}, box);
        if (!inside) continue;
        sum += integrate(sampler, cells_from_world(start, cube, volume.grid.level()), axes.forward,
                         float(inside->enter / cell_m), float(inside->leave / cell_m), basis);
      }
      const float alpha = sum.a / float(kTexelSamples * kTexelSamples);
      const glm::vec3 straight = sum.a > 0.0f ? glm::vec3(sum) / sum.a : glm::vec3(0.0f);
      texture[row * level.texels + column] = texel_of(straight, alpha);
    }
  }
}

}  // namespace

void bake_kernels(const RadianceVolume& volume, const std::vector<glm::dvec3>& views,
                  BillboardLevel& level, Progress& progress) {
  std::vector<std::uint64_t> codes(volume.grid.size());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    codes[i] = morton_from_cell(glm::ivec3(volume.grid.cells()[i]));
  }
  std::vector<std::uint32_t> order(codes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return codes[a] < codes[b]; });

  level.texels = 4;
  level.side_factor = 2.0f;
  level.cells.resize(codes.size());
  level.texture.resize(codes.size() * level.views.size() * level.texture_size());
  progress.begin("Textures of level " + std::to_string(level.level), codes.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, codes.size(), 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const std::size_t cell = order[i];
      level.cells[i] = codes[cell];
      const glm::dvec3 centre =
          volume.origin + (glm::dvec3(volume.grid.cells()[cell]) + 0.5) * volume.cell_m();
      for (std::size_t v = 0; v < level.views.size(); ++v) {
        const glm::vec3 direction = glm::normalize(centre - views[level.views[v]]);
        const glm::vec3 colour = cell_colour(volume, cell, direction);
        glm::u8vec4* texture = &level.texture[(i * level.views.size() + v) * 16];
        for (std::size_t t = 0; t < 16; ++t) {
          const float depth = volume.extinction[cell] * kTent[t / 4] * kTent[t % 4];
          texture[t] = texel_of(colour, 1.0f - std::exp(-depth));
        }
      }
    }
    progress.advance(range.size());
  });
}

void bake_cubes(const RadianceVolume& volume, const VolumeSampler& sampler,
                const std::vector<glm::dvec3>& views, BillboardLevel& level, Progress& progress) {
  const double edge = volume.size_m / double(1 << level.level);
  const std::size_t per_view = level.texture_size();
  level.texture.assign(level.cells.size() * level.views.size() * per_view, glm::u8vec4(0));
  progress.begin("Textures of level " + std::to_string(level.level), level.cells.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, level.cells.size(), 64),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) {
                        const glm::dvec3 lower =
                            volume.origin + glm::dvec3(cell_from_morton(level.cells[i])) * edge;
                        for (std::size_t v = 0; v < level.views.size(); ++v) {
                          bake_cube(volume, sampler, level, lower, edge, views[level.views[v]],
                                    &level.texture[(i * level.views.size() + v) * per_view]);
                        }
                      }
                      progress.advance(range.size());
                    });
}

}  // namespace bosk
