#include "core/package/section_encode.h"

#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "core/package/atlas_coding.h"
#include "core/package/byte_sink.h"

namespace bosk {
namespace {

void put_text(ByteSink& sink, const std::string& text) {
  sink.value(std::uint32_t(text.size()));
  sink.append(std::as_bytes(std::span(text)));
}

// Shortest text that reads back exactly, whatever the locale.
template <class Number>
std::string number_text(Number number) {
  std::array<char, 40> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

void put_range(ByteSink& sink, const CodeRange& range) {
  sink.value(range.first);
  sink.value(range.count);
}

}  // namespace

std::vector<std::byte> encode_metadata(const TreeMetadata& metadata) {
  const std::array<std::pair<const char*, std::string>, 7> entries{
      {{"name", metadata.name},
       {"licence", metadata.licence},
       {"credit", metadata.credit},
       {"generator", metadata.generator},
       {"units", metadata.units},
       {"height_m", number_text(metadata.height_m)},
       {"photo_count", number_text(metadata.photo_count)}}};
  ByteSink sink;
  sink.value(std::uint32_t(entries.size()));
  for (const auto& [key, value] : entries) {
    put_text(sink, key);
    put_text(sink, value);
  }
  return std::move(sink.bytes);
}

std::vector<std::byte> encode_scene(const TreeModel& tree) {
  ByteSink sink;
  for (int axis = 0; axis < 3; ++axis) sink.value(tree.origin[axis]);
  sink.value(tree.size_m);
  sink.value(std::uint32_t(tree.view_positions.size()));
  for (const glm::dvec3& position : tree.view_positions) {
    for (int axis = 0; axis < 3; ++axis) sink.value(position[axis]);
  }
  return std::move(sink.bytes);
}

std::vector<std::byte> encode_levels(const TreeModel& tree) {
  ByteSink sink;
  sink.value(std::uint32_t(tree.levels.size()));
  for (const TreeLevel& level : tree.levels) {
    sink.value(std::int32_t(level.level));
    sink.value(std::int32_t(level.texels));
    sink.value(level.side_factor);
    sink.value(level.max_cell_px);
    sink.value(std::uint64_t(level.cells.size()));
    put_range(sink, level.alpha_codes);
    put_range(sink, level.colour_codes);
    sink.value(std::uint32_t(level.views.size()));
    for (const std::uint32_t view : level.views) sink.value(view);
  }
  return std::move(sink.bytes);
}

std::vector<std::byte> encode_atlas(const CodeAtlas& atlas) {
  std::vector<glm::u8vec4> by_tile(atlas.rgba.size());
  for (std::size_t i = 0; i < by_tile.size(); ++i) {
    by_tile[i] = atlas.rgba[atlas_index(atlas, i / 16, i % 16)];
  }
  ByteSink sink;
  sink.value(std::int32_t(atlas.width_px));
  sink.value(std::int32_t(atlas.height_px));
  walk_atlas(by_tile, [&](std::uint8_t expected, std::uint8_t value) {
    sink.value(std::uint8_t(value - expected));
    return value;
  });
  return std::move(sink.bytes);
}

std::vector<std::byte> encode_bc3(const CodeAtlas& atlas) {
  const std::size_t size = atlas.bc3.size(), tiles = size / 16;
  std::vector<std::byte> planes(size);
  for (std::size_t i = 0; i < size; ++i) {
    planes[i] = std::byte(atlas.bc3[i % tiles * 16 + i / tiles]);
  }
  return planes;
}

std::vector<std::byte> encode_cells(std::span<const std::uint64_t> cells,
                                    std::span<const std::uint64_t> parents) {
  ByteSink sink, extra, children;
  std::uint64_t extra_count = 0, next_extra = 0;
  for (std::size_t i = 0, parent = 0; i < cells.size() || parent < parents.size();) {
    const std::uint64_t code = i < cells.size() ? cells[i] >> 3 : ~std::uint64_t(0);
    std::uint8_t octants = 0;
    if (parent < parents.size() && parents[parent] < code) {
      ++parent;  // has no children
    } else {
      if (parent < parents.size() && parents[parent] == code) {
        ++parent;
      } else {
        ++extra_count;
        extra.varint(code - next_extra);
        next_extra = code + 1;
      }
      for (; i < cells.size() && cells[i] >> 3 == code; ++i) {
        octants = std::uint8_t(octants | 1 << (cells[i] & 7));
      }
    }
    children.value(octants);
  }
  sink.varint(extra_count);
  sink.append(extra.bytes);
  sink.append(children.bytes);
  return std::move(sink.bytes);
}

}  // namespace bosk
