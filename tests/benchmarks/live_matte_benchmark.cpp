// Speed of the matte that follows the brush, with how well it agrees with the full one.
//
//   live_matte_benchmark PHOTOS STROKES TRUTH [--cameras=FILE] [--matte.option=value ...]
//
// Folders as for matte_benchmark. Mattes all photos; then, per photo with strokes, prints wall
// milliseconds to make it ready, for a live matte (median of nine, and in CPU time) and to cancel
// one (worst of twenty, spread over its run), mean |live - full| without and with what the other
// photos say, and both mattes' mean error. Then milliseconds per view, and how well doubt ranks the
// true errors.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/image/area_mean.h"
#include "core/matte/live_matte.h"
#include "core/matte/matte_doubt.h"
#include "core/matte/matte_views.h"
#include "matte_folders.h"

namespace {

using namespace bosk;
using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// CPU milliseconds of one of `repeats` runs, all threads together.
double cpu_ms(int repeats, const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  for (int i = 0; i < repeats; ++i) work();
  return 1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC / repeats;
}

double median_ms(int repeats, const std::function<void()>& work) {
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const auto start = Clock::now();
    work();
    times.push_back(ms_since(start));
  }
  std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
  return times[std::size_t(repeats / 2)];
}

Image<float> alpha_of(const Matte& matte) {
  Image<float> alpha(matte.rgba.width(), matte.rgba.height());
  for (std::size_t i = 0; i < alpha.size(); ++i) alpha.data()[i] = matte.rgba.data()[i].a;
  return alpha;
}

double mean_difference(const Image<float>& a, const Image<float>& b) {
  const Image<float> small = area_mean(b, a.width(), a.height());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a.data()[i] - small.data()[i]);
  return sum / double(a.size());
}

// Milliseconds until a live matte that runs since `after_ms` has stopped.
double cancel_ms(const LivePhoto& photo, const Image<std::uint8_t>& strokes, double after_ms) {
  Progress progress;
  Clock::time_point asked;
  std::thread asker([&] {
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(after_ms));
    asked = Clock::now();
    progress.cancel();
  });
  bool stopped = false;
  try {
    live_matte(photo, strokes, Image<float>(1, 1), {}, progress);
  } catch (const Cancelled&) {
    stopped = true;
  }
  const auto end = Clock::now();
  asker.join();
  return stopped ? std::chrono::duration<double, std::milli>(end - asked).count() : 0.0;
}

double worst_cancel_ms(const LivePhoto& photo, const Image<std::uint8_t>& strokes,
                       double whole_ms) {
  double worst = 0.0;
  for (int i = 0; i < 20; ++i)
    worst = std::max(worst, cancel_ms(photo, strokes, whole_ms * i / 20));
  return worst;
}

void time_live(const Photo& photo, const Image<std::uint8_t>& strokes, const Image<float>& tilt,
               const Matte& full_matte, const Image<float>& truth, const MatteOptions& options) {
  Progress progress;
  LivePhoto ready;
  LiveMatte alone, live;
  const double ready_ms = median_ms(3, [&] { ready = ready_for_live(photo, progress); });
  const double live_ms = median_ms(
      9, [&] { alone = live_matte(ready, strokes, Image<float>(1, 1), options, progress); });
  const double live_cpu_ms =
      cpu_ms(3, [&] { live_matte(ready, strokes, Image<float>(1, 1), options, progress); });
  live = live_matte(ready, strokes, tilt, options, progress);
  const Image<float> full = alpha_of(full_matte);
  std::printf(
      "%-10s %6.0f %6.0f %6.0f %7.1f    %.4f  %.4f    %.4f  %.4f\n", photo.name.c_str(), ready_ms,
      live_ms, live_cpu_ms, worst_cancel_ms(ready, strokes, live_ms),
      mean_difference(alpha_of(alone.matte), full), mean_difference(alpha_of(live.matte), full),
      mean_difference(alpha_of(live.matte), truth),
      mean_difference(area_mean(full, live.matte.rgba.width(), live.matte.rgba.height()), truth));
}

void time_views(const Photo& photo, const Matte& matte, const Image<std::uint8_t>& strokes) {
  Progress progress;
  const LivePhoto ready = ready_for_live(photo, progress);
  const Image<glm::vec4> small(ready.small.srgb.width(), ready.small.srgb.height());
  std::printf("\nview, ms at %.2f MP    full matte  live matte  128 x 128 px\n",
              double(photo.srgb.size()) / 1e6);
  for (int i = 0; i < kMatteViews; ++i) {
    const auto view = MatteView(i);
    const MattedPhoto full{photo.srgb, matte.rgba, strokes}, live{photo.srgb, small, strokes};
    Image<glm::u8vec4> picture;
    const double full_ms = median_ms(9, [&] { picture = picture_of(view, full); });
    const double live_ms = median_ms(9, [&] { picture = picture_of(view, live); });
    const double part_ms = median_ms(9, [&] {
      repaint(view, live, {{200, 200}, {328, 328}}, picture);
    });
    std::printf("%-20s %10.2f  %10.2f  %12.3f\n", name_of(view), full_ms, live_ms, part_ms);
  }
}

std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<double> ranks;
  for (const double value : values) {
    ranks.push_back(double(
        std::count_if(values.begin(), values.end(), [&](double other) { return other < value; })));
  }
  return ranks;
}

// Spearman's, ties by their lowest rank.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> p = ranks_of(a), q = ranks_of(b);
  const double middle = (double(a.size()) - 1.0) / 2.0;
  double both = 0.0, pp = 0.0, qq = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += (p[i] - middle) * (q[i] - middle);
    pp += (p[i] - middle) * (p[i] - middle);
    qq += (q[i] - middle) * (q[i] - middle);
  }
  return both / std::sqrt(pp * qq);
}

void rank_doubts(const Photos& photos, const Mattes& mattes, const std::vector<double>& errors) {
  Progress progress;
  std::vector<MatteDoubt> doubts;
  const double ms = median_ms(1, [&] { doubts = doubt_mattes(photos, mattes, progress); });
  std::vector<double> values;
  for (const MatteDoubt& doubt : doubts) values.push_back(doubt.doubt);
  std::printf("\ndoubt of %zu mattes in %.0f ms, rank correlation with their error %+.2f\n",
              doubts.size(), ms, rank_correlation(values, errors));
  for (std::size_t i = 0; i < doubts.size(); ++i) {
    std::printf("%-10s doubt %.3f  sad %5.1f  %s\n", doubts[i].photo.c_str(), doubts[i].doubt,
                1000.0 * errors[i], doubts[i].reason.c_str());
  }
}

void run(const std::vector<std::string>& folders, const std::string& cameras,
         const MatteOptions& options) {
  const Photos photos = read_photos(folders[0], cameras);
  const Scribbles scribbles = read_scribbles(folders[1]);
  const auto truths = files_by_name(folders[2]);
  Progress progress;
  const Mattes mattes = matte_photos(photos, scribbles, options, progress);
  std::vector<Image<float>> tilts;
  const double hull_ms =
      median_ms(1, [&] { tilts = hull_tilts_from(photos, mattes, options, progress); });
  std::printf("what the others say of each photo: %.0f ms for all\n", hull_ms);
  std::printf("             wall ms    CPU ms         |live - full|    |- truth|\n");
  std::printf("photo       ready   live   live  cancel     alone   hull      live    full\n");
  std::vector<double> errors;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const Image<float> truth = read_alpha(truths.at(photos[i].name));
    errors.push_back(mean_difference(alpha_of(mattes[i]), truth));
    const auto strokes = scribbles.find(photos[i].name);
    if (strokes == scribbles.end()) continue;
    time_live(photos[i], strokes->second, tilts[i], mattes[i], truth, options);
    shown = i;
  }
  time_views(photos[shown], mattes[shown], scribbles.at(photos[shown].name));
  rank_doubts(photos, mattes, errors);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto [folders, cameras, options] = matte_arguments(argc, argv);
    if (folders.size() != 3) {
      throw Error(
          "usage: live_matte_benchmark PHOTOS STROKES TRUTH [--cameras=FILE] "
          "[--matte.option=value ...]");
    }
    run(folders, cameras, options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "live_matte_benchmark: %s\n", error.what());
    return 1;
  }
  return 0;
}
