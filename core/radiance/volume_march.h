#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "core/image/image.h"
#include "core/photo/camera.h"
#include "core/radiance/volume_snapshot.h"

namespace bosk {

// Premultiplied sRGB-encoded colour and alpha of every pixel of a pinhole camera, on all cores.
Image<glm::vec4> premultiplied_picture(const VolumeSnapshot& volume, const Camera& pinhole);

// Colour times extinction, and extinction per cell edge in w, at a point in cell units; `brick` is
// the one that holds the point, shifted by one.
inline glm::vec4 sample_brick(const VolumeSnapshot::Brick& brick, const glm::vec3& fraction,
                              const glm::ivec3& inside) {
  constexpr int kRow = VolumeSnapshot::kStored, kLayer = kRow * kRow;
  const VolumeSnapshot::Cell* first =
      &brick[std::size_t(inside.z * kLayer + inside.y * kRow + inside.x)];
  const glm::vec3 f = fraction, g = 1.0f - fraction;
  const float across[4] = {g.y * g.z, f.y * g.z, g.y * f.z, f.y * f.z};
  constexpr int kSteps[4] = {0, kRow, kLayer, kLayer + kRow};
  glm::vec4 sum(0.0f);
  for (int i = 0; i < 4; ++i) {
    for (int x = 0; x < 2; ++x) {
      const VolumeSnapshot::Cell& cell = first[kSteps[i] + x];
      const float extinction = across[i] * (x == 0 ? g.x : f.x) * cell.extinction;
      sum += glm::vec4(glm::vec3(cell.srgb), 1.0f) * extinction;
    }
  }
  return {glm::vec3(sum) / 255.0f, sum.w};
}

// The brick around base cell `base` (from -1 to side - 1), or null.
inline const VolumeSnapshot::Brick* brick_around(const VolumeSnapshot& volume,
                                                 const glm::ivec3& base) {
  const glm::ivec3 at = (base >> 3) + 1;
  const int across = volume.bricks_across();
  const std::int32_t number = volume.brick_at[std::size_t((at.z * across + at.y) * across + at.x)];
  return number < 0 ? nullptr : &volume.bricks[std::size_t(number)];
}

}  // namespace bosk
