#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/package/format.h"

namespace bosk {

// A package taken apart, to be put together again with something changed and every checksum right.
struct PackagePart {
  std::uint32_t type = 0, instance = 0;
  std::uint16_t codec = kStored, flags = kRequired;
  std::string bytes;  // as in the file
  std::uint64_t raw_length = 0;
};
struct PackageParts {
  std::uint16_t major_version = kMajorVersion, minor_version = kMinorVersion;
  std::vector<PackagePart> parts;
};

PackageParts take_apart(const std::string& package);
std::string put_together(const PackageParts& parts);

std::string raw_bytes(const PackagePart& part);             // decoded; the part must be sound
void set_raw_bytes(PackagePart& part, const std::string&);  // stored, not compressed

// Puts right the checksums of header and table (not those of sections), as far as there is a table.
void reseal(std::string& package);

}  // namespace bosk
