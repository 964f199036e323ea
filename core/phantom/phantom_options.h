#pragma once

#include <string>

#include "core/base/options.h"

namespace bosk {

// What to make and how to photograph it.
struct PhantomOptions {
  std::string preset = "dense";  // dense, sparse or conical
  int seed = 1;
  double height_m = 0.0;  // 0: the preset's own, about 9 m
  double detail = 1.0;    // share of a full tree's branches and leaves
  int photos = 24, held_out = 12;
  int width_px = 480, height_px = 640;
  double radius_m = 0.0;        // of the walk round the tree; 0: so that the tree fills the picture
  double distortion = -0.06;    // k1 of the lens; k2 follows; 0 is a pinhole
  double noise = 1.0;           // of the sensor, 1 like a good camera
  double exposure_drift = 0.0;  // stops from photo to photo, standard deviation
  double wind_m = 0.0;          // sway at the top of the tree from photo to photo
  int markers = 6;              // coloured balls on sticks
  int board_photos = 0;         // photos of a chessboard besides, for calibrating the lens
  bool background = true;       // sky, ground and other trees; false leaves black
  double sun_elevation_deg = 48.0;
  int samples = 8;  // rays a pixel: samples x samples, in steps of 8 rows
  int density_side = 64;
  int scribbled_photos = 1;
};
Options describe(PhantomOptions& options);

// A small tree in small pictures, ready in well under a second: for tests.
PhantomOptions tiny_phantom();

// What PhantomOptions mean for the surroundings' cost: side of the ground's shadow map.
int ground_map_side(const PhantomOptions& options);

}  // namespace bosk
