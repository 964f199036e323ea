#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "core/image/image.h"
#include "core/photo/camera.h"
#include "core/radiance/volume_snapshot.h"

namespace bosk {

// Premultiplied sRGB-encoded colour and alpha of every pixel of a pinhole camera, on all cores.
Image<glm::vec4> premultiplied_picture(const VolumeSnapshot& volume, const Camera& pinhole);

// Colour times extinction, and extinction per cell edge in w, between the cells of a brick that
// begin at `inside` (each 0 to 7).
inline glm::vec4 sample_brick(const VolumeSnapshot::Brick& brick, const glm::vec3& fraction,
                              const glm::ivec3& inside) {
  using Bytes = std::uint8_t __attribute__((vector_size(4)));
  using Floats = float __attribute__((vector_size(16)));
  constexpr int kRow = VolumeSnapshot::kStored, kLayer = kRow * kRow;
  constexpr int kSteps[4] = {0, kRow, kLayer, kLayer + kRow};
  const VolumeSnapshot::Cell* first =
      &brick.cells[std::size_t(inside.z * kLayer + inside.y * kRow + inside.x)];
  const glm::vec3 f = fraction, g = 1.0f - fraction;
  const float across[4] = {g.y * g.z, f.y * g.z, g.y * f.z, f.y * f.z};
  Floats sum = {0.0f, 0.0f, 0.0f, 0.0f};
  for (int i = 0; i < 4; ++i) {
    for (int x = 0; x < 2; ++x) {
      const VolumeSnapshot::Cell& cell = first[kSteps[i] + x];
      const float extinction = across[i] * (x == 0 ? g.x : f.x) * cell.extinction;
      sum += __builtin_convertvector(std::bit_cast<Bytes>(cell.srgb), Floats) * extinction;
    }
  }
  sum *= 1.0f / 255.0f;  // the fourth byte is 255: what is left of it is the extinction
  return {sum[0], sum[1], sum[2], sum[3]};
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
