// Speed against accuracy of a forest drawn through OpenGL without a window, as Markdown.
//
//     forest_gl_benchmark walk FRAMES TREE.bosk...    290 trees of the kinds given (the scene of
//     Linz et al. 2006): time a
//                                                     frame, billboards, and PSNR against the same
//                                                     frames at the finest level
//     forest_gl_benchmark dolly STEPS TREE.bosk       one tree from afar to near: the change from
//     frame to frame, beside that
//                                                     of the finest level at the same steps

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

#include "core/render/forest.h"
#include "core/render/gl/forest_renderer.h"
#include "core/render/gl/headless_context.h"
#include "core/render/gl/offscreen_target.h"
#include "core/render/reference.h"
#include "tests/benchmarks/packages.h"
#include "tests/benchmarks/run_or_explain.h"
#include "tests/render/toy_trees.h"

namespace bosk {
namespace {

constexpr int kWidth_px = 640, kHeight_px = 360;
constexpr double kFocalPx = 550.0;  // 60 degrees across
constexpr double kHalfAngle = 0.59;
constexpr int kLarger = 4;
constexpr glm::vec3 kSky{0.75f, 0.82f, 0.92f};

Camera camera_at(const glm::dvec3& eye, const glm::dvec3& target) {
  return toy::look_at(eye, target, kFocalPx, kWidth_px, kHeight_px);
}

struct Frame {
  Image<glm::vec4> picture;
  std::uint64_t billboards = 0;
  double seconds = 0.0, list_seconds = 0.0;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The mean of blocks of 4 x 4 pixels.
Image<glm::vec4> reduced(const Image<glm::vec4>& large) {
  Image<glm::vec4> small(large.width() / kLarger, large.height() / kLarger, glm::vec4(0.0f));
  for (int y = 0; y < small.height() * kLarger; ++y)
    for (int x = 0; x < small.width() * kLarger; ++x)
      small(x / kLarger, y / kLarger) += large(x, y) / float(kLarger * kLarger);
  return small;
}

class Stage {
 public:
  explicit Stage(const Forest& forest) : forest_(forest), renderer_(forest) {}

  // The finest level drawn larger and reduced: what it would look like if it were drawn right where
  // its cells are far below a pixel.
  Image<glm::vec4> draw_truth(Camera camera, DrawOptions options) {
    options.detail = 1e6;
    camera.lens = scaled(camera.lens, kLarger * kWidth_px, kLarger * kHeight_px);
    forest_.draw_list(viewpoint_of(camera), options, 0, list_);
    const OffscreenTarget large(kLarger * kWidth_px, kLarger * kHeight_px);
    large.bind();
    large.clear(glm::vec4(kSky, 1.0f));
    renderer_.draw(list_, camera, {});
    return reduced(large.read());
  }

  Frame draw(const Camera& camera, const DrawOptions& options, std::uint64_t budget) {
    Frame frame;
    const auto start = std::chrono::steady_clock::now();
    forest_.draw_list(viewpoint_of(camera), options, budget, list_);
    frame.list_seconds = seconds_since(start);
    target_.bind();
    target_.clear(glm::vec4(kSky, 1.0f));
    renderer_.draw(list_, camera, {});
    frame.picture = target_.read();
    frame.seconds = seconds_since(start);
    frame.billboards = list_.billboards;
    return frame;
  }

  ForestRenderer::Memory memory() const { return renderer_.memory(); }

 private:
  const Forest& forest_;
  ForestRenderer renderer_;
  OffscreenTarget target_{kWidth_px, kHeight_px};
  ForestDrawList list_;
};

double mean_squared_difference(const Image<glm::vec4>& a, const Image<glm::vec4>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::dvec3 difference = glm::dvec3(a.pixels()[i]) - glm::dvec3(b.pixels()[i]);
    sum += glm::dot(difference, difference);
  }
  return sum / (3.0 * double(a.size()));
}

double decibels(double squared) { return -10.0 * std::log10(std::max(squared, 1e-12)); }

Forest forest_of(const std::vector<std::shared_ptr<const PreparedTree>>& trees) {
  constexpr std::size_t kTrees = 290;
  constexpr double kSpacing_m = 14.0;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  const double side_m = kSpacing_m * std::sqrt(double(kTrees));
  std::vector<TreeInstance> instances(kTrees);
  for (TreeInstance& instance : instances) {
    instance.tree = std::uint32_t(random() % trees.size());
    instance.place = {side_m * unit(random), side_m * unit(random), 0.0};
    instance.turn = 6.28 * unit(random);
    instance.scale = 1.0 + 0.4 * unit(random);
  }
  return {trees, instances};
}

// A walk along a circle of 120 m around the middle of the forest, looking across it.
Camera walk(int frame, int frames) {
  const double angle = 1.5 * frame / std::max(frames, 1);
  const glm::dvec3 eye(120.0 * std::cos(angle), 120.0 * std::sin(angle), 1.7);
  return camera_at(eye, {10.0, 0.0, 6.0});
}

struct Setting {
  std::string name;
  double detail = 1.0;
  std::uint64_t budget = 0;
};

void print_walk(int frames, const std::vector<std::shared_ptr<const PreparedTree>>& trees) {
  const Forest forest = forest_of(trees);
  Stage stage(forest);
  DrawOptions options;
  options.half_angle = kHalfAngle;
  std::vector<Setting> settings = {{"detail 1", 1.0, 0},
                                   {"detail 1/2", 0.5, 0},
                                   {"detail 1/4", 0.25, 0},
                                   {"detail 1/8", 0.125, 0},
                                   {"300,000 billboards", 1.0, 300000},
                                   {"100,000 billboards", 1.0, 100000}};
  std::vector<Frame> sums(settings.size() + 1);
  std::vector<double> errors(settings.size() + 1, 0.0), true_errors(settings.size() + 1, 0.0);
  for (int i = 0; i < frames; ++i) {
    const Camera camera = walk(i, frames);
    DrawOptions finest = options;
    finest.detail = 1e6;
    const Frame truth = stage.draw(camera, finest, 0);
    const auto add = [](Frame& sum, const Frame& frame) {
      sum.billboards += frame.billboards;
      sum.seconds += frame.seconds;
      sum.list_seconds += frame.list_seconds;
    };
    const Image<glm::vec4> larger = stage.draw_truth(camera, options);
    add(sums.back(), truth);
    true_errors.back() += mean_squared_difference(truth.picture, larger);
    for (std::size_t s = 0; s < settings.size(); ++s) {
      options.detail = settings[s].detail;
      const Frame frame = stage.draw(camera, options, settings[s].budget);
      add(sums[s], frame);
      errors[s] += mean_squared_difference(frame.picture, truth.picture);
      true_errors[s] += mean_squared_difference(frame.picture, larger);
    }
  }
  settings.push_back({"finest level", 0.0, 0});
  std::printf(
      "PSNR in dB against the finest level, drawn alike and drawn 4 times larger and reduced.\n\n");
  std::printf(
      "| %d frames of 640 x 360 | billboards | list, ms | frame, ms | times faster | alike | "
      "larger |\n",
      frames);
  std::printf("|---|---|---|---|---|---|---|\n");
  for (std::size_t s = 0; s < settings.size(); ++s) {
    std::printf("| %s | %.0f | %.3f | %.0f | %.1f | %.1f | %.1f |\n", settings[s].name.c_str(),
                double(sums[s].billboards) / frames, 1e3 * sums[s].list_seconds / frames,
                1e3 * sums[s].seconds / frames, sums.back().seconds / sums[s].seconds,
                decibels(errors[s] / frames), decibels(true_errors[s] / frames));
  }
  const auto memory = stage.memory();
  std::printf(
      "\nOn the GPU, MB: atlases %.2f, indices %.1f, cells and orders %.1f, a frame %.1f.\n",
      1e-6 * double(memory.atlases), 1e-6 * double(memory.indices), 1e-6 * double(memory.cells),
      1e-6 * double(memory.frame));
}

// From 8 to 400 px tall, each step nearer by the same factor.
void print_dolly(int steps, const std::vector<std::shared_ptr<const PreparedTree>>& trees) {
  const Forest forest(trees, {TreeInstance{}});
  Stage stage(forest);
  DrawOptions by_size, finest;
  finest.detail = 1e6;
  const PreparedTree& tree = *trees.front();
  const glm::dvec3 middle = 0.5 * (tree.lower() + tree.upper());
  const double height_m = tree.upper().z - tree.lower().z;
  Image<glm::vec4> last, last_finest;
  double worst = 0.0;
  int above = 0;
  std::printf(
      "| height, px | change by level | change of the finest | ratio |\n|---|---|---|---|\n");
  for (int step = 0; step <= steps; ++step) {
    const double height_px = 8.0 * std::pow(50.0, double(step) / steps);
    const double distance_m = kFocalPx * height_m / height_px;
    const Camera camera = camera_at(middle + glm::dvec3(0.3, -1.0, 0.05) * distance_m, middle);
    Image<glm::vec4> picture = stage.draw(camera, by_size, 0).picture;
    Image<glm::vec4> truth = stage.draw(camera, finest, 0).picture;
    if (step > 0) {
      const double change = std::sqrt(mean_squared_difference(picture, last));
      const double own = std::sqrt(mean_squared_difference(truth, last_finest));
      const double ratio = change / own;
      above += ratio > 2.0 ? 1 : 0;
      if (ratio > worst) {
        worst = ratio;
        std::printf("| %.1f | %.5f | %.5f | %.2f |\n", height_px, change, own, ratio);
      }
    }
    last = std::move(picture);
    last_finest = std::move(truth);
  }
  std::printf(
      "\nRoot mean squared changes between frames, of %d steps; the largest ratio so far is "
      "printed: %.2f in the end; above 2: %d.\n",
      steps, worst, above);
}

int run(int count, char** arguments) {
  const std::string what = count > 3 ? arguments[1] : "";
  if (what != "walk" && what != "dolly") {
    std::cerr << "usage: forest_gl_benchmark walk FRAMES TREE.bosk... | dolly STEPS TREE.bosk\n";
    return 2;
  }
  const Packages packages = load_packages(count - 3, arguments + 3);
  const HeadlessContext context;
  std::printf("%s\n\n", context.description().c_str());
  const int number = std::max(1, std::atoi(arguments[2]));
  what == "walk" ? print_walk(number, packages.trees) : print_dolly(number, packages.trees);
  return 0;
}

}  // namespace
}  // namespace bosk

int main(int count, char** arguments) { return bosk::run_or_explain(bosk::run, count, arguments); }
