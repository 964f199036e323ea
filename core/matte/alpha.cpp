#include "core/matte/alpha.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/matte/pair_kernel.h"

namespace bosk {
namespace {

// Where, between two grid rows or columns, a pixel of the full image lies.
struct GridPlace {
  int first = 0, second = 0;
  float mix = 0.0f;
};

GridPlace grid_place(int pixel, int pixels, int cells) {
  const float place = (float(pixel) + 0.5f) * float(cells) / float(pixels) - 0.5f;
  const int first = std::clamp(int(std::floor(place)), 0, cells - 1);
  return {first, std::min(first + 1, cells - 1), std::clamp(place - float(first), 0.0f, 1.0f)};
}

// One grid row, interpolated to image row y, times `factor`.
void grid_row(const Image<float>& grid, int y, int height, float factor, std::vector<float>& row) {
  const GridPlace place = grid_place(y, height, grid.height());
  row.resize(std::size_t(grid.width()));
  for (int x = 0; x < grid.width(); ++x) {
    row[std::size_t(x)] =
        factor * std::lerp(grid(x, place.first), grid(x, place.second), place.mix);
  }
}

// Buffers of one thread.
struct Workspace {
  std::vector<float> rows;  // one grid row per cluster of either kind, then the tilt
  std::vector<float> run_weights, scratch;
};

class RowMatter {
 public:
  RowMatter(const LabPlanes& lab, const StrokeModel& model, const Image<float>& tilt,
            const AlphaSettings& settings)
      : lab_(lab), tilt_(tilt), paths_(mixing_paths(model, settings.mixing)) {
    for (const StrokeCluster& cluster : model.foreground)
      grids_.push_back(&cluster.squared_distance);
    foreground_count_ = grids_.size();
    for (const StrokeCluster& cluster : model.background)
      grids_.push_back(&cluster.squared_distance);
    position_factor_ = -0.5f / (settings.position_sigma * settings.position_sigma);
    for (int x = 0; x < lab.l.width(); ++x) {
      columns_.push_back(grid_place(x, lab.l.width(), grids_.front()->width()));
      if (!tilt.empty()) tilt_columns_.push_back(grid_place(x, lab.l.width(), tilt.width()));
    }
  }

  void row(int y, Workspace& work, AlphaEstimate& estimate) const {
    const int width = lab_.l.width(), height = lab_.l.height();
    std::vector<std::vector<float>> rows(grids_.size() + 1);
    for (std::size_t g = 0; g < grids_.size(); ++g)
      grid_row(*grids_[g], y, height, position_factor_, rows[g]);
    if (!tilt_.empty()) grid_row(tilt_, y, height, 1.0f, rows.back());
    work.run_weights.resize((grids_.size() + 6) * kRun);
    work.scratch.resize(2 * paths_.size() * kRun);
    for (int x = 0; x < width; x += int(kRun)) run(x, y, rows, work, estimate);
  }

 private:
  void run(int x0, int y, const std::vector<std::vector<float>>& rows, Workspace& work,
           AlphaEstimate& estimate) const {
    const int count = std::min(int(kRun), lab_.l.width() - x0);
    float* next = work.run_weights.data();
    const auto filled = [&](auto&& value) {
      float* values = next;
      for (int i = 0; i < int(kRun); ++i) values[i] = value(std::min(x0 + i, lab_.l.width() - 1));
      next += kRun;
      return values;
    };
    for (std::size_t g = 0; g < grids_.size(); ++g) {
      filled([&](int x) { return at(rows[g], columns_[std::size_t(x)]); });
    }
    PixelRun run;
    run.foreground_log_weight = work.run_weights.data();
    run.background_log_weight = work.run_weights.data() + foreground_count_ * kRun;
    run.tilt = filled([&](int x) {
      return tilt_.empty() ? 0.0f : at(rows.back(), tilt_columns_[std::size_t(x)]);
    });
    run.l = filled([&](int x) { return lab_.l(x, y); });
    run.a = filled([&](int x) { return lab_.a(x, y); });
    run.b = filled([&](int x) { return lab_.b(x, y); });
    const AlphaRun result{next, next + kRun};
    alpha_of_run(paths_, run, work.scratch.data(), result);
    std::copy_n(result.alpha, count, &estimate.alpha(x0, y));
    std::copy_n(result.likelihood, count, &estimate.likelihood(x0, y));
  }

  static float at(const std::vector<float>& row, const GridPlace& place) {
    return std::lerp(row[std::size_t(place.first)], row[std::size_t(place.second)], place.mix);
  }

  const LabPlanes& lab_;
  const Image<float>& tilt_;
  std::vector<MixingPath> paths_;
  std::vector<const Image<float>*> grids_;  // foreground clusters first
  std::size_t foreground_count_ = 0;
  float position_factor_ = 0.0f;
  std::vector<GridPlace> columns_, tilt_columns_;
};

}  // namespace

AlphaEstimate estimate_alpha(const LabPlanes& lab, const StrokeModel& model,
                             const Image<float>& tilt, const AlphaSettings& settings,
                             Progress& progress) {
  const int width = lab.l.width(), height = lab.l.height();
  AlphaEstimate estimate{{width, height}, {width, height}};
  const RowMatter matter(lab, model, tilt, settings);
  tbb::enumerable_thread_specific<Workspace> workspaces;
  tbb::parallel_for(0, height, [&](int y) {
    matter.row(y, workspaces.local(), estimate);
    progress.advance();
  });
  return estimate;
}

}  // namespace bosk
