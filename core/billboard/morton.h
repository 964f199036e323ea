#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace bosk {

// Morton codes: bits of x, y and z interleaved, x lowest. Up to 21 bits an axis.
inline std::uint64_t spread_bits(std::uint64_t value) {
  value &= 0x1fffff;
  value = (value | value << 32) & 0x1f00000000ffff;
  value = (value | value << 16) & 0x1f0000ff0000ff;
  value = (value | value << 8) & 0x100f00f00f00f00f;
  value = (value | value << 4) & 0x10c30c30c30c30c3;
  return (value | value << 2) & 0x1249249249249249;
}

inline std::uint64_t gathered_bits(std::uint64_t code) {
  code &= 0x1249249249249249;
  code = (code | code >> 2) & 0x10c30c30c30c30c3;
  code = (code | code >> 4) & 0x100f00f00f00f00f;
  code = (code | code >> 8) & 0x1f0000ff0000ff;
  code = (code | code >> 16) & 0x1f00000000ffff;
  return (code | code >> 32) & 0x1fffff;
}

inline std::uint64_t morton_from_cell(const glm::ivec3& cell) {
  return spread_bits(std::uint64_t(cell.x)) | spread_bits(std::uint64_t(cell.y)) << 1 |
         spread_bits(std::uint64_t(cell.z)) << 2;
}

inline glm::ivec3 cell_from_morton(std::uint64_t code) {
  return {int(gathered_bits(code)), int(gathered_bits(code >> 1)), int(gathered_bits(code >> 2))};
}

}  // namespace bosk
