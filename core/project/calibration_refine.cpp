#include "core/project/calibration_refine.h"

#include <algorithm>
#include <chrono>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/system_error.h"
#include "core/project/calibration_run.h"
#include "core/project/run.h"
#include "core/radiance/pose_refinement.h"

namespace bosk {
namespace {

constexpr double kSolveShare = 0.3, kMatteShare = 0.6, kRefineShare = 0.8;  // of a whole job

void require_mattes(const Project& project) {
  if (!project.mattes.empty() || !project.scribbles.empty() || !project.strokes.empty()) return;
  throw Error(printable(project.folder.string()) +
              ": calibrate.refine=silhouettes needs mattes, and nothing tells the tree from its "
              "background yet; the cameras are found: paint strokes or give mattes, then calibrate "
              "again");
}

std::string text_of(const PoseRefinement& refined) {
  const std::string before = number_text(refined.error_before, 4);
  const std::string after = number_text(refined.error_after, 4);
  if (!refined.accepted) {
    return "the mattes would not agree better with turned cameras (error of alpha " + before +
           ", then " + after + "): they stay as solved";
  }
  const double most = *std::max_element(refined.moved_px.begin(), refined.moved_px.end());
  return "cameras were turned by up to " + number_text(most, 1) +
         " px at the crown, after which the mattes agree better (error of alpha " + after +
         " instead of " + before + ")";
}

void take_poses(const Photos& photos, const PoseRefinement& refined, Calibration& calibration) {
  for (std::size_t i = 0; i < photos.size(); ++i) {
    for (Camera& camera : calibration.cameras) {
      if (camera.name == photos[i].name) camera.camera_from_world = refined.camera_from_world[i];
    }
  }
}

Calibration refined_by_mattes(const Project& project, Calibration calibration, Progress& progress) {
  const Capture capture = gather_capture(project, calibration);
  const Run made =
      run_stages(project, capture, {"view", "matte"}, progress, {kSolveShare, kMatteShare});
  progress.scope(kMatteShare, kRefineShare, "Cameras");
  const Photos& photos = *made.results.views;
  const PoseRefinement refined = refine_poses(photos, *made.results.mattes, {}, progress);
  take_poses(photos, refined, calibration);
  calibration.sentences.push_back(text_of(refined));
  return calibration;
}

}  // namespace

Calibration calibrate_project(const Project& project, const CalibrationSources& sources,
                              const Cache& cache, Progress& progress) {
  if (sources.options.refine == "none") return run_calibration(sources, cache, progress);
  if (auto stored = stored_refinement(sources, cache)) return *std::move(stored);
  const auto start = std::chrono::steady_clock::now();
  Calibration calibration;
  {
    const ProgressPart part(progress, 0.0, kSolveShare);
    calibration = run_calibration(sources, cache, progress);
  }
  if (calibration.verdict == Verdict::refused) return calibration;
  require_mattes(project);
  calibration = refined_by_mattes(project, std::move(calibration), progress);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  store_refinement(sources, calibration, spent.count(), cache);
  return calibration;
}

}  // namespace bosk
