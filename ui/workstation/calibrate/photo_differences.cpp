#include "ui/workstation/calibrate/photo_differences.h"

#include <algorithm>

#include "core/radiance/volume_snapshot.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr int kFinestLevel = 7;  // finer cells make no difference in pictures this small

const char* volume_stage(const Workspace& workspace) {
  return workspace.results.radiance ? "radiance" : "opacity";
}

ContentHash key_of(const Workspace& workspace, const std::string& stage) {
  const auto made = workspace.made.find(stage);
  return made == workspace.made.end() ? ContentHash{} : made->second;
}

// Not while mattes were made anew and what belongs to the volume was not.
bool are_of_the_same_photos(const Photos& views, const Mattes& mattes) {
  return std::equal(views.begin(), views.end(), mattes.begin(), mattes.end(),
                    [](const Photo& view, const Matte& matte) { return view.name == matte.name; });
}

std::map<std::string, PhotoResidual> compared(const Results& results, Progress& progress) {
  progress.begin("comparing photos with the volume", 2);
  const VolumeSnapshot volume = results.radiance ? snapshot_of(*results.radiance, kFinestLevel)
                                                 : snapshot_of(*results.opacity, kFinestLevel);
  progress.advance();
  std::map<std::string, PhotoResidual> by_name;
  const auto mattes = small_mattes(*results.views, *results.mattes);
  for (const PhotoResidual& residual : photo_residuals(volume, mattes)) {
    by_name[residual.name] = residual;
  }
  return by_name;
}

}  // namespace

std::string obstacle_to_differences(const Workspace& workspace) {
  const Results& results = workspace.results;
  if (!results.mattes || !results.views) {
    return "nothing to compare yet: once there are mattes and a volume (steps Matte and Volume), "
           "each photo's difference from it stands here";
  }
  if (!are_of_the_same_photos(*results.views, *results.mattes)) {
    return "the mattes are of other photos than the volume; make the volume again (step Volume)";
  }
  if (!results.opacity && !results.radiance) {
    return "nothing to compare yet: once there is a volume (step Volume), each photo's difference "
           "from it stands here";
  }
  return {};
}

void follow_differences(Workspace& workspace) {
  PhotoDifferences& state = workspace.calibrate.differences;
  if (!obstacle_to_differences(workspace).empty()) {
    state = {};
    return;
  }
  const ContentHash volume = key_of(workspace, volume_stage(workspace));
  const ContentHash mattes = key_of(workspace, "matte");
  if (volume == state.volume && mattes == state.mattes) return;
  state = {};
  state.volume = volume;
  state.mattes = mattes;
  state.has_colour = workspace.results.radiance != nullptr;
  Results needed;  // not the rest: it may go while this runs
  needed.views = workspace.results.views;
  needed.mattes = workspace.results.mattes;
  needed.opacity = workspace.results.opacity;
  needed.radiance = workspace.results.radiance;
  workspace.jobs.start(
      "Comparing photos", [needed](Progress& progress) { return compared(needed, progress); },
      [&workspace, volume, mattes](std::map<std::string, PhotoResidual> by_name) {
        PhotoDifferences& now = workspace.calibrate.differences;
        if (now.volume == volume && now.mattes == mattes) now.by_name = std::move(by_name);
      },
      Lane::interactive, "differences");
}

}  // namespace bosk
