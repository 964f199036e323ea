#include "ui/picture_pace.h"

namespace bosk {
namespace {

FrameCost cost_of(const FrameFigures& figures) { return {figures.trees_ms, figures.billboards}; }

}  // namespace

PictureKey picture_key(const ViewCamera& camera, const glm::ivec2& size_px,
                       const ViewOptions& options, double now_s) {
  ViewOptions copy = options;
  return {size_px, camera, values_text(describe(copy)), options.wind_m > 0.0 ? now_s : 0.0};
}

double share_while_moving(double whole_ms, double frame_ms) {
  if (frame_ms <= 0.0) return 1.0;
  for (const double share : {1.0, 0.5}) {
    if (whole_ms * share * share <= 2.0 * frame_ms) return share;
  }
  return 0.25;
}

double whole_picture_ms(const PicturePace& pace, const glm::ivec2& size_px) {
  if (!pace.drawn) return 0.0;
  const glm::dvec2 larger = glm::dvec2(size_px) / glm::max(glm::dvec2(pace.drawn->size_px), 1.0);
  return pace.figures.picture_ms * larger.x * larger.y;
}

bool draw_when_changed(PicturePace& pace, const PictureKey& key, const ViewOptions& options,
                       const DrawWithBudget& draw) {
  if (pace.drawn == key) return false;
  pace.drawn = key;
  const auto most = std::uint64_t(options.budget);
  const double target_ms = time_for_trees(options.frame_ms, pace.figures.scenery_ms);
  pace.moving_budget = options.frame_ms > 0.0
                           ? adapted_budget(pace.moving_budget, pace.moving_cost, target_ms, most)
                           : most;
  pace.figures = draw(key, pace.moving_budget);
  pace.moving_cost = cost_of(pace.figures);
  return true;
}

std::optional<std::uint64_t> better_budget(const PicturePace& pace, const ViewOptions& options) {
  const FrameFigures& figures = pace.figures;
  if (!pace.drawn || figures.detail >= options.detail) return std::nullopt;
  const double allowed_ms =
      options.still_ms > 0.0 ? time_for_trees(options.still_ms, figures.scenery_ms) : 0.0;
  return still_budget(figures.budget, cost_of(figures), allowed_ms, std::uint64_t(options.budget));
}

bool refine_at_rest(PicturePace& pace, const ViewOptions& options, const DrawWithBudget& draw) {
  const auto budget = better_budget(pace, options);
  if (budget) pace.figures = draw(*pace.drawn, *budget);
  return budget.has_value();
}

}  // namespace bosk
