#include "core/opacity/sparse_grid.h"

#include <cassert>

namespace bosk {

SparseGrid::SparseGrid(int level, const std::vector<glm::ivec3>& cells) : level_(level) {
  assert(level >= 2 && level <= 10);
  const std::size_t bricks_a_side = std::size_t(1) << (level - 2);
  bricks_.resize(bricks_a_side * bricks_a_side * bricks_a_side);
  if (level >= 4) block_occupied_.resize(std::size_t(1) << (3 * (level - 4)));
  for (const glm::ivec3& cell : cells) {
    assert(cell.x >= 0 && cell.y >= 0 && cell.z >= 0);
    assert(cell.x < side() && cell.y < side() && cell.z < side());
    bricks_[brick_index(cell.x, cell.y, cell.z)].occupied |= std::uint64_t(1)
                                                             << bit_index(cell.x, cell.y, cell.z);
    if (level >= 4) block_occupied_[block_index(cell.x, cell.y, cell.z)] = 1;
  }
  const int shift = level - 2, mask = (1 << shift) - 1;
  for (std::size_t i = 0; i < bricks_.size(); ++i) {
    Brick& brick = bricks_[i];
    brick.first = std::uint32_t(cells_.size());
    const glm::ivec3 corner(int(i) & mask, int(i >> shift) & mask, int(i >> (2 * shift)));
    for (std::uint64_t left = brick.occupied; left != 0; left &= left - 1) {
      const int bit = __builtin_ctzll(left);
      cells_.emplace_back(corner * 4 + glm::ivec3(bit & 3, bit >> 2 & 3, bit >> 4));
    }
  }
}

}  // namespace bosk
