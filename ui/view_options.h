#pragma once

#include <string>

#include "core/base/options.h"
#include "core/render/draw_list.h"
#include "core/render/view_blend.h"

namespace bosk {

// How a forest is looked at. The command line and the panel edit it alike.
struct ViewOptions {
  int budget = 1000000;      // billboards a picture, about; 0: no bound
  double frame_ms = 40.0;    // in the window, moving: the budget falls until a frame takes so long
  double still_ms = 2000.0;  // the same for a picture that stands still; 0: the budget alone
  double detail = 1.0;
  double dissolve = 1.25;
  std::string blend = "fading";
  double wind_m = 0.0;
  std::string colours = "tree";
  double view_angle_deg = 45.0;
  bool cameras = false;  // marks at the places that textures were baked towards
};
Options describe(ViewOptions& options);

DrawOptions draw_options(const ViewOptions& options, double half_angle);
double view_angle(const ViewOptions& options);  // radians

}  // namespace bosk
