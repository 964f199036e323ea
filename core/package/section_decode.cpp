#include "core/package/section_decode.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <set>

#include "core/package/atlas_coding.h"
#include "core/package/byte_cursor.h"
#include "core/package/model_check.h"

namespace bosk {
namespace {

std::string read_text(ByteCursor& cursor) {
  const auto length = cursor.value<std::uint32_t>();
  if (length > kMaxTextBytes) damaged("metadata: a text is too long");
  const auto characters = cursor.array<char>(length);
  std::string text(characters.begin(), characters.end());
  if (!is_clean_text(text)) damaged("metadata: a text is not clean UTF-8");
  return text;
}

template <class Number>
Number read_number(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    damaged("metadata: no number: " + text);
  return number;
}

// Keys that a later minor version adds are passed over.
void set_metadata(TreeMetadata& metadata, const std::string& key, const std::string& value) {
  if (key == "name") metadata.name = value;
  if (key == "licence") metadata.licence = value;
  if (key == "credit") metadata.credit = value;
  if (key == "generator") metadata.generator = value;
  if (key == "units") metadata.units = value;
  if (key == "height_m") metadata.height_m = read_number<double>(value);
  if (key == "photo_count") metadata.photo_count = read_number<std::uint32_t>(value);
}

CodeRange read_range(ByteCursor& cursor) {
  CodeRange range;
  range.first = cursor.value<std::uint32_t>();
  range.count = cursor.value<std::uint32_t>();
  return range;
}

LevelFrame read_level(ByteCursor& cursor) {
  LevelFrame frame;
  TreeLevel& level = frame.level;
  level.level = cursor.value<std::int32_t>();
  level.texels = cursor.value<std::int32_t>();
  level.side_factor = cursor.value<float>();
  level.max_cell_px = cursor.value<float>();
  frame.cell_count = cursor.value<std::uint64_t>();
  level.alpha_codes = read_range(cursor);
  level.colour_codes = read_range(cursor);
  const auto view_count = cursor.value<std::uint32_t>();
  if (view_count > kMaxViews) damaged("levels: too many views");
  level.views = cursor.array<std::uint32_t>(view_count);
  return frame;
}

// The bits that are set in a byte, lowest first: eight are written whatever it is, so that no
// branch depends on it.
constexpr auto kOctantsThere = [] {
  std::array<std::array<std::uint8_t, 8>, 256> octants{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    std::size_t count = 0;
    for (unsigned bit = 0; bit < 8; ++bit) {
      if (byte >> bit & 1u) octants[byte][count++] = std::uint8_t(bit);
    }
  }
  return octants;
}();

// Parents that the level before lacks; all of them where there is no such level.
std::vector<std::uint64_t> read_extra_parents(ByteCursor& cursor, int level) {
  const std::uint64_t count = cursor.varint();
  if (count > cursor.left()) damaged(cursor.section() + ": too many parents");
  std::vector<std::uint64_t> parents(count);
  const std::uint64_t end = level > 0 ? std::uint64_t(1) << (3 * (level - 1)) : 1;
  std::uint64_t next = 0;
  for (std::uint64_t& parent : parents) {
    const std::uint64_t gap = cursor.varint();
    if (gap >= end - next) damaged(cursor.section() + ": a cell beyond the octree");
    parent = next + gap;
    next = parent + 1;
  }
  return parents;
}

}  // namespace

TreeMetadata decode_metadata(std::span<const std::byte> bytes) {
  ByteCursor cursor(bytes, "metadata");
  const auto count = cursor.value<std::uint32_t>();
  if (count > kMaxMetadata) damaged("metadata: too many entries");
  TreeMetadata metadata;
  std::set<std::string> keys;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string key = read_text(cursor), value = read_text(cursor);
    if (!keys.insert(key).second) damaged("metadata: " + key + " is there twice");
    set_metadata(metadata, key, value);
  }
  cursor.expect_end();
  return metadata;
}

void decode_scene(std::span<const std::byte> bytes, TreeModel& tree) {
  ByteCursor cursor(bytes, "scene");
  for (int axis = 0; axis < 3; ++axis) tree.origin[axis] = cursor.value<double>();
  tree.size_m = cursor.value<double>();
  const auto view_count = cursor.value<std::uint32_t>();
  if (view_count > kMaxViews) damaged("scene: too many views");
  const auto coordinates = cursor.array<double>(std::uint64_t(view_count) * 3);
  for (std::size_t i = 0; i < coordinates.size(); i += 3) {
    tree.view_positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  cursor.expect_end();
  check_scene(tree);
}

CodeAtlas decode_atlas(std::span<const std::byte> texels, std::span<const std::byte> bc3) {
  ByteCursor cursor(texels, "atlas");
  CodeAtlas atlas;
  atlas.width_px = cursor.value<std::int32_t>();
  atlas.height_px = cursor.value<std::int32_t>();
  check_atlas_size(atlas.width_px, atlas.height_px);
  const auto size = std::size_t(atlas.width_px) * std::size_t(atlas.height_px), tiles = size / 16;
  const auto planes = cursor.take(size * 4);
  cursor.expect_end();
  if (bc3.size() != tiles * 16) damaged("BC3: size");
  std::vector<glm::u8vec4> by_tile(size);
  walk_atlas(by_tile, [next = planes.data()](std::uint8_t expected, std::uint8_t) mutable {
    return std::uint8_t(expected + std::uint8_t(*next++));
  });
  atlas.rgba.resize(size);
  for (std::size_t i = 0; i < size; ++i)
    atlas.rgba[atlas_index(atlas, i / 16, i % 16)] = by_tile[i];
  atlas.bc3.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    atlas.bc3[i % tiles * 16 + i / tiles] = std::uint8_t(bc3[i]);
  }
  return atlas;
}

std::vector<LevelFrame> decode_levels(std::span<const std::byte> bytes) {
  ByteCursor cursor(bytes, "levels");
  const auto count = cursor.value<std::uint32_t>();
  if (count > kMaxLevels) damaged("levels: too many");
  std::vector<LevelFrame> frames;
  for (std::uint32_t i = 0; i < count; ++i) frames.push_back(read_level(cursor));
  cursor.expect_end();
  return frames;
}

std::vector<std::uint64_t> decode_cells(std::span<const std::byte> bytes, const LevelFrame& frame,
                                        std::span<const std::uint64_t> parents) {
  const std::string name = "cells of level " + std::to_string(frame.level.level);
  ByteCursor cursor(bytes, name);
  const auto extra = read_extra_parents(cursor, frame.level.level);
  const auto octants = cursor.take(parents.size() + extra.size());
  cursor.expect_end();
  // A byte tells of at most eight cells.
  if (frame.cell_count > octants.size() * 8) damaged(name + ": too many");
  std::vector<std::uint64_t> cells(frame.cell_count + 8);
  std::uint64_t* next = cells.data();
  const std::uint64_t* const end = next + frame.cell_count;
  std::size_t parent = 0, other = 0;
  for (const std::byte children : octants) {
    const bool is_extra =
        parent == parents.size() || (other < extra.size() && extra[other] < parents[parent]);
    const std::uint64_t first = (is_extra ? extra[other++] : parents[parent++]) * 8;
    const auto& octants_there = kOctantsThere[unsigned(children)];
    for (std::size_t k = 0; k < 8; ++k) next[k] = first + octants_there[k];
    next += std::popcount(unsigned(children));
    if (next > end) damaged(name + ": too many");
  }
  if (next != end) damaged(name + ": too few");
  cells.resize(frame.cell_count);
  return cells;
}

}  // namespace bosk
