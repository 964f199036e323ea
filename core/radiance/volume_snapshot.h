#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/geometry/box.h"
#include "core/opacity/opacity.h"
#include "core/radiance/radiance.h"

namespace bosk {

// A copy of a volume to look at while the original is worked on: dense bricks of 8x8x8 cells where
// there is anything, so that a point is looked up at once. Colour is the mean over all directions.
struct VolumeSnapshot {
  static constexpr int kBrick = 8;            // cells along a brick's edge
  static constexpr int kStored = kBrick + 1;  // and stored: the first layer of the next bricks too
  static constexpr std::int32_t kNone = -1;

  struct Cell {
    float extinction = 0.0f;               // per cell edge
    glm::u8vec4 srgb{128, 128, 128, 255};  // straight; a is always 255
  };
  struct Brick {
    std::array<Cell, std::size_t(kStored* kStored* kStored)> cells{};  // x fastest
    // Of each layer, bit 8 y + x: whether there is anything between the cell and its neighbours.
    std::array<std::uint64_t, kBrick> layers{};

    bool any(const glm::ivec3& inside) const {
      return (layers[std::size_t(inside.z)] >> (8 * inside.y + inside.x) & 1) != 0;
    }
  };

  glm::dvec3 origin{0.0};  // lower corner of the cube, world
  double size_m = 1.0;
  int level = 3;                       // 2^level cells a side
  bool has_colour = false;             // else all cells are grey
  std::vector<std::int32_t> brick_at;  // x fastest, shifted by one brick; kNone where empty
  std::vector<Brick> bricks;
  std::size_t cells = 0;  // that hold something
  Box bounds;             // of the cells, world; the cube where there are none

  int side() const { return 1 << level; }
  int bricks_across() const { return (side() + kBrick - 1) / kBrick + 1; }
};

// `finest_level`: cells finer than that are merged into their ancestors, which keep the light that
// crosses them, to first order. Level 7 takes a fraction of the time and memory.
VolumeSnapshot snapshot_of(const OpacityTree& tree, int finest_level = 9);
VolumeSnapshot snapshot_of(const RadianceVolume& volume, int finest_level = 9);

}  // namespace bosk
