// How the workstation feels, replayed without a window: what its panels cost a frame at rest and
// while all cores compute, and how soon a stopped job is gone. Panel drawing alone: what a driver
// takes to show it comes on top.
//
//   workstation_benchmark [PHOTOS WIDTH_PX HEIGHT_PX [STOPS]]     (12 of 720 x 960 unless given)
//
// With STOPS only so many jobs are stopped, at random moments of their first 12 seconds.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <thread>
#include <vector>

#include "core/base/random.h"
#include "core/photo/child_mode.h"
#include "tests/base/scratch_folder.h"
#include "tests/benchmarks/frame_times.h"
#include "tests/benchmarks/run_or_explain.h"
#include "tests/benchmarks/sample_project.h"
#include "tests/ui/workstation/hand.h"
#include "ui/workstation/workstation.h"

namespace bosk {
namespace {

constexpr auto kFramePause = std::chrono::milliseconds(16);  // between frames, as a screen has it

void print_row(const std::string& what, const std::vector<double>& wall,
               const std::vector<double>& cpu) {
  std::printf("%-34s %6zu %8.2f %8.2f %8.2f %10.2f\n", what.c_str(), wall.size(),
              quantile(wall, 0.5), quantile(wall, 0.99), quantile(wall, 1.0), quantile(cpu, 0.99));
}

void time_steps(Hand& hand, const std::string& when) {
  for (const WorkStep step : kSteps) {
    hand.workspace().step = step;
    hand.settle();
    FrameTimes times;
    for (int i = 0; i < 200; ++i) times.add([&] { hand.frame(); });
    print_row(std::string(text_of(step).name) + ", " + when, times.wall, times.cpu);
  }
}

void time_while_solving(Hand& hand) {
  Workspace& workspace = hand.workspace();
  const std::pair<std::string, WorkStep> stages[] = {
      {"matte", WorkStep::matte},       {"opacity", WorkStep::volume},
      {"radiance", WorkStep::volume},   {"texture", WorkStep::textures},
      {"compress", WorkStep::codebook}, {"pack", WorkStep::preview}};
  for (const auto& [stage, step] : stages) {
    workspace.step = step;
    run_to(workspace, stage);
    FrameTimes times;
    while (workspace.jobs.busy(Lane::background)) {
      times.add([&] { hand.frame(); });
      std::this_thread::sleep_for(kFramePause);
    }
    print_row("while it makes " + stage, times.wall, times.cpu);
    hand.settle();
  }
}

// Stops the whole way to the package at random moments, from a fresh start each time.
void time_cancelling(Hand& hand, int rounds) {
  Workspace& workspace = hand.workspace();
  Random random(7);
  std::vector<double> wall;
  std::multimap<double, std::string> slowest;
  for (int i = 0; i < rounds; ++i) {
    std::filesystem::remove_all(workspace.project().cache_folder());
    workspace.results = {};
    workspace.made.clear();
    workspace.seen_revision.reset();
    hand.frame();
    run_to(workspace, "pack");
    std::this_thread::sleep_for(std::chrono::duration<double>(random.uniform(0.0, 12.0)));
    const std::vector<JobView> running = workspace.jobs.now();
    const auto start = Clock::now();
    workspace.jobs.cancel_all();
    while (workspace.jobs.busy(Lane::background)) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    wall.push_back(ms_since(start));
    slowest.emplace(-wall.back(), running.empty() ? "nothing" : running.front().phrase);
    hand.frame(2);
  }
  print_row("stopped at a random moment", wall, {});
  int shown = 0;
  for (const auto& [negative_ms, phrase] : slowest) {
    if (++shown <= 8) std::printf("  %6.1f ms after %s\n", -negative_ms, phrase.c_str());
  }
}

int run(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // each line as soon as it is known
  const auto number = [&](int at, int otherwise) {
    return count > at ? std::atoi(arguments[at]) : otherwise;
  };
  const ScratchFolder scratch;
  PhantomOptions options;
  options.photos = number(1, 12);
  options.width_px = number(2, 720);
  options.height_px = number(3, 960);
  const auto project = sample_project(scratch.path(), options, true);
  Hand hand;
  open_project(hand.workspace(), project);
  hand.settle();
  std::printf("%-34s %6s %8s %8s %8s %10s\n", "frames of 1400 x 900", "count", "median", "p99",
              "worst", "p99 CPU");
  std::printf("%-34s %6s %8s %8s %8s %10s\n", "", "", "ms", "ms", "ms", "ms");
  if (number(4, 0) == 0) {
    time_steps(hand, "nothing made");
    time_while_solving(hand);
    time_steps(hand, "all made");
  }
  time_cancelling(hand, std::max(40, number(4, 0)));
  return 0;
}

}  // namespace
}  // namespace bosk

int main(int count, char** arguments) {
  if (const auto status = bosk::run_child_mode(count, arguments)) return *status;
  return bosk::run_or_explain(bosk::run, count, arguments);
}
