#include "core/package/assemble.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/package/model_check.h"

namespace bosk {
namespace {

// Whether the indices of one cell draw anything.
bool is_seen(const std::uint16_t* first, std::size_t count) {
  return std::any_of(first, first + count, [](std::uint16_t index) { return index != kPruned; });
}

void append_cell(TreeLevel& level, std::uint64_t cell, const std::uint16_t* alpha,
                 const std::uint16_t* colour, std::size_t count) {
  level.cells.push_back(cell);
  level.alpha_indices.insert(level.alpha_indices.end(), alpha, alpha + count);
  level.colour_indices.insert(level.colour_indices.end(), colour, colour + count);
}

TreeLevel assemble_level(const BillboardLevel& billboards, const CodedLevel& coded) {
  TreeLevel level;
  level.level = billboards.level;
  level.texels = billboards.texels;
  level.side_factor = billboards.side_factor;
  level.max_cell_px = billboards.max_cell_px;
  level.views = billboards.views;
  level.alpha_codes = {coded.first_alpha_tile, coded.alpha_codewords};
  level.colour_codes = {coded.first_colour_tile, coded.colour_codewords};
  const std::size_t per_cell = billboards.views.size() * billboards.texture_size() / 16;
  if (coded.alpha_indices.size() != billboards.cells.size() * per_cell ||
      coded.colour_indices.size() != coded.alpha_indices.size()) {
    throw Error("the coded textures of level " + std::to_string(billboards.level) +
                " do not belong to these billboards; compress them again");
  }
  for (std::size_t i = 0; i < billboards.cells.size(); ++i) {
    const std::uint16_t* alpha = coded.alpha_indices.data() + i * per_cell;
    if (!is_seen(alpha, per_cell)) continue;
    append_cell(level, billboards.cells[i], alpha, coded.colour_indices.data() + i * per_cell,
                per_cell);
  }
  return level;
}

std::uint64_t z_of(std::uint64_t morton) {
  std::uint64_t z = 0;
  for (int bit = 0; bit < 21; ++bit) z |= (morton >> (3 * bit + 2) & 1) << bit;
  return z;
}

double height_m(const TreeModel& tree) {
  const auto finest = std::find_if(tree.levels.rbegin(), tree.levels.rend(),
                                   [](const TreeLevel& level) { return !level.cells.empty(); });
  if (finest == tree.levels.rend()) return 0.0;
  std::uint64_t highest = 0;
  for (const std::uint64_t cell : finest->cells) highest = std::max(highest, z_of(cell));
  return tree.origin.z + double(highest + 1) * tree.size_m / double(1 << finest->level);
}

}  // namespace

TreeModel assemble_tree(const Billboards& billboards, const CodedTextures& textures,
                        const TreeMetadata& metadata) {
  static_assert(kPruned == kPrunedIndex);
  if (billboards.levels.size() != textures.levels.size()) {
    throw Error("the coded textures have other levels than the billboards; compress them again");
  }
  TreeModel tree{billboards.origin, billboards.size_m, billboards.view_positions, {}, {}, metadata};
  for (std::size_t i = 0; i < billboards.levels.size(); ++i) {
    tree.levels.push_back(assemble_level(billboards.levels[i], textures.levels[i]));
  }
  tree.atlas = {textures.atlas_width_px, textures.atlas_height_px, textures.atlas_rgba,
                textures.atlas_bc3};
  tree.metadata.height_m = height_m(tree);
  check_tree_model(tree);
  return tree;
}

}  // namespace bosk
