#include "ui/workstation/capture_files.h"

#include "core/base/error.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

// What of the project says which files a run starts from.
std::uint64_t files_revision(const Project& project) {
  ContentHasher hasher;
  for (const auto& photo : project.photos) hasher.text(photo.string());
  hasher.text(project.cameras.string()).text(project.mattes.string());
  hasher.text(project.scribbles.string()).text(project.folder.string());
  return hasher.finish().low | 1;  // never 0, which means none
}

struct Gathered {
  std::shared_ptr<Capture> capture;
  std::string obstacle;
};

Gathered gathered(const Project& project, Progress& progress) {
  progress.begin("reading the files", 1);
  try {
    return {std::make_shared<Capture>(gather_capture(project)), {}};
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

}  // namespace

void reread_files(Workspace& workspace) {
  const std::uint64_t files = files_revision(workspace.project());
  workspace.seen_files = files;
  workspace.capture.reset();
  workspace.capture_obstacle = "the project's files are being read";
  workspace.jobs.start(
      "Reading files",
      [project = std::make_shared<const Project>(workspace.project())](Progress& progress) {
        return gathered(*project, progress);
      },
      [&workspace, files](Gathered result) { install(workspace, files, std::move(result)); },
      Lane::interactive, "files");
}

void refresh_capture(Workspace& workspace) {
  const Project& project = workspace.project();
  if (project.cameras.empty()) {
    workspace.seen_files = 0;
    workspace.capture.reset();
    workspace.capture_obstacle = project.photos.empty()
                                     ? "add photos in step Photos"
                                     : "import the photos' cameras in step Calibrate";
    return;
  }
  if (files_revision(project) != workspace.seen_files) {
    reread_files(workspace);
  } else if (workspace.capture && workspace.capture->strokes != project.strokes) {
    auto changed = std::make_shared<Capture>(*workspace.capture);
    changed->strokes = project.strokes;
    workspace.capture = std::move(changed);
  }
}

bool lacks_mattes(const Capture& capture) {
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
