#include "core/phantom/phantom_options.h"

#include <algorithm>

namespace bosk {

Options describe(PhantomOptions& o) {
  return {
      {"preset",
       "",
       "kind of tree: a broad crown, a thin and open one, or a cone of needles",
       &o.preset,
       0,
       0,
       {"dense", "sparse", "conical"}},
      {"seed",
       "",
       "another number grows another tree under another sky",
       &o.seed,
       0,
       2147483647,
       {}},
      {"height_m", "m", "height of the tree; 0 keeps the kind's own", &o.height_m, 0, 100, {}},
      {"detail",
       "",
       "share of a full tree's branches and leaves, which grow larger in turn",
       &o.detail,
       0.005,
       4,
       {}},
      {"photos", "", "photographs taken while walking once round the tree", &o.photos, 1, 999, {}},
      {"held_out",
       "",
       "true views in between, for judging new views only",
       &o.held_out,
       0,
       999,
       {}},
      {"width_px", "px", "width of the pictures", &o.width_px, 16, 8192, {}},
      {"height_px", "px", "height of the pictures", &o.height_px, 16, 8192, {}},
      {"radius_m",
       "m",
       "distance walked from the trunk; 0 lets the tree fill the picture",
       &o.radius_m,
       0,
       500,
       {}},
      {"distortion",
       "",
       "how the lens bends straight lines (k1); 0 is a pinhole",
       &o.distortion,
       -0.2,
       0.2,
       {}},
      {"noise", "", "sensor noise, 1 like a good camera in daylight, 0 none", &o.noise, 0, 20, {}},
      {"exposure_drift",
       "stops",
       "how the exposure strays from photo to photo",
       &o.exposure_drift,
       0,
       2,
       {}},
      {"wind_m", "m", "how far the top of the tree sways between photos", &o.wind_m, 0, 2, {}},
      {"markers",
       "",
       "coloured balls on sticks round the tree, at known places",
       &o.markers,
       0,
       8,
       {}},
      {"board_photos",
       "",
       "photos of a chessboard besides, for calibrating the lens",
       &o.board_photos,
       0,
       100,
       {}},
      {"background",
       "",
       "sky, ground and other trees behind; off leaves black",
       &o.background,
       0,
       1,
       {}},
      {"sun_elevation_deg", "deg", "how high the sun stands", &o.sun_elevation_deg, 10, 85, {}},
      {"samples",
       "",
       "each pixel gathers samples x samples rays: 8 or 16, rounded up",
       &o.samples,
       4,
       32,
       {}},
      {"density_side", "", "voxels along an edge of the true density", &o.density_side, 4, 512, {}},
      {"scribbled_photos",
       "",
       "photos that get strokes, as a user would draw them",
       &o.scribbled_photos,
       0,
       999,
       {}},
  };
}

PhantomOptions tiny_phantom() {
  PhantomOptions options;
  options.height_m = 2.5;
  options.detail = 0.02;
  options.photos = 10;
  options.held_out = 2;
  options.width_px = 96;
  options.height_px = 128;
  options.density_side = 32;
  return options;
}

int ground_map_side(const PhantomOptions& options) { return std::clamp(options.width_px, 64, 640); }

}  // namespace bosk
