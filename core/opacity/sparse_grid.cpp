#include "core/opacity/sparse_grid.h"

#include <cassert>

namespace bosk {

SparseGrid::SparseGrid(int level, const std::vector<glm::ivec3>& cells) : level_(level) {
  assert(level >= 2 && level <= 10);
  // Number the blocks that hold any cell, row by row
  blocks_.assign(std::size_t(1) << (3 * block_shift()), kAbsent);
  for (const glm::ivec3& cell : cells) {
    assert(cell.x >= 0 && cell.y >= 0 && cell.z >= 0);
    assert(cell.x < side() && cell.y < side() && cell.z < side());
    blocks_[block_index(cell.x, cell.y, cell.z)] = 0;
  }
  std::vector<glm::ivec3> corners;
  const int mask = (1 << block_shift()) - 1;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (blocks_[i] == kAbsent) continue;
    blocks_[i] = std::int32_t(corners.size());
    corners.push_back(
        glm::ivec3(int(i) & mask, int(i >> block_shift()) & mask, int(i >> (2 * block_shift()))) *
        16);
  }

  // Fill their bricks, then number the cells
  bricks_.resize(corners.size() * 64);
  for (const glm::ivec3& cell : cells) {
    const std::int32_t block = blocks_[block_index(cell.x, cell.y, cell.z)];
    bricks_[brick_index(block, cell.x, cell.y, cell.z)].occupied |=
        std::uint64_t(1) << bit_index(cell.x, cell.y, cell.z);
  }
  for (std::size_t i = 0; i < bricks_.size(); ++i) {
    Brick& brick = bricks_[i];
    brick.first = std::uint32_t(cells_.size());
    const int number = int(i & 63);
    const glm::ivec3 corner =
        corners[i / 64] + 4 * glm::ivec3(number & 3, number >> 2 & 3, number >> 4);
    for (std::uint64_t left = brick.occupied; left != 0; left &= left - 1) {
      const int bit = __builtin_ctzll(left);
      cells_.emplace_back(corner + glm::ivec3(bit & 3, bit >> 2 & 3, bit >> 4));
    }
  }
}

}  // namespace bosk
