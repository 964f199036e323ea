// How painting feels, replayed without a window: what the frame costs that shows a new point of a
// stroke, how soon the live matte follows, what undo costs, and what a change of view or photo
// does. The interface alone: what a driver takes to show it comes on top.
//
//   paint_benchmark [WIDTH_PX HEIGHT_PX]     (720 x 960 unless given)

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "core/image/orientation.h"
#include "core/photo/child_mode.h"
#include "tests/base/scratch_folder.h"
#include "tests/benchmarks/frame_times.h"
#include "tests/benchmarks/run_or_explain.h"
#include "tests/benchmarks/sample_project.h"
#include "tests/ui/workstation/hand.h"
#include "ui/widgets/keys.h"

namespace bosk {
namespace {

void print(const std::string& what, const FrameTimes& times) {
  const auto& [wall, cpu] = times;
  std::printf("%-44s %6zu %8.1f %8.1f %8.1f %10.1f %8.1f\n", what.c_str(), wall.size(),
              quantile(wall, 0.5), quantile(wall, 0.99), quantile(wall, 1.0), quantile(cpu, 0.5),
              quantile(cpu, 0.99));
}

class Painting {
 public:
  explicit Painting(const std::filesystem::path& project) : workspace_(hand_.workspace()) {
    open_project(workspace_, project);
    workspace_.step = WorkStep::matte;
    hand_.settle();
    hand_.wait_for([&] { return photo_on_canvas(workspace_) != nullptr; });
    hand_.settle();
  }

  // A wavy stroke across the photo, at shares of its size.
  void stroke(const glm::dvec2& from, const glm::dvec2& to, int points, FrameTimes& times) {
    const auto at = [&](double share) {
      glm::dvec2 place = glm::mix(from, to, share);
      place.y += 0.02 * std::sin(25.0 * share);
      return on_screen(place);
    };
    hand_.move_to(at(0.0));
    times.add([&] { hand_.press(); });
    for (int i = 1; i <= points; ++i) times.add([&] { hand_.move_to(at(double(i) / points)); });
  }
  void let_go(FrameTimes& times) {
    times.add([&] { hand_.release(); });
  }
  // Milliseconds from now until the live matte is of what is drawn.
  void wait_for_live(FrameTimes& times) {
    const MatteCanvas& canvas = workspace_.matte.canvas;
    times.add([&] {
      hand_.wait_for([&] {
        return canvas.live_of == canvas.live_asked &&
               canvas.live_of.strokes == canvas.strokes_revision;
      });
    });
  }
  void key(int number, bool ctrl, bool shift, FrameTimes& times) {
    hand_.hold_modifiers(ctrl, shift, false);
    times.add([&] { hand_.hold(number, true); });
    hand_.hold(number, false);
    hand_.hold_modifiers(false, false, false);
  }
  void settle() { hand_.settle(); }
  Workspace& workspace() { return workspace_; }

 private:
  ImVec2 on_screen(const glm::dvec2& share) {
    const Landmark canvas = hand_.at("matte/canvas");
    const Photo& photo = *photo_on_canvas(workspace_);
    const glm::dvec2 size =
        upright_size({photo.srgb.width(), photo.srgb.height()}, orientation_on_canvas(workspace_));
    const ImagePlace place = place_of(workspace_.matte.image_view, size, canvas.least, canvas.most);
    const glm::dvec2 at = place.screen_from_picture(share * size);
    return {float(at.x), float(at.y)};
  }

  Hand hand_;
  Workspace& workspace_;
};

void paint_and_print(Painting& painting) {
  FrameTimes quiet, point, release, live, undo, redo, view;
  painting.stroke({0.4, 0.4}, {0.6, 0.45}, 40, quiet);
  painting.let_go(quiet);
  painting.key('X', false, false, quiet);
  painting.stroke({0.1, 0.05}, {0.9, 0.1}, 40, quiet);
  painting.let_go(quiet);
  painting.settle();
  for (int i = 0; i < 20; ++i) {
    const double y = 0.75 + 0.01 * i;
    painting.stroke({0.1, y}, {0.9, y}, 60, point);
    painting.let_go(release);
    painting.wait_for_live(live);
  }
  const auto& strokes = painting.workspace().project().strokes;
  if (strokes.empty() || strokes.begin()->second.size() != 22) throw Error("strokes were lost");
  for (int i = 0; i < 20; ++i) painting.key('Z', true, false, undo);
  for (int i = 0; i < 20; ++i) painting.key('Z', true, true, redo);
  painting.settle();
  for (int i = 0; i < 18; ++i) painting.key('F', false, false, view);
  std::printf("%-44s %6s %8s %8s %8s %10s %8s\n", "ms", "count", "median", "p99", "worst",
              "CPU median", "CPU p99");
  print("frame with a new point of a stroke", point);
  print("frame that keeps the stroke", release);
  print("from there to its live matte", live);
  print("frame that undoes a stroke of 60 points", undo);
  print("frame that redoes it", redo);
  print("frame that changes the view", view);
}

int run(int count, char** arguments) {
  const auto number = [&](int at, int otherwise) {
    return count > at ? std::atoi(arguments[at]) : otherwise;
  };
  const ScratchFolder scratch;
  PhantomOptions options;
  options.photos = 4;
  options.held_out = 0;
  options.width_px = number(1, 720);
  options.height_px = number(2, 960);
  Painting painting(sample_project(scratch.path(), options, false));
  const Photo& photo = *photo_on_canvas(painting.workspace());
  std::printf("%.2f megapixels, window of 1400 x 900; CPU is the interface's thread\n",
              double(photo.srgb.size()) / 1e6);
  paint_and_print(painting);
  return 0;
}

}  // namespace
}  // namespace bosk

int main(int count, char** arguments) {
  if (const auto status = bosk::run_child_mode(count, arguments)) return *status;
  return bosk::run_or_explain(bosk::run, count, arguments);
}
