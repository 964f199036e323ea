#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "core/render/prepared_tree.h"
#include "core/render/view_blend.h"
#include "core/render/view_cone.h"

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
  int only_level = -1;  // the cut of this octree level everywhere; -1: chosen by size on screen
  // A level gives way to the next finer one while sizes on screen grow by this factor; 1: at once.
  double dissolve = 1.25;
  // Half opening of the cone around `forward` outside which nothing is drawn. pi / 2 drops what is
  // behind the eye; pi drops nothing.
  double half_angle = 0.5 * std::numbers::pi;
};

inline constexpr float kFadeSlack = 1.0f / 32.0f;

// A run of cells, drawn one after the other: entries `first`, `first + 1` ... of
// PreparedTree::order_table(), or `first`, `first - 1` ... when backwards; `count` of them. Where
// the eye's planes cut the run's region, several ranges name the same cells and each draws its
// part: along a split axis a cell belongs to the low half when its lower corner, in finest cells,
// is at most the eye's (eye_cell), else to the high half.
struct DrawRange {
  std::uint32_t instance = 0;  // of a forest; 0 for a tree alone
  std::uint32_t first = 0, count = 0;
  std::uint8_t backwards = 0;  // 0 or 1
  std::uint8_t split = 0;      // bit per axis, x lowest: only one half of it is drawn
  std::uint8_t high = 0;       // bit per axis: the high one
  std::uint8_t cut = 0;        // of PreparedTree, that the cells belong to
  // While two levels dissolve into each other each draws its share: an opacity a becomes
  // 1 - (1 - a (1 - kFadeSlack (1 - fade)))^fade. Together they stop about the light that either
  // would alone; without the slack opaque pixels would change at once, since 0^fade is 0.
  float fade = 1.0f;

  bool operator==(const DrawRange&) const = default;
};

// The depth that levels are chosen by: along `forward` (unit length), but at least half the
// distance, so that it also means something beside and behind the eye.
double level_depth(const glm::dvec3& from_eye, const glm::dvec3& forward);

// Chooses ranges of one tree, for any number of its instances.
class RangeChooser {
 public:
  // `focal_px` as Viewpoint's. Keeps a pointer to the tree.
  RangeChooser(const PreparedTree& tree, double focal_px, const DrawOptions& options);

  // Appends ranges in back-to-front order, exact for the cells' cubes from every eye, also inside
  // the crown. They cover the tree's part in the cone once. Planes of equal depth along `forward`
  // part the levels (Linz et al. 2006, section 3.1), for nodes of 16 to 32 cells a side at once; a
  // level serves where its cells' size on screen is at most TreeLevel::max_cell_px. Eye and forward
  // are in the tree's own frame.
  void append(const glm::dvec3& eye, const glm::dvec3& forward, std::uint32_t instance,
              std::vector<DrawRange>& ranges) const;

  // Billboards of the whole tree where all of it is at `depth`.
  double billboards_at(double depth) const;

 private:
  friend class RangeWalk;
  // One of the cuts that are in use, coarse to fine.
  struct Step {
    int cut = 0;
    double whole_depth = 0.0;  // from here on it stands alone
    double gone_depth = 0.0;   // up to here the next one does
  };
  // Where between the steps a depth lies: 0 is the coarsest alone, 1 the next ...
  double fineness(double depth) const;

  const PreparedTree* tree_;
  std::vector<Step> steps_;
  double per_log_depth_ = 0.0;  // fineness, while levels dissolve
  ViewCone cone_;
  double reach_ = 0.0;           // of a billboard from its cell's middle, relative to the cell
  double largest_cell_m_ = 0.0;  // of the cuts in use
};

std::vector<DrawRange> make_draw_list(const PreparedTree& tree, const Viewpoint& viewpoint,
                                      const DrawOptions& options);

// The eye's finest cell of the octree, at least -1 and at most the number of cells a side.
glm::ivec3 eye_cell(const PreparedTree& tree, const glm::dvec3& eye);

// One billboard: its textures of views a and b mixed by weight_b. view_a and view_b are positions
// in TreeLevel::views; equal when one texture is enough.
struct DrawItem {
  std::uint32_t level_slot = 0, cell = 0;
  std::uint32_t view_a = 0, view_b = 0;
  float weight_b = 0.0f;
  float fade = 1.0f;  // of its range

  bool operator==(const DrawItem&) const = default;
};

// The billboards of ranges of one tree, in their order, for renderers that don't expand ranges on
// the GPU. Left out: cells wholly pruned in the views that would be mixed (pruned in one: the other
// stands alone, since a texture is pruned where its view cannot see the cell) and cells nearer to
// the eye than half their billboard's side.
std::vector<DrawItem> draw_items(const PreparedTree& tree, const std::vector<DrawRange>& ranges,
                                 const glm::dvec3& eye, BlendRule blend);

// Whether the texture of one view draws nothing. `view` is a position in TreeLevel::views.
bool is_pruned(const TreeLevel& level, std::uint32_t cell, std::uint32_t view);

}  // namespace bosk
