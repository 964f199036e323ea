// Poses refined by the tree itself: processor time, and how far the crown's corners are from where
// the true cameras see them, before and after, for growing errors of the poses.
//   pose_refinement_benchmark PROJECT [LONGEST_PX]    a project with true cameras

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "core/project/capture.h"
#include "core/project/run.h"
#include "core/radiance/pose_refinement.h"
#include "core/radiance/volume_snapshot.h"
#include "tests/benchmarks/run_or_explain.h"
#include "tests/radiance/disturbed_poses.h"

namespace bosk {
namespace {

constexpr double kErrorsPx[] = {0.0, 1.0, 2.0, 4.0, 8.0};

void measure(const Photos& truth, const Mattes& mattes, const Box& crown, double error_px,
             const PoseRefinementOptions& options) {
  const Photos photos = disturbed(truth, error_px, 7);
  Progress progress;
  const std::clock_t start = std::clock();
  const PoseRefinement refined = refine_poses(photos, mattes, options, progress);
  const double spent_s = double(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf("%8.1f %11.2f %10.2f %9s %12.4f %11.4f %9.1f\n", error_px,
              rms_px(truth, poses_of(photos), crown),
              rms_px(truth, refined.camera_from_world, crown), refined.accepted ? "yes" : "no",
              refined.error_before, refined.error_after, spent_s);
  std::fflush(stdout);
}

int run(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(stderr, "usage: pose_refinement_benchmark PROJECT [LONGEST_PX]\n");
    return 2;
  }
  const Project project = read_project(arguments[1]);
  Progress progress;
  const Run made = run_stages(project, gather_capture(project), {"view", "matte"}, progress);
  PoseRefinementOptions options;
  if (count > 2) options.longest_px = std::atoi(arguments[2]);
  OpacityOptions coarse;
  coarse.finest_level = 6;
  const OpacityTree tree =
      estimate_opacity(*made.results.views, *made.results.mattes, coarse, progress);
  const Box crown = snapshot_of(tree).bounds;
  std::printf("%8s %11s %10s %9s %12s %11s %9s\n", "sigma px", "before px", "after px", "accepted",
              "alpha before", "alpha after", "CPU s");
  for (const double error_px : kErrorsPx) {
    measure(*made.results.views, *made.results.mattes, crown, error_px, options);
  }
  return 0;
}

}  // namespace
}  // namespace bosk

int main(int count, char** arguments) { return bosk::run_or_explain(bosk::run, count, arguments); }
