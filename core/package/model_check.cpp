#include "core/package/model_check.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/package/format.h"

namespace bosk {
namespace {

constexpr double kMaxMetres = 1e9;

bool is_place(const glm::dvec3& point) {
  return std::abs(point.x) <= kMaxMetres && std::abs(point.y) <= kMaxMetres &&
         std::abs(point.z) <= kMaxMetres;  // false for NaN too
}

std::uint64_t tile_count(const CodeAtlas& atlas) {
  return std::uint64_t(atlas.width_px / 4) * std::uint64_t(atlas.height_px / 4);
}

void check_range(const CodeRange& codes, const CodeAtlas& atlas, const std::string& name) {
  if (codes.count > kMaxCodewords) damaged(name + ": too many codewords");
  if (std::uint64_t(codes.first) + codes.count > tile_count(atlas)) {
    damaged(name + ": codewords beyond the atlas");
  }
}

void check_cells(const TreeLevel& level, const std::string& name) {
  const auto& cells = level.cells;
  const auto not_ascending = std::adjacent_find(cells.begin(), cells.end(), std::greater_equal<>());
  if (not_ascending != cells.end()) damaged(name + ": cells out of order");
  if (!cells.empty() && cells.back() >> (3 * level.level) != 0) {
    damaged(name + ": a cell beyond the octree");
  }
}

// What the checks need of all indices, found in one pass that compilers vectorise.
struct IndexExtremes {
  std::uint16_t largest_alpha = 0, largest_colour = 0;  // kPruned apart
  std::uint16_t pruned_colours = 0;                     // not 0 when a pruned block has a colour
  std::uint16_t live = 0;                               // not 0 when a block is not pruned
};
IndexExtremes index_extremes(const TreeLevel& level) {
  const std::uint16_t *alphas = level.alpha_indices.data(), *colours = level.colour_indices.data();
  std::uint16_t largest_alpha = 0, largest_colour = 0, pruned_colours = 0, live = 0;
  for (std::size_t i = 0; i < level.alpha_indices.size(); ++i) {
    const std::uint16_t pruned = alphas[i] == kPruned ? 0xffff : 0, not_pruned = ~pruned;
    const std::uint16_t alpha = alphas[i] & not_pruned, colour = colours[i];
    largest_alpha = alpha > largest_alpha ? alpha : largest_alpha;
    largest_colour = colour > largest_colour ? colour : largest_colour;
    pruned_colours |= colour & pruned;
    live |= not_pruned;
  }
  return {largest_alpha, largest_colour, pruned_colours, live};
}

void check_indices(const TreeLevel& level, const std::string& name) {
  const std::uint64_t blocks = std::uint64_t(level.texels / 4) * std::uint64_t(level.texels / 4);
  const std::uint64_t count = level.cells.size() * level.views.size() * blocks;
  if (level.alpha_indices.size() != count || level.colour_indices.size() != count) {
    damaged(name + ": number of indices is not cells x views x blocks");
  }
  const IndexExtremes extremes = index_extremes(level);
  if (extremes.pruned_colours != 0) damaged(name + ": a pruned block has a colour");
  if (extremes.live != 0 && (extremes.largest_alpha >= level.alpha_codes.count ||
                             extremes.largest_colour >= level.colour_codes.count)) {
    damaged(name + ": an index beyond its codebook");
  }
}

void check_text(const std::string& text, const char* key) {
  if (text.size() > kMaxTextBytes) damaged(std::string("metadata: ") + key + " is too long");
  if (!is_clean_text(text)) damaged(std::string("metadata: ") + key + " is not clean UTF-8");
}

void check_metadata(const TreeMetadata& metadata) {
  check_text(metadata.name, "name");
  check_text(metadata.licence, "licence");
  check_text(metadata.credit, "credit");
  check_text(metadata.generator, "generator");
  check_text(metadata.units, "units");
  if (!(std::abs(metadata.height_m) <= kMaxMetres)) damaged("metadata: height is no length");
}

void check_atlas(const CodeAtlas& atlas) {
  check_atlas_size(atlas.width_px, atlas.height_px);
  const std::uint64_t tiles = tile_count(atlas);
  if (atlas.rgba.size() != tiles * 16) damaged("atlas: size of the texels");
  if (atlas.bc3.size() != tiles * 16) damaged("atlas: size of the BC3 blocks");
}

// Length of the UTF-8 sequence that starts with `lead`, 0 when none can.
int sequence_length(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead <= 0xdf) return 2;
  if (lead >= 0xe0 && lead <= 0xef) return 3;
  return lead >= 0xf0 && lead <= 0xf4 ? 4 : 0;
}

}  // namespace

bool is_clean_text(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const int length = sequence_length(lead);
    if (length == 0 || i + std::size_t(length) > text.size()) return false;
    std::uint32_t point = length == 1 ? lead : lead & (0x7fu >> length);
    for (int k = 1; k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + std::size_t(k)]);
      if ((next & 0xc0) != 0x80) return false;
      point = point << 6 | (next & 0x3fu);
    }
    const bool overlong = (length == 3 && point < 0x800) || (length == 4 && point < 0x10000);
    const bool surrogate = point >= 0xd800 && point <= 0xdfff;
    const bool control = (point < 0x20 && point != '\n' && point != '\t') || point == 0x7f ||
                         (point >= 0x80 && point < 0xa0);
    if (overlong || surrogate || control || point > 0x10ffff) return false;
    i += std::size_t(length);
  }
  return true;
}

void check_scene(const TreeModel& tree) {
  if (!is_place(tree.origin)) damaged("scene: origin is no place");
  if (!(tree.size_m > 0.0 && tree.size_m <= kMaxMetres)) damaged("scene: size is no length");
  if (tree.view_positions.size() > kMaxViews) damaged("scene: too many views");
  if (!std::all_of(tree.view_positions.begin(), tree.view_positions.end(), is_place)) {
    damaged("scene: a view position is no place");
  }
}

void check_atlas_size(int width_px, int height_px) {
  const auto fits = [](int px) { return px >= 0 && px <= kMaxAtlasPx && px % 4 == 0; };
  if (!fits(width_px) || !fits(height_px)) damaged("atlas: width or height");
}

void check_level_frame(const TreeLevel& level, const TreeModel& tree) {
  const std::string name = "level " + std::to_string(level.level);
  if (level.level < 0 || level.level >= int(kMaxLevels)) damaged(name + ": no octree level");
  if (level.texels != 4 && level.texels != 8) damaged(name + ": texels are not 4 or 8");
  if (!(level.side_factor > 0.0f && level.side_factor <= 8.0f)) damaged(name + ": side factor");
  if (!(level.max_cell_px >= 0.0f && level.max_cell_px <= 1e9f))
    damaged(name + ": cell size limit");
  if (level.views.size() > kMaxViews) damaged(name + ": too many views");
  for (const std::uint32_t view : level.views) {
    if (view >= tree.view_positions.size()) damaged(name + ": a view that the scene has not");
  }
  check_range(level.alpha_codes, tree.atlas, name);
  check_range(level.colour_codes, tree.atlas, name);
}

void check_tree_model(const TreeModel& tree) {
  check_metadata(tree.metadata);
  check_scene(tree);
  check_atlas(tree.atlas);
  if (tree.levels.size() > kMaxLevels) damaged("too many levels");
  int previous = -1;
  std::uint64_t indices = 0, cells = 0;
  for (const TreeLevel& level : tree.levels) {
    const std::string name = "level " + std::to_string(level.level);
    check_level_frame(level, tree);
    if (level.level <= previous) damaged(name + ": levels out of order");
    previous = level.level;
    check_cells(level, name);
    check_indices(level, name);
    indices += level.alpha_indices.size();
    cells += level.cells.size();
  }
  if (indices > kMaxIndices) damaged("too many indices");
  if (cells > kMaxCells) damaged("too many cells");
}

}  // namespace bosk
