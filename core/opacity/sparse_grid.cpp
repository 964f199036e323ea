#include "core/opacity/sparse_grid.h"

#include <cassert>

namespace bosk {

namespace {

// Bits of a brick whose x or y is 0; bit x + 4 y + 16 z.
constexpr std::uint64_t kFirstX = 0x1111111111111111, kFirstY = 0x000f000f000f000f;

// A brick's cells and those above them along one axis: those that stay in the brick, and those that
// fall into the next one.
struct Spread {
  std::uint64_t within, beyond;
};
Spread along_x(std::uint64_t m) { return {m | (m << 1 & ~kFirstX), m >> 3 & kFirstX}; }
Spread along_y(std::uint64_t m) { return {m | (m << 4 & ~kFirstY), m >> 12 & kFirstY}; }
Spread along_z(std::uint64_t m) { return {m | m << 16, m >> 48}; }

// Calls visit(offset in bricks, cells there) for a brick's own place and the seven above.
template <class Visit>
void spread_brick(std::uint64_t occupied, Visit&& visit) {
  const Spread x = along_x(occupied);
  for (int i = 0; i < 2; ++i) {
    const Spread y = along_y(i == 0 ? x.within : x.beyond);
    for (int j = 0; j < 2; ++j) {
      const Spread z = along_z(j == 0 ? y.within : y.beyond);
      if (z.within != 0) visit(glm::ivec3(i, j, 0), z.within);
      if (z.beyond != 0) visit(glm::ivec3(i, j, 1), z.beyond);
    }
  }
}

}  // namespace

SparseGrid::SparseGrid(int level, const std::vector<glm::ivec3>& cells) : level_(level) {
  assert(level >= 2 && level <= 10);
  blocks_.assign(std::size_t(1) << (3 * block_shift()), kAbsent);
  for (const glm::ivec3& cell : cells) {
    assert(cell.x >= 0 && cell.y >= 0 && cell.z >= 0);
    assert(cell.x < side() && cell.y < side() && cell.z < side());
    blocks_[block_index(cell.x, cell.y, cell.z)] = 0;
  }
  const std::vector<glm::ivec3> corners = number_blocks();
  for (const glm::ivec3& cell : cells) {
    const std::int32_t block = blocks_[block_index(cell.x, cell.y, cell.z)];
    bricks_[brick_index(block, cell.x, cell.y, cell.z)].occupied |=
        std::uint64_t(1) << bit_index(cell.x, cell.y, cell.z);
  }
  number_cells(corners);
}

std::vector<glm::ivec3> SparseGrid::number_blocks() {
  std::vector<glm::ivec3> corners;
  const int mask = (1 << block_shift()) - 1;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (blocks_[i] == kAbsent) continue;
    blocks_[i] = std::int32_t(corners.size());
    corners.push_back(
        glm::ivec3(int(i) & mask, int(i >> block_shift()) & mask, int(i >> (2 * block_shift()))) *
        16);
  }
  bricks_.assign(corners.size() * 64, {});
  return corners;
}

void SparseGrid::number_cells(const std::vector<glm::ivec3>& corners) {
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

SparseGrid SparseGrid::grown() const {
  assert(level_ < 10);
  SparseGrid result;
  result.level_ = level_ + 1;
  result.blocks_.assign(std::size_t(1) << (3 * result.block_shift()), kAbsent);
  const auto for_each_spread = [&](auto&& visit) {
    for (const Brick& brick : bricks_) {
      if (brick.occupied == 0) continue;
      const glm::ivec3 corner = glm::ivec3(cells_[brick.first]) & ~3;
      spread_brick(brick.occupied, [&](const glm::ivec3& offset, std::uint64_t cells) {
        const glm::ivec3 at = corner + 4 * offset;
        visit(at, result.block_index(at.x, at.y, at.z), cells);
      });
    }
  };
  for_each_spread(
      [&](const glm::ivec3&, std::size_t block, std::uint64_t) { result.blocks_[block] = 0; });
  const std::vector<glm::ivec3> corners = result.number_blocks();
  for_each_spread([&](const glm::ivec3& at, std::size_t block, std::uint64_t cells) {
    result.bricks_[brick_index(result.blocks_[block], at.x, at.y, at.z)].occupied |= cells;
  });
  result.number_cells(corners);
  return result;
}

}  // namespace bosk
