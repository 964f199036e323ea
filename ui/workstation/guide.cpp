#include "ui/workstation/guide.h"

#include <algorithm>

#include "ui/workstation/calibrate/solved_guide.h"
#include "ui/workstation/capture_files.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

std::string count_text(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

StepGuide photos_guide(const Workspace& workspace) {
  const std::size_t photos = workspace.project().photos.size();
  if (photos == 0) {
    return {Tone::note, "needs photos", "about 24 photographs of one tree, from all around it", "",
            "drop photographs or their folder on the window, or type where they are"};
  }
  const auto& rows = workspace.photos.shelf.rows;
  const auto left_out = std::size_t(std::count_if(
      rows.begin(), rows.end(), [](const PhotoRow& row) { return row.tone == Tone::bad; }));
  std::string has = count_text(photos, "photo");
  if (left_out > 0) has += ", " + std::to_string(left_out) + " of them left out or missing";
  if (photos < 2) return {Tone::note, "needs photos", "two photos or more", has, "add more photos"};
  const std::string advice = photos < 12 ? "more photos give a better tree; " : "";
  return {Tone::good, "ready", "", has, advice + "look at the verdicts, then go on to Calibrate"};
}

StepGuide calibrate_guide(const Workspace& workspace) {
  const Project& project = workspace.project();
  if (project.photos.empty()) return {Tone::muted, "waits", "photos (step Photos)", "", ""};
  if (project.cameras.empty()) return solved_guide(workspace);
  if (workspace.capture) {
    return {Tone::good, "ready", "",
            "cameras of " + count_text(workspace.capture->cameras.size(), "photo"),
            "check in the view that up is up, then go on to Matte"};
  }
  return {Tone::bad, "look here", workspace.capture_obstacle, "", "choose another camera file"};
}

// Of a step that a stage makes.
StepGuide stage_guide(const Workspace& workspace, const std::string& stage,
                      const std::string& action) {
  const std::string obstacle = obstacle_to_stages(workspace);
  if (waits(workspace, stage)) {
    return {Tone::busy, "waits", "", "", "it begins when the job at work is done"};
  }
  if (is_running(workspace, stage)) return {Tone::busy, "at work", "", "", "watch, or stop it"};
  const StageState state = state_of(workspace, stage);
  if (state == StageState::current) return {Tone::good, "done", "", "", "go on to the next step"};
  if (state == StageState::stored) return {Tone::good, "done", "", "finished earlier", "load it"};
  if (!obstacle.empty()) return {Tone::muted, "waits", obstacle, "", ""};
  if (state == StageState::outdated) {
    return {Tone::note, "out of date", "", "an older result is shown", action + " again"};
  }
  return {Tone::note, "to do", "", "", action};
}

StepGuide matte_guide(const Workspace& workspace) {
  const bool guessed = workspace.capture && begins_with_a_guess(*workspace.capture);
  StepGuide guide = stage_guide(workspace, "matte", "matte all photos");
  if (guessed && guide.state == "to do") {
    guide.next += ": without strokes the tree is guessed, and strokes correct it";
  }
  std::size_t strokes = 0;
  for (const auto& [photo, list] : workspace.project().strokes) strokes += list.size();
  if (strokes > 0) {
    guide.has = count_text(strokes, "stroke") + " on " +
                count_text(workspace.project().strokes.size(), "photo");
  }
  return guide;
}

StepGuide package_guide(const Workspace& workspace, const std::string& next) {
  StepGuide guide = stage_guide(workspace, "pack", "make the package");
  if (state_of(workspace, "pack") == StageState::current && guide.tone == Tone::good) {
    guide.next = next;
  }
  return guide;
}

}  // namespace

std::string stage_of(WorkStep step) {
  switch (step) {
    case WorkStep::photos:
    case WorkStep::calibrate:
      break;
    case WorkStep::matte:
      return "matte";
    case WorkStep::volume:
      return "radiance";
    case WorkStep::textures:
      return "texture";
    case WorkStep::codebook:
      return "compress";
    case WorkStep::preview:
    case WorkStep::export_tree:
      return "pack";
  }
  return {};
}

StepGuide guide_of(const Workspace& workspace, WorkStep step) {
  if (!workspace.session) return {Tone::muted, "waits", "a project", "", "open or make a project"};
  switch (step) {
    case WorkStep::photos:
      return photos_guide(workspace);
    case WorkStep::calibrate:
      return calibrate_guide(workspace);
    case WorkStep::matte:
      return matte_guide(workspace);
    case WorkStep::volume:
      return stage_guide(workspace, "radiance", "make the volume");
    case WorkStep::textures:
      return stage_guide(workspace, "texture", "bake the textures");
    case WorkStep::codebook:
      return stage_guide(workspace, "compress", "train the codebooks");
    case WorkStep::preview:
      return package_guide(workspace,
                           "look round, compare with the photos, score on held-out ones");
    case WorkStep::export_tree:
      return package_guide(workspace, "write what you need");
  }
  return {};
}

}  // namespace bosk
