#include "core/matte/alpha.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/matte/grid.h"
#include "core/matte/pair_kernel.h"

namespace bosk {
namespace {

using Row = std::vector<float>;

// Grid values interpolated to image row y, times `factor`.
void interpolate_row(const Image<float>& grid, const GridPlace& place, float factor, Row& row) {
  row.resize(std::size_t(grid.width()));
  for (int x = 0; x < grid.width(); ++x) {
    row[std::size_t(x)] =
        factor * std::lerp(grid(x, place.first), grid(x, place.second), place.mix);
  }
}

// Turns logarithms of weights into ones whose weights sum to 1 at each place.
void normalise(Row* rows, std::size_t count) {
  for (std::size_t x = 0; x < rows[0].size(); ++x) {
    float greatest = -1e30f, sum = 0.0f;
    for (std::size_t i = 0; i < count; ++i) greatest = std::max(greatest, rows[i][x]);
    for (std::size_t i = 0; i < count; ++i) sum += std::exp(rows[i][x] - greatest);
    const float shift = greatest + std::log(sum);
    for (std::size_t i = 0; i < count; ++i) rows[i][x] -= shift;
  }
}

// Buffers of one thread.
struct Workspace {
  std::vector<Row> rows;  // one per cluster, foreground first, then the tilt
  std::vector<float> run, scratch;
};

class RowMatter {
 public:
  RowMatter(const LabPlanes& lab, const StrokeModel& model, const Image<float>& tilt,
            const AlphaSettings& settings)
      : lab_(lab),
        tilt_(tilt),
        colours_{mixing_paths(model, settings.mixing), pure_colours(model, settings.purity)},
        foreground_count_(model.foreground.size()),
        log_weight_per_square_(-0.5f / (settings.position_sigma * settings.position_sigma)) {
    for (const StrokeCluster& cluster : model.foreground)
      grids_.push_back(&cluster.squared_distance);
    for (const StrokeCluster& cluster : model.background)
      grids_.push_back(&cluster.squared_distance);
    for (int x = 0; x < lab.l.width(); ++x) {
      columns_.push_back(grid_place(x, lab.l.width(), grids_.front()->width()));
      tilt_columns_.push_back(grid_place(x, lab.l.width(), tilt.width()));
    }
  }

  void matte_row(int y, Workspace& work, AlphaEstimate& estimate) const {
    const int height = lab_.l.height();
    work.rows.resize(grids_.size() + 1);
    work.run.resize((grids_.size() + 6) * kRun);
    work.scratch.resize(scratch_size(colours_));
    const GridPlace place = grid_place(y, height, grids_.front()->height());
    for (std::size_t g = 0; g < grids_.size(); ++g) {
      interpolate_row(*grids_[g], place, log_weight_per_square_, work.rows[g]);
    }
    normalise(work.rows.data(), foreground_count_);
    normalise(work.rows.data() + foreground_count_, grids_.size() - foreground_count_);
    interpolate_row(tilt_, grid_place(y, height, tilt_.height()), 1.0f, work.rows.back());
    for (int x = 0; x < lab_.l.width(); x += int(kRun)) matte_run(x, y, work, estimate);
  }

 private:
  // Beyond the right border the last pixel repeats.
  void matte_run(int x0, int y, Workspace& work, AlphaEstimate& estimate) const {
    float* next = work.run.data();
    const auto fill = [&](auto&& value_at) {
      for (int i = 0; i < int(kRun); ++i) next[i] = value_at(std::min(x0 + i, lab_.l.width() - 1));
      next += kRun;
      return next - kRun;
    };
    const auto fill_from = [&](const Row& row, const std::vector<GridPlace>& columns) {
      return fill([&](int x) {
        const GridPlace& place = columns[std::size_t(x)];
        return std::lerp(row[std::size_t(place.first)], row[std::size_t(place.second)], place.mix);
      });
    };
    PixelRun run;
    run.foreground_log_weight = next;
    run.background_log_weight = next + foreground_count_ * kRun;
    for (std::size_t g = 0; g < grids_.size(); ++g) fill_from(work.rows[g], columns_);
    run.tilt = fill_from(work.rows.back(), tilt_columns_);
    run.l = fill([&](int x) { return lab_.l(x, y); });
    run.a = fill([&](int x) { return lab_.a(x, y); });
    run.b = fill([&](int x) { return lab_.b(x, y); });
    const AlphaRun result{next, next + kRun};
    alpha_of_run(colours_, run, work.scratch.data(), result);
    const int count = std::min(int(kRun), lab_.l.width() - x0);
    std::copy_n(result.alpha, count, &estimate.alpha(x0, y));
    std::copy_n(result.likelihood, count, &estimate.likelihood(x0, y));
  }

  const LabPlanes& lab_;
  const Image<float>& tilt_;
  MixedColours colours_;
  std::vector<const Image<float>*> grids_;  // squared distances, foreground clusters first
  std::size_t foreground_count_ = 0;
  float log_weight_per_square_ = 0.0f;
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
    matter.matte_row(y, workspaces.local(), estimate);
    progress.advance();
  });
  return estimate;
}

}  // namespace bosk
