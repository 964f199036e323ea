#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "core/package/tree_model.h"
#include "core/render/view_blend.h"

namespace bosk {

// What to draw, and in which order, for one eye: independent of any graphics interface. Standard
// library and GLM alone, as a game links it.

struct Viewpoint {
  glm::dvec3 eye{0.0};                // world frame
  glm::dvec3 forward{0.0, 1.0, 0.0};  // unit length, world frame
  double focal_px = 1000.0;           // pixels that a metre covers at a depth of one metre
};

struct DrawOptions {
  double detail =
      1.0;  // sizes on screen are multiplied by it before a level is chosen; above 1: finer
  int only_level = -1;  // this octree level everywhere, whatever the size; -1: chosen by size
  BlendRule blend = BlendRule::fading;
  // Half opening of the cone around `forward` outside which nothing is drawn. pi / 2 drops what is
  // behind the eye; pi drops nothing.
  double half_angle = 0.5 * std::numbers::pi;
};

// One billboard: cell `cell` of levels[level_slot], its textures of views a and b mixed by
// weight_b. view_a and view_b are positions in TreeLevel::views; equal when one texture is enough.
struct DrawItem {
  std::uint32_t level_slot = 0, cell = 0;
  std::uint32_t view_a = 0, view_b = 0;
  float weight_b = 0.0f;

  bool operator==(const DrawItem&) const = default;
};
using DrawList = std::vector<DrawItem>;

// Billboards in back-to-front order, exact for the cells' cubes from every eye, also inside the
// crown. A region of the octree is drawn at the coarsest level whose cell there is at most
// max_cell_px on screen, else at the finest that has cells there: a level without a cell is passed
// over, never a hole. Left out: cells wholly pruned in the views that would be mixed (pruned in
// one: the other stands alone) and cells nearer to the eye than half their billboard's side. Levels
// are expected coarse to fine.
DrawList make_draw_list(const TreeModel& model, const Viewpoint& viewpoint,
                        const DrawOptions& options);

// Whether the texture of one view draws nothing. `view` is a position in TreeLevel::views.
bool is_pruned(const TreeLevel& level, std::uint32_t cell, std::uint32_t view);

}  // namespace bosk
