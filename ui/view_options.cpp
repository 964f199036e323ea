#include "ui/view_options.h"

#include <numbers>

namespace bosk {

Options describe(ViewOptions& o) {
  return {
      {"budget",
       "billboards",
       "drawn at most, about: the detail of all trees falls alike; 0 is no bound",
       &o.budget,
       0,
       100000000,
       {}},
      {"frame_ms",
       "ms",
       "in the window: while things move, the budget falls until a frame takes so long; 0: never",
       &o.frame_ms,
       0,
       1000,
       {}},
      {"still_ms",
       "ms",
       "in the window: what a picture may take once things stand still; 0: as long as it needs",
       &o.still_ms,
       0,
       100000,
       {}},
      {"detail", "", "size at which cells are split, above 1 finer", &o.detail, 0.05, 16, {}},
      {"dissolve",
       "",
       "a level gives way to the next while sizes grow by this factor; 1 is at once",
       &o.dissolve,
       1,
       4,
       {}},
      {"blend",
       "",
       "how two baked views are mixed: linear in angle, or fading where the third takes over",
       &o.blend,
       0,
       0,
       {"fading", "linear"}},
      {"wind_m", "m", "how far the top of a crown sways; 0 is still", &o.wind_m, 0, 2, {}},
      {"colours",
       "",
       "the tree's own, or false ones that show octree levels, single cells or pruned textures",
       &o.colours,
       0,
       0,
       {"tree", "levels", "cells", "pruned"}},
      {"view_angle_deg", "degrees", "of the picture's height", &o.view_angle_deg, 5, 120, {}},
      {"cameras",
       "",
       "marks the places that the trees' textures were baked towards",
       &o.cameras,
       0,
       0,
       {}},
  };
}

DrawOptions draw_options(const ViewOptions& options, double half_angle) {
  DrawOptions draw;
  draw.detail = options.detail;
  draw.dissolve = options.dissolve;
  draw.half_angle = half_angle;
  return draw;
}

double view_angle(const ViewOptions& options) {
  return options.view_angle_deg * std::numbers::pi / 180.0;
}

}  // namespace bosk
