#include "core/package/billboard_sample.h"

#include <algorithm>

#include "core/compress/blocks.h"

namespace bosk {
namespace {

constexpr std::size_t kFewestSubtrees = 1000;  // so that chance differences between them even out

// The subtrees that are taken: every `step`-th of a level's cells and all below it.
struct Choice {
  std::size_t step = 1;
  int level = 0;
  std::vector<std::uint64_t> roots;  // of all subtrees, Morton codes, ascending

  bool takes(std::uint64_t cell, int cell_level) const {
    if (cell_level < level) return true;
    const std::uint64_t root = cell >> (3 * (cell_level - level));
    const auto place = std::lower_bound(roots.begin(), roots.end(), root) - roots.begin();
    return std::size_t(place) % step == step / 2;
  }
};

Choice choose(const Billboards& billboards, std::size_t blocks) {
  Choice choice;
  choice.step =
      std::max<std::size_t>(1, block_count(billboards) / std::max<std::size_t>(blocks, 1));
  for (const BillboardLevel& level : billboards.levels) {
    if (level.cells.size() < kFewestSubtrees * choice.step) continue;
    choice.level = level.level;
    choice.roots = level.cells;
    return choice;
  }
  return {};
}

BillboardLevel taken(const BillboardLevel& level, const Choice& choice) {
  BillboardLevel part = level;
  part.cells.clear();
  part.texture.clear();
  const std::size_t texels = level.views.size() * level.texture_size();
  for (std::size_t i = 0; i < level.cells.size(); ++i) {
    if (!choice.takes(level.cells[i], level.level)) continue;
    part.cells.push_back(level.cells[i]);
    const auto first = level.texture.begin() + std::ptrdiff_t(i * texels);
    part.texture.insert(part.texture.end(), first, first + std::ptrdiff_t(texels));
  }
  return part;
}

BillboardSample whole(const Billboards& billboards) {
  return {billboards, std::vector<double>(billboards.levels.size(), 1.0)};
}

}  // namespace

std::size_t block_count(const Billboards& billboards) {
  std::size_t count = 0;
  for (const BillboardLevel& level : billboards.levels) count += block_count(level);
  return count;
}

BillboardSample sample_of(const Billboards& billboards, std::size_t blocks) {
  const Choice choice = choose(billboards, blocks);
  BillboardSample sample;
  if (choice.step == 1) return whole(billboards);
  sample.billboards = {billboards.origin, billboards.size_m, billboards.view_positions, {}};
  for (const BillboardLevel& level : billboards.levels) {
    BillboardLevel part = taken(level, choice);
    if (part.cells.empty()) return whole(billboards);
    sample.scale.push_back(double(level.cells.size()) / double(part.cells.size()));
    sample.billboards.levels.push_back(std::move(part));
  }
  return sample;
}

}  // namespace bosk
