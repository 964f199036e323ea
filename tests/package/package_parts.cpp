#include "tests/package/package_parts.h"

#include <xxhash.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>

#include "core/package/container.h"

namespace bosk {
namespace {

template <class T>
void put(std::string& text, T value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void put_entry(std::string& table, const PackagePart& part, std::uint64_t offset) {
  put(table, part.type);
  put(table, part.instance);
  put(table, part.codec);
  put(table, part.flags);
  put(table, std::uint32_t(0));
  put(table, offset);
  put(table, std::uint64_t(part.bytes.size()));
  put(table, part.raw_length);
  put(table, std::uint64_t(XXH3_64bits(part.bytes.data(), part.bytes.size())));
}

template <class T>
void set(std::string& text, std::size_t at, T value) {
  std::memcpy(text.data() + at, &value, sizeof(T));
}

}  // namespace

PackageParts take_apart(const std::string& package) {
  const Container container = open_container(std::as_bytes(std::span(package)));
  PackageParts apart{container.major_version, container.minor_version, {}};
  for (const SectionEntry& entry : container.sections) {
    apart.parts.push_back({entry.type, entry.instance, entry.codec, entry.flags,
                           package.substr(entry.offset, entry.length), entry.raw_length});
  }
  return apart;
}

std::string put_together(const PackageParts& apart) {
  std::string table, body;
  const std::uint64_t first = kHeaderBytes + apart.parts.size() * kEntryBytes;
  for (const PackagePart& part : apart.parts) {
    put_entry(table, part, first + body.size());
    body += part.bytes;
    body.resize((body.size() + 7) / 8 * 8);
  }
  std::string package(kHeaderBytes, '\0');
  std::memcpy(package.data(), kMagic.data(), kMagic.size());
  set(package, 8, apart.major_version);
  set(package, 10, apart.minor_version);
  set(package, 12, kByteOrderMark);
  set(package, 16, std::uint64_t(first + body.size()));
  set(package, 24, std::uint32_t(apart.parts.size()));
  package += table + body;
  reseal(package);
  return package;
}

std::string raw_bytes(const PackagePart& part) {
  if (part.codec == kStored) return part.bytes;
  std::string raw(part.raw_length, '\0');
  ZSTD_decompress(raw.data(), raw.size(), part.bytes.data(), part.bytes.size());
  return raw;
}

void set_raw_bytes(PackagePart& part, const std::string& raw) {
  part.codec = kStored;
  part.bytes = raw;
  part.raw_length = raw.size();
}

void reseal(std::string& package) {
  if (package.size() < kHeaderBytes) return;
  std::uint32_t count = 0;
  std::memcpy(&count, package.data() + 24, sizeof(count));
  const std::size_t table = std::min(package.size() - kHeaderBytes, count * kEntryBytes);
  set(package, 32, std::uint64_t(XXH3_64bits(package.data() + kHeaderBytes, table)));
  set(package, 56, std::uint64_t(XXH3_64bits(package.data(), 56)));
}

}  // namespace bosk
