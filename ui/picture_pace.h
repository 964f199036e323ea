#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "ui/camera_controls.h"
#include "ui/frame_budget.h"
#include "ui/frame_figures.h"
#include "ui/view_options.h"

namespace bosk {

// All that a picture depends on but its budget; another one asks for another picture.
struct PictureKey {
  glm::ivec2 size_px{0};
  ViewCamera camera;
  std::string options;
  double wind_time_s = 0.0;

  bool operator==(const PictureKey&) const = default;
};
// `now_s` counts only where there is wind.
PictureKey picture_key(const ViewCamera& camera, const glm::ivec2& size_px,
                       const ViewOptions& options, double now_s);

// When a picture is drawn anew, and with how many billboards.
struct PicturePace {
  std::optional<PictureKey> drawn;      // of the newest picture; none: there is none yet
  FrameFigures figures;                 // of it
  std::uint64_t moving_budget = 20000;  // before any picture was timed
  FrameCost moving_cost;
};

// The share of its width and height that a picture is drawn in while it moves, 1, 1/2 or 1/4, so
// that it takes about `frame_ms` on a driver that needs `whole_ms` for a whole one.
double share_while_moving(double whole_ms, double frame_ms);
// About what the newest picture would have taken in `size_px`.
double whole_picture_ms(const PicturePace& pace, const glm::ivec2& size_px);

using DrawWithBudget = std::function<FrameFigures(const PictureKey&, std::uint64_t budget)>;

// Draws a picture when anything that it shows has changed, with a budget that follows the time that
// the last ones took. Returns whether it drew.
bool draw_when_changed(PicturePace& pace, const PictureKey& key, const ViewOptions& options,
                       const DrawWithBudget& draw);

// The budget of a better picture of the same, to be had within about `still_ms`; none: there is
// none.
std::optional<std::uint64_t> better_budget(const PicturePace& pace, const ViewOptions& options);
// Draws it, now that nothing moves. Returns whether it drew.
bool refine_at_rest(PicturePace& pace, const ViewOptions& options, const DrawWithBudget& draw);

}  // namespace bosk
