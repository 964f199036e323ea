#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "core/render/prepared_tree.h"

namespace bosk {

// What to draw, and in which order, for one eye: independent of any graphics interface. Standard
// library and GLM alone, as a game links it.

struct Viewpoint {
  glm::dvec3 eye{0.0};
  glm::dvec3 forward{0.0, 1.0, 0.0};  // unit length
  double focal_px = 1000.0;           // pixels that a metre covers at a depth of one metre
};

struct DrawOptions {
  // Sizes on screen are multiplied by it before a level is chosen; above 1: finer.
  double detail = 1.0;
  int only_level = -1;  // this octree level everywhere, whatever the size; -1: chosen by size
  // A level gives way to the next finer one while sizes on screen grow by this factor; 1: at once.
  double dissolve = 1.25;
  // Half opening of the cone around `forward` outside which nothing is drawn. pi / 2 drops what is
  // behind the eye; pi drops nothing.
  double half_angle = 0.5 * std::numbers::pi;
};

// A run of cells, drawn one after the other: entry `first`, `first + 1` ... of
// PreparedTree::order_table(), or `first`, `first - 1` ... when backwards; `count` of them. Where
// the eye's planes cut the run's region, several ranges name the same cells and each draws its
// part: along a split axis a cell belongs to the low half when its lower corner, in finest cells,
// is at most that of the eye's (eye_cell), else to the high half.
struct DrawRange {
  std::uint32_t instance = 0;  // of a forest; 0 for a tree alone
  std::uint32_t first = 0, count = 0;
  std::uint8_t backwards = 0;  // 0 or 1
  std::uint8_t split = 0;      // bit per axis: only one half of it is drawn
  std::uint8_t high = 0;       // bit per axis: which
  std::uint8_t cut = 0;        // which level's cut the cells belong to, as PreparedTree::cut
  // While two levels dissolve into each other each draws its share: an opacity a becomes
  // 1 - (1 - a)^fade, so that together they stop the light that either would alone.
  float fade = 1.0f;

  bool operator==(const DrawRange&) const = default;
};

// Ranges in back-to-front order, exact for the cells' cubes from every eye, also inside the crown.
// Every cut covers the tree once; regions are cut as finely as their depth along `forward` asks for
// (planes of equal depth part the levels, Linz et al. 2006, section 3.1), in nodes of 16 cells a
// side. `viewpoint` is in the tree's own frame.
void append_ranges(const PreparedTree& tree, const Viewpoint& viewpoint, const DrawOptions& options,
                   std::uint32_t instance, std::vector<DrawRange>& ranges);
std::vector<DrawRange> make_draw_list(const PreparedTree& tree, const Viewpoint& viewpoint,
                                      const DrawOptions& options);

// The eye in finest cells of the octree, rounded down and kept within -1 .. cells a side.
glm::ivec3 eye_cell(const PreparedTree& tree, const glm::dvec3& eye);

}  // namespace bosk
