// Tables of packages after Linz et al. 2006, figures 2 and 4 and section 6, as Markdown: billboards
// of each level before and after pruning, memory by form, and what it costs to draw a level in
// place of the next finer one.
//
//     tree_tables_benchmark TREE.bosk...

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>

#include "core/compress/level_statistics.h"
#include "core/render/draw_list.h"
#include "core/render/level_switch.h"
#include "tests/benchmarks/packages.h"
#include "tests/benchmarks/run_or_explain.h"

namespace bosk {
namespace {

constexpr double kMegabyte = 1e6;  // as the paper counts, as far as it says
constexpr int kTurns = 24;         // eyes around the tree

struct Tree {
  std::string name;
  TreeModel model;
  double file_bytes = 0.0;
};

double blocks_of(const TreeLevel& level) { return double(level.alpha_indices.size()); }

double textures_kept(const TreeLevel& level) {
  const std::size_t blocks_per_texture = std::size_t(level.texels * level.texels) / 16;
  return double(bosk::textures_kept(level.alpha_indices, blocks_per_texture));
}

// Billboards that are drawn of the level alone, on average over a turn around the tree.
double drawn_on_average(const PreparedTree& tree, const TreeLevel& level) {
  const glm::dvec3 centre = 0.5 * (tree.lower() + tree.upper());
  DrawOptions options;
  options.only_level = level.level;
  options.half_angle = std::numbers::pi;
  double sum = 0.0;
  for (int turn = 0; turn < kTurns; ++turn) {
    const double angle = 2.0 * std::numbers::pi * turn / kTurns;
    const glm::dvec3 forward(std::cos(angle), std::sin(angle), 0.0);
    const Viewpoint viewpoint{centre - 2.0 * tree.model().size_m * forward, forward, 1000.0};
    const auto ranges = make_draw_list(tree, viewpoint, options);
    sum += double(draw_items(tree, ranges, viewpoint.eye, BlendRule::fading).size());
  }
  return sum / kTurns;
}

void print_levels(const Tree& tree) {
  const PreparedTree prepared(tree.model);
  std::printf("\n### %s: billboards by level\n\n", tree.name.c_str());
  std::printf(
      "Drawn: mean of %d eyes around the tree. A level's cells that are pruned in all views are "
      "not stored; "
      "finer ones stand in.\n\n",
      kTurns);
  std::printf("| level | cells | views | textures | pruned | with stand-ins | drawn | pruned |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  for (int cut = 0; cut < prepared.cut_count(); ++cut) {
    const TreeLevel& level = prepared.level_of_cut(cut);
    const double textures = double(level.cells.size()) * double(level.views.size());
    const double all = prepared.run(prepared.nodes().front(), cut).count;
    const double drawn = drawn_on_average(prepared, level);
    std::printf("| %d | %zu | %zu | %.0f | %.0f %% | %.0f | %.0f | %.0f %% |\n", level.level,
                level.cells.size(), level.views.size(), textures,
                100.0 * (1.0 - textures_kept(level) / textures), all, drawn,
                100.0 * (1.0 - drawn / all));
  }
}

void print_memory(const std::vector<Tree>& trees) {
  std::printf("\n### Memory by form, MB\n\n");
  std::printf(
      "| tree | textures, RGBA8 | indices | codewords, RGBA8 | codewords, BC3 | on the GPU | file "
      "|\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  double sum = 0.0, codewords = 0.0;
  for (const Tree& tree : trees) {
    double blocks = 0.0;
    for (const TreeLevel& level : tree.model.levels) blocks += blocks_of(level);
    const double atlas = double(tree.model.atlas.rgba.size());
    const double gpu = 4.0 * blocks + atlas;
    std::printf("| %s | %.1f | %.1f | %.2f | %.2f | %.1f | %.2f |\n", tree.name.c_str(),
                64.0 * blocks / kMegabyte, 4.0 * blocks / kMegabyte, 4.0 * atlas / kMegabyte,
                atlas / kMegabyte, gpu / kMegabyte, tree.file_bytes / kMegabyte);
    sum += gpu;
    codewords += atlas;
  }
  std::printf("\nTextures of all trees: %.2f MB (BC3), %.1f MB with their indices. ",
              codewords / kMegabyte, sum / kMegabyte);
  std::printf("Linz et al. 2006: 2.9 MB for three trees, 290 times in one scene.\n");
}

// The size of the tree at which a level gives way, and the errors there of both levels.
void print_switches(const Tree& tree) {
  Progress quiet;
  const std::vector<LevelError> errors = measure_level_errors(tree.model, {}, {}, quiet);
  std::printf(
      "\n### %s: error against the finest level drawn large and reduced (dB), by size of the "
      "tree's cube\n\n",
      tree.name.c_str());
  std::printf("| level | serves cells up to, px | cube, px |");
  std::vector<int> sizes;
  for (const LevelError& error : errors)
    if (error.level_slot == 0) sizes.push_back(error.tree_px);
  for (const int size : sizes) std::printf(" %d |", size);
  std::printf("\n|---|---|---|");
  for (std::size_t i = 0; i < sizes.size(); ++i) std::printf("---|");
  for (std::size_t slot = 0; slot < tree.model.levels.size(); ++slot) {
    const TreeLevel& level = tree.model.levels[slot];
    std::printf("\n| %d | %.2f | %.0f |", level.level, double(level.max_cell_px),
                std::ldexp(double(level.max_cell_px), level.level));
    for (const int size : sizes) {
      const auto at = std::find_if(errors.begin(), errors.end(), [&](const LevelError& error) {
        return error.level_slot == slot && error.tree_px == size;
      });
      at == errors.end() ? std::printf(" |") : std::printf(" %.1f |", at->psnr_db);
    }
  }
  std::printf("\n");
}

int print_tables(int count, char** arguments) {
  if (count < 2) {
    std::cerr << "tree_tables_benchmark: name one or more packages (TREE.bosk)\n";
    return 2;
  }
  std::vector<Tree> trees;
  for (int i = 1; i < count; ++i) {
    const std::filesystem::path path = arguments[i];
    trees.push_back(
        {path.stem().string(), load_tree(path), double(std::filesystem::file_size(path))});
  }
  for (const Tree& tree : trees) print_levels(tree);
  print_memory(trees);
  for (const Tree& tree : trees) print_switches(tree);
  return 0;
}

}  // namespace
}  // namespace bosk

int main(int count, char** arguments) {
  return bosk::run_or_explain(bosk::print_tables, count, arguments);
}
