#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/package/format.h"

namespace bosk {

// The sections of a package, none decoded yet. Refers to the file's bytes.
struct Container {
  std::uint16_t major_version = 0, minor_version = 0;
  std::vector<SectionEntry> sections;
  std::span<const std::byte> file;
};

// Checks header, table, layout, padding, limits and every checksum. Throws Error.
Container open_container(std::span<const std::byte> file);

// Null when the package has no such section.
const SectionEntry* find_section(const Container& container, std::uint32_t type,
                                 std::uint32_t instance = 0);

// The decoded bytes of one section, exactly `raw_length` of them. Throws Error, also when it is
// missing.
std::vector<std::byte> section_bytes(const Container& container, std::uint32_t type,
                                     std::uint32_t instance = 0);

// "CELL 3": for messages and listings.
std::string section_name(std::uint32_t type, std::uint32_t instance);

}  // namespace bosk
