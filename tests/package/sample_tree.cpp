#include "tests/package/sample_tree.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/random.h"

namespace bosk {
namespace {

// Brightness rises with the number; a few smooth patterns and some noise on top.
CodeAtlas make_atlas(std::uint32_t tiles, Random& random) {
  CodeAtlas atlas;
  const int across = std::clamp(int(tiles), 1, 128);
  atlas.width_px = 4 * across;
  atlas.height_px = 4 * ((int(tiles) + across - 1) / across);
  atlas.rgba.resize(std::size_t(atlas.width_px) * std::size_t(atlas.height_px));
  const auto byte = [](double value) { return std::uint8_t(std::clamp(value, 0.0, 255.0)); };
  for (std::uint32_t tile = 0; tile < tiles; ++tile) {
    const double bright = 20.0 + 200.0 * tile / tiles;
    const double slope_x = 60.0 * (random.uniform() - 0.5),
                 slope_y = 60.0 * (random.uniform() - 0.5);
    const double warmth = 30.0 * random.uniform();
    for (int t = 0; t < 16; ++t) {
      const int column = t % 4, row = t / 4;
      const double light = bright + slope_x * (column - 1.5) / 2 + slope_y * (row - 1.5) / 2 +
                           8.0 * random.uniform();
      const int x = int(tile) % across * 4 + column, y = int(tile) / across * 4 + row;
      atlas.rgba[std::size_t(y) * std::size_t(atlas.width_px) + std::size_t(x)] = {
          byte(light * 0.8 + warmth), byte(light), byte(light * 0.5), byte(light * 1.1)};
    }
  }
  atlas.bc3.resize(atlas.rgba.size());
  for (auto& item : atlas.bc3) item = std::uint8_t(random.below(16) * 16);
  return atlas;
}

glm::dvec3 centre_in_unit_cube(std::uint64_t morton, int level) {
  glm::dvec3 centre(0.5);
  for (int axis = 0; axis < 3; ++axis) {
    for (int bit = 0; bit < level; ++bit) {
      centre[axis] += double((morton >> (3 * bit + axis) & 1) << bit);
    }
  }
  return centre / double(1 << level);
}

std::vector<std::uint64_t> shell_cells(int level) {
  std::vector<std::uint64_t> cells;
  for (std::uint64_t cell = 0; cell < std::uint64_t(1) << (3 * level); ++cell) {
    const double radius = glm::length(centre_in_unit_cube(cell, level) - 0.5);
    if (radius > 0.36 && radius < 0.47) cells.push_back(cell);
  }
  return cells;
}

// Near numbers, which look alike, more often; a jump to anywhere once in a while.
std::uint16_t look_alike(std::uint16_t from, std::uint32_t count, Random& random) {
  if (random.below(20) == 0) return std::uint16_t(random.below(count));
  if (random.below(3) == 0) return from;
  const double step = -6.0 * std::log(1.0 - random.uniform());
  const int to = int(from) + (random.below(2) == 0 ? 1 : -1) * int(step + 1.0);
  return std::uint16_t(std::clamp(to, 0, int(count) - 1));
}

void fill_indices(TreeLevel& level, const TreeModel& tree, Random& random) {
  const std::size_t blocks = std::size_t(level.texels * level.texels) / 16;
  std::vector<std::uint16_t> alpha(blocks, 0), colour(blocks, 0);
  for (const std::uint64_t cell : level.cells) {
    const glm::dvec3 outwards = glm::normalize(centre_in_unit_cube(cell, level.level) - 0.5);
    for (const std::uint32_t view : level.views) {
      const double facing = glm::dot(outwards, glm::normalize(tree.view_positions[view]));
      const bool hidden = facing + 0.3 * random.uniform() < -0.1;
      for (std::size_t block = 0; block < blocks; ++block) {
        alpha[block] = look_alike(alpha[block], level.alpha_codes.count, random);
        colour[block] = look_alike(colour[block], level.colour_codes.count, random);
        level.alpha_indices.push_back(hidden ? kPruned : alpha[block]);
        level.colour_indices.push_back(hidden ? 0 : colour[block]);
      }
    }
  }
}

}  // namespace

TreeModel sample_tree(const SampleTreeOptions& options) {
  Random random(options.seed);
  TreeModel tree;
  tree.origin = {-1.5, -1.5, 0.25};
  tree.size_m = 3.0;
  tree.metadata = {"Sample", "CC0-1.0", "nobody \xc3\xa9", "test", "m", 3.25, 6};
  for (int view = 0; view < options.views; ++view) {
    const double angle = 2.0 * std::numbers::pi * view / options.views;
    tree.view_positions.emplace_back(7.0 * std::cos(angle), 7.0 * std::sin(angle), 1.6);
  }
  const std::uint32_t own = std::max(options.alpha_codewords, options.colour_codewords);
  tree.atlas = make_atlas(own, random);
  for (const int number : options.levels) {
    TreeLevel level;
    level.level = number;
    level.texels = options.texels;
    level.side_factor = 1.35f;
    level.max_cell_px = float(number);
    for (int view = 0; view < options.views; ++view) level.views.push_back(std::uint32_t(view));
    level.cells = shell_cells(number);
    level.alpha_codes = {0, options.alpha_codewords};
    level.colour_codes = {0, options.colour_codewords};
    fill_indices(level, tree, random);
    tree.levels.push_back(std::move(level));
  }
  return tree;
}

bool same_tree(const TreeModel& a, const TreeModel& b) {
  const auto same_range = [](const CodeRange& x, const CodeRange& y) {
    return x.first == y.first && x.count == y.count;
  };
  const auto same_level = [&](const TreeLevel& x, const TreeLevel& y) {
    return x.level == y.level && x.texels == y.texels && x.side_factor == y.side_factor &&
           x.max_cell_px == y.max_cell_px && x.views == y.views && x.cells == y.cells &&
           x.alpha_indices == y.alpha_indices && x.colour_indices == y.colour_indices &&
           same_range(x.alpha_codes, y.alpha_codes) && same_range(x.colour_codes, y.colour_codes);
  };
  const TreeMetadata &m = a.metadata, &n = b.metadata;
  return a.origin == b.origin && a.size_m == b.size_m && a.view_positions == b.view_positions &&
         std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(),
                    same_level) &&
         a.atlas.width_px == b.atlas.width_px && a.atlas.height_px == b.atlas.height_px &&
         a.atlas.rgba == b.atlas.rgba && a.atlas.bc3 == b.atlas.bc3 && m.name == n.name &&
         m.licence == n.licence && m.credit == n.credit && m.generator == n.generator &&
         m.units == n.units && m.height_m == n.height_m && m.photo_count == n.photo_count;
}

}  // namespace bosk
