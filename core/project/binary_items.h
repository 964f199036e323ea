#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/binary.h"
#include "core/base/error.h"
#include "core/calibrate/lens_profile.h"
#include "core/photo/camera.h"

namespace bosk {

// Pieces that several entries of the cache are made of, beside what BinaryWriter knows.

template <class T>
void write_optional(BinaryWriter& writer, const std::optional<T>& item) {
  writer.value(std::uint8_t(item.has_value()));
  if (item) writer.value(*item);
}

template <class T>
std::optional<T> read_optional(BinaryReader& reader) {
  if (reader.value<std::uint8_t>() == 0) return std::nullopt;
  return reader.value<T>();
}

template <class Item, class WriteItem>
void write_list(BinaryWriter& writer, const std::vector<Item>& items, WriteItem write_item) {
  writer.value(std::uint64_t(items.size()));
  for (const Item& item : items) write_item(writer, item);
}

// The count is believed only as far as the bytes go: each item takes some.
template <class ReadItem>
auto read_list(BinaryReader& reader, ReadItem read_item) {
  std::vector<decltype(read_item(reader))> items;
  for (auto left = reader.value<std::uint64_t>(); left > 0; --left) {
    items.push_back(read_item(reader));
  }
  return items;
}

// One of an enumeration's first `count` values.
template <class Kind>
Kind read_kind(BinaryReader& reader, std::uint8_t count) {
  const auto value = reader.value<std::uint8_t>();
  if (value >= count) throw Error("there is no such kind");
  return Kind(value);
}

// All of the bytes. Throws Error when something is left.
template <class T, class Read>
T read_all(std::span<const std::byte> bytes, Read read_result) {
  BinaryReader reader(bytes);
  T result = read_result(reader);
  if (!reader.at_end()) throw Error("stored result is too long");
  return result;
}

void write_text(BinaryWriter& writer, const std::string& text);
void write_camera(BinaryWriter& writer, const Camera& camera);
void write_lens_identity(BinaryWriter& writer, const LensIdentity& identity);
std::string read_text(BinaryReader& reader);
Camera read_camera(BinaryReader& reader);
LensIdentity read_lens_identity(BinaryReader& reader);

}  // namespace bosk
