#include "ui/workstation/capture_files.h"

#include "core/base/error.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

// What says which files and cameras a run starts from. `solved` is the calibration's key where
// there is no camera file.
std::uint64_t files_revision(const Project& project, const ContentHash& solved) {
  ContentHasher hasher;
  hasher.value(solved.high).value(solved.low);
  for (const auto& photo : project.photos) hasher.text(photo.string());
  hasher.text(project.cameras.string()).text(project.mattes.string());
  hasher.text(project.scribbles.string()).text(project.folder.string());
  return hasher.finish().low | 1;  // never 0, which means none
}

struct Gathered {
  std::shared_ptr<Capture> capture;
  std::string obstacle;
};

// `solved` is null where the project has a camera file.
Gathered gathered(const Project& project, const Calibration* solved, Progress& progress) {
  progress.begin("reading the files", 1);
  try {
    return {std::make_shared<Capture>(solved ? gather_capture(project, *solved)
                                             : gather_capture(project)),
            {}};
  } catch (const Error& error) {
    return {nullptr, error.what()};
  }
}

void install(Workspace& workspace, std::uint64_t files, Gathered result) {
  if (!workspace.session || workspace.seen_files != files) return;  // another change overtook it
  if (result.capture) result.capture->strokes = workspace.project().strokes;
  workspace.capture = std::move(result.capture);
  workspace.capture_obstacle = std::move(result.obstacle);
  workspace.seen_revision.reset();
}

ContentHash key_of_cameras(const Workspace& workspace) {
  return workspace.project().cameras.empty() ? workspace.calibrate.solved.key : ContentHash();
}

// Whether the project's cameras are known, be it from its file or from a calibration.
bool has_cameras(const Workspace& workspace) {
  if (!workspace.project().cameras.empty()) return true;
  const auto solved = current_calibration(workspace);
  return solved && solved->verdict != Verdict::refused;
}

}  // namespace

void reread_files(Workspace& workspace) {
  const std::uint64_t files = files_revision(workspace.project(), key_of_cameras(workspace));
  workspace.seen_files = files;
  workspace.capture.reset();
  workspace.capture_obstacle = "the project's files are being read";
  workspace.jobs.start(
      "Reading files",
      [project = std::make_shared<const Project>(workspace.project()),
       solved = current_calibration(workspace)](Progress& progress) {
        return gathered(*project, solved.get(), progress);
      },
      [&workspace, files](Gathered result) { install(workspace, files, std::move(result)); },
      Lane::interactive, "files");
}

void refresh_capture(Workspace& workspace) {
  const Project& project = workspace.project();
  if (!has_cameras(workspace)) {
    workspace.seen_files = 0;
    workspace.capture.reset();
    workspace.capture_obstacle = obstacle_to_cameras(workspace);
    return;
  }
  if (files_revision(project, key_of_cameras(workspace)) != workspace.seen_files) {
    reread_files(workspace);
  } else if (workspace.capture && workspace.capture->strokes != project.strokes) {
    auto changed = std::make_shared<Capture>(*workspace.capture);
    changed->strokes = project.strokes;
    workspace.capture = std::move(changed);
  }
}

bool begins_with_a_guess(const Capture& capture) {
  const auto holds = [](const std::vector<Stroke>& strokes, StrokeKind kind) {
    return std::any_of(strokes.begin(), strokes.end(),
                       [&](const Stroke& stroke) { return stroke.kind == kind; });
  };
  const bool painted =
      std::any_of(capture.strokes.begin(), capture.strokes.end(), [&](const auto& photo) {
        return holds(photo.second, StrokeKind::foreground) &&
               holds(photo.second, StrokeKind::background);
      });
  return capture.mattes.empty() && capture.scribbles.empty() && !painted;
}

}  // namespace bosk
