#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/error.h"

// The runtime package `.bosk`. Little-endian; README.md draws every section byte by byte.
//
//   offset size
//        0    8  magic: 89 'B' 'O' 'S' 'K' 0d 0a 1a    CR LF shows a transfer that changed line
//        ends 8    2  major version                         a newer one is refused
//       10    2  minor version                         a newer one opens
//       12    4  byte order mark: 04 03 02 01
//       16    8  length of the file, bytes
//       24    4  section count S
//       28    4  zero
//       32    8  xxh3-64 of the section table
//       40   16  zero
//       56    8  xxh3-64 of bytes 0 to 55
//       64  48S  section table; an entry:
//                  0  4  type, four letters          4  4  instance: position of its level, else 0
//                  8  2  codec: 0 stored, 1 zstd    10  2  flags: bit 0 = a reader must know the
//                  type
//                 12  4  zero                       16  8  offset in the file
//                 24  8  length in the file         32  8  length once decoded
//                 40  8  xxh3-64 of the bytes in the file
//   64+48S       sections, in the order of the table, each padded with zeros to a multiple of 8
//   bytes
//
// Nothing lies between or behind the sections, so every bit of the file is checked.
namespace bosk {

static_assert(std::endian::native == std::endian::little, "packages are read in place");

inline constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'B', 'O', 'S', 'K', 0x0d, 0x0a, 0x1a};
inline constexpr std::uint16_t kMajorVersion = 2, kMinorVersion = 0;
inline constexpr std::uint32_t kByteOrderMark = 0x01020304;
inline constexpr std::size_t kHeaderBytes = 64, kEntryBytes = 48, kSectionAlignment = 8;

inline constexpr std::uint16_t kStored = 0, kZstd = 1;
inline constexpr std::uint16_t kRequired = 1;

constexpr std::uint32_t section_type(const char (&letters)[5]) {
  std::uint32_t type = 0;
  for (int i = 0; i < 4; ++i)
    type |= std::uint32_t(static_cast<unsigned char>(letters[i])) << (8 * i);
  return type;
}
inline constexpr std::uint32_t kMetadataSection = section_type("META");
inline constexpr std::uint32_t kSceneSection = section_type("SCEN");
inline constexpr std::uint32_t kLevelsSection = section_type("LEVL");
inline constexpr std::uint32_t kAtlasSection = section_type("ATLS");
inline constexpr std::uint32_t kBc3Section = section_type("BC3 ");
inline constexpr std::uint32_t kCellsSection = section_type("CELL");
inline constexpr std::uint32_t kLiveSection = section_type("LIVE");
inline constexpr std::uint32_t kAlphaSection = section_type("ALPH");
inline constexpr std::uint32_t kColourSection = section_type("COLR");

// Published limits: a file beyond them is refused before memory is asked for.
inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t(256) << 20;
inline constexpr std::uint64_t kMaxRawBytes = std::uint64_t(256) << 20;  // all sections together
inline constexpr std::uint64_t kMaxRatio = 1000;  // decoded : stored, a section
inline constexpr std::uint32_t kMaxSections = 256;
inline constexpr std::uint32_t kMaxLevels = 13;  // octree levels 0 to 12
inline constexpr std::uint32_t kMaxViews = 4096;
inline constexpr std::uint64_t kMaxCells = std::uint64_t(1) << 24;    // all levels together
inline constexpr std::uint64_t kMaxIndices = std::uint64_t(1) << 26;  // alpha, all levels together
inline constexpr std::uint32_t kMaxCodewords = 4096;                  // a range
inline constexpr int kMaxAtlasPx = 512;
inline constexpr std::uint32_t kMaxTextBytes = 65536;  // one metadata key or value
inline constexpr std::uint32_t kMaxMetadata = 1024;    // entries

struct SectionEntry {
  std::uint32_t type = 0, instance = 0;
  std::uint16_t codec = kStored, flags = kRequired;
  std::uint64_t offset = 0, length = 0, raw_length = 0, checksum = 0;
};

[[noreturn]] inline void damaged(const std::string& what) {
  throw Error("the tree package is damaged (" + what + "); copy it again or pack the tree again");
}

}  // namespace bosk
