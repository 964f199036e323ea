#include "core/package/container.h"

#include <xxhash.h>
#include <zstd.h>

#include <algorithm>
#include <array>

#include "core/package/byte_cursor.h"

namespace bosk {
namespace {

constexpr std::array kKnownTypes{kMetadataSection, kSceneSection, kLevelsSection,
                                 kAtlasSection,    kBc3Section,   kCellsSection,
                                 kLiveSection,     kAlphaSection, kColourSection};

struct Header {
  std::uint16_t major_version = 0, minor_version = 0;
  std::uint32_t section_count = 0;
  std::uint64_t table_checksum = 0;
};

bool all_zero(std::span<const std::byte> bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](std::byte b) { return b == std::byte(0); });
}

// The magic and the version come first: a newer package is told from a damaged one.
Header read_header(std::span<const std::byte> file) {
  if (file.size() < kHeaderBytes) damaged("the file is too short for a header");
  if (std::memcmp(file.data(), kMagic.data(), kMagic.size()) != 0) {
    throw Error("this is no Bosk tree package (or a transfer as text changed it)");
  }
  ByteCursor cursor(file.subspan(kMagic.size(), kHeaderBytes - kMagic.size()), "header");
  Header header;
  header.major_version = cursor.value<std::uint16_t>();
  header.minor_version = cursor.value<std::uint16_t>();
  if (header.major_version > kMajorVersion) {
    throw Error("this package has format " + std::to_string(header.major_version) + "." +
                std::to_string(header.minor_version) + ", this Bosk reads up to " +
                std::to_string(kMajorVersion) + ".x: it needs a newer Bosk");
  }
  if (XXH3_64bits(file.data(), 56) !=
      ByteCursor(file.subspan(56), "header").value<std::uint64_t>()) {
    damaged("header: wrong checksum");
  }
  if (header.major_version < kMajorVersion) {
    throw Error("this package has format " + std::to_string(header.major_version) +
                ".x, which this Bosk no longer reads; pack the tree again");
  }
  if (cursor.value<std::uint32_t>() != kByteOrderMark) damaged("header: byte order");
  if (cursor.value<std::uint64_t>() != file.size()) damaged("the file was cut short or added to");
  header.section_count = cursor.value<std::uint32_t>();
  if (cursor.value<std::uint32_t>() != 0) damaged("header: a reserved field is used");
  header.table_checksum = cursor.value<std::uint64_t>();
  if (!all_zero(cursor.take(16))) damaged("header: a reserved field is used");
  return header;
}

SectionEntry read_entry(ByteCursor& cursor) {
  SectionEntry entry;
  entry.type = cursor.value<std::uint32_t>();
  entry.instance = cursor.value<std::uint32_t>();
  entry.codec = cursor.value<std::uint16_t>();
  entry.flags = cursor.value<std::uint16_t>();
  if (cursor.value<std::uint32_t>() != 0) damaged("section table: a reserved field is used");
  entry.offset = cursor.value<std::uint64_t>();
  entry.length = cursor.value<std::uint64_t>();
  entry.raw_length = cursor.value<std::uint64_t>();
  entry.checksum = cursor.value<std::uint64_t>();
  return entry;
}

bool is_known(std::uint32_t type) {
  return std::find(kKnownTypes.begin(), kKnownTypes.end(), type) != kKnownTypes.end();
}

void check_kind(const SectionEntry& entry, const std::string& name) {
  if ((entry.flags & kRequired) != 0 && !is_known(entry.type)) {
    throw Error("this package has a part '" + name +
                "' that this Bosk does not know: it needs a newer Bosk");
  }
  if (is_known(entry.type) && entry.codec > kZstd) damaged(name + ": unknown codec");
  if (entry.codec == kStored && entry.raw_length != entry.length)
    damaged(name + ": lengths differ");
  if (entry.raw_length / kMaxRatio > entry.length)
    damaged(name + ": packed too tightly to be true");
}

// Sections follow each other without a gap, so none can overlap and no byte goes unchecked.
void check_place(const SectionEntry& entry, std::span<const std::byte> file,
                 std::uint64_t& expected, const std::string& name) {
  if (entry.offset != expected || entry.offset > file.size() ||
      entry.length > file.size() - entry.offset) {
    damaged(name + ": not where it should be");
  }
  const std::uint64_t padding = (0 - entry.length) % kSectionAlignment;
  expected = entry.offset + entry.length + padding;
  if (expected > file.size() || !all_zero(file.subspan(entry.offset + entry.length, padding))) {
    damaged(name + ": padding");
  }
  if (XXH3_64bits(file.data() + entry.offset, entry.length) != entry.checksum) {
    damaged(name + ": wrong checksum");
  }
}

void decompress(std::span<const std::byte> packed, std::span<std::byte> raw,
                const std::string& name) {
  if (ZSTD_getFrameContentSize(packed.data(), packed.size()) != raw.size() ||
      ZSTD_findFrameCompressedSize(packed.data(), packed.size()) != packed.size() ||
      ZSTD_decompress(raw.data(), raw.size(), packed.data(), packed.size()) != raw.size()) {
    damaged(name + ": cannot be unpacked");
  }
}

}  // namespace

std::string section_name(std::uint32_t type, std::uint32_t instance) {
  std::string name;
  for (int i = 0; i < 4; ++i) {
    const char letter = char(type >> (8 * i) & 0xff);
    if (letter != ' ') name += letter > ' ' && letter < 0x7f ? letter : '?';
  }
  return name + " " + std::to_string(instance);
}

Container open_container(std::span<const std::byte> file) {
  const Header header = read_header(file);
  if (header.section_count > kMaxSections ||
      header.section_count > (file.size() - kHeaderBytes) / kEntryBytes) {
    damaged("header: too many sections");
  }
  const auto table = file.subspan(kHeaderBytes, header.section_count * kEntryBytes);
  if (XXH3_64bits(table.data(), table.size()) != header.table_checksum) {
    damaged("section table: wrong checksum");
  }
  Container container{header.major_version, header.minor_version, {}, file};
  ByteCursor cursor(table, "section table");
  std::uint64_t expected = kHeaderBytes + table.size(), raw_total = 0;
  for (std::uint32_t i = 0; i < header.section_count; ++i) {
    const SectionEntry entry = read_entry(cursor);
    const std::string name = section_name(entry.type, entry.instance);
    check_place(entry, file, expected, name);
    check_kind(entry, name);
    raw_total += std::min(entry.raw_length, kMaxRawBytes + 1);
    if (find_section(container, entry.type, entry.instance)) damaged(name + ": there twice");
    container.sections.push_back(entry);
  }
  if (expected != file.size()) damaged("bytes behind the last section");
  if (raw_total > kMaxRawBytes) damaged("larger than any package may be");
  return container;
}

const SectionEntry* find_section(const Container& container, std::uint32_t type,
                                 std::uint32_t instance) {
  for (const SectionEntry& entry : container.sections) {
    if (entry.type == type && entry.instance == instance) return &entry;
  }
  return nullptr;
}

std::vector<std::byte> section_bytes(const Container& container, std::uint32_t type,
                                     std::uint32_t instance) {
  const std::string name = section_name(type, instance);
  const SectionEntry* entry = find_section(container, type, instance);
  if (!entry) damaged(name + ": missing");
  const auto packed = container.file.subspan(entry->offset, entry->length);
  if (entry->codec == kStored) return {packed.begin(), packed.end()};
  std::vector<std::byte> raw(entry->raw_length);
  decompress(packed, raw, name);
  return raw;
}

}  // namespace bosk
