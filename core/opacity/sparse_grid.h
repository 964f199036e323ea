#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace bosk {

// A set of cells of a cubic grid of 2^level cells a side, each cell with a number 0, 1, ... in a
// fixed order (blocks of 16x16x16 row by row, their 4x4x4 bricks row by row, cells of a brick row
// by row). Looking a cell up costs a 4-byte load, a 16-byte load and a population count. Memory: 4
// bytes per block of the full grid, 1 KiB per block that holds a cell, 6 bytes per cell.
class SparseGrid {
 public:
  static constexpr std::int32_t kAbsent = -1;

  SparseGrid() = default;
  // `cells` may be in any order and repeat. Level 2 to 10.
  SparseGrid(int level, const std::vector<glm::ivec3>& cells);

  // The cells and those {0, 1}^3 above them, in a grid of twice the side: a brick at a time, by its
  // bits.
  SparseGrid grown() const;

  int level() const { return level_; }
  int side() const { return 1 << level_; }
  std::size_t size() const { return cells_.size(); }
  // Cells in the order of their numbers.
  const std::vector<glm::u16vec3>& cells() const { return cells_; }

  // The cell's number, or kAbsent; also outside the grid.
  std::int32_t find(int x, int y, int z) const {
    const auto limit = static_cast<unsigned>(side());
    if (unsigned(x) >= limit || unsigned(y) >= limit || unsigned(z) >= limit) return kAbsent;
    const std::int32_t block = blocks_[block_index(x, y, z)];
    if (block == kAbsent) return kAbsent;
    const Brick& brick = bricks_[brick_index(block, x, y, z)];
    const std::uint64_t bit = std::uint64_t(1) << bit_index(x, y, z);
    if ((brick.occupied & bit) == 0) return kAbsent;
    return std::int32_t(brick.first) + __builtin_popcountll(brick.occupied & (bit - 1));
  }
  // Edge of the largest aligned block of 16 or 4 cells around (x, y, z) that holds no cell of the
  // set; 0 when even its 4x4x4 brick holds one. Must be inside the grid.
  int empty_block(int x, int y, int z) const {
    const std::int32_t block = blocks_[block_index(x, y, z)];
    if (block == kAbsent) return 16;
    return bricks_[brick_index(block, x, y, z)].occupied == 0 ? 4 : 0;
  }

 private:
  struct Brick {
    std::uint64_t occupied = 0;
    std::uint32_t first = 0;
    std::uint32_t unused = 0;
  };
  // Lower corners of the blocks marked in blocks_, which are numbered in that order.
  std::vector<glm::ivec3> number_blocks();
  // Numbers the cells that the bricks hold; `corners` of the blocks.
  void number_cells(const std::vector<glm::ivec3>& corners);
  std::size_t block_index(int x, int y, int z) const {
    const int shift = block_shift();
    return (((std::size_t(z) >> 4) << shift | (std::size_t(y) >> 4)) << shift) |
           (std::size_t(x) >> 4);
  }
  static std::size_t brick_index(std::int32_t block, int x, int y, int z) {
    return std::size_t(block) << 6 |
           std::size_t((z >> 2 & 3) << 4 | (y >> 2 & 3) << 2 | (x >> 2 & 3));
  }
  static int bit_index(int x, int y, int z) { return (z & 3) << 4 | (y & 3) << 2 | (x & 3); }
  int block_shift() const { return level_ > 4 ? level_ - 4 : 0; }

  int level_ = 2;
  std::vector<std::int32_t> blocks_;  // of 16x16x16 cells: numbers of those that hold any
  std::vector<Brick> bricks_;         // 64 of each block
  std::vector<glm::u16vec3> cells_;
};

}  // namespace bosk
