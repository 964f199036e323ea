#include "ui/workstation/calibrate/camera_import.h"

#include <memory>

#include "core/base/system_error.h"
#include "core/project/camera_choice.h"
#include "ui/workstation/calibrate/camera_measures.h"
#include "ui/workstation/capture_files.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kFewestPhotos = 2;

struct Imported {
  fs::path cameras;   // as the project is to have it; empty: they don't fit
  std::string words;  // how they match, or what is wrong
};

std::string misfit_words(const CameraChoice& choice) {
  return printable(choice.chosen.string()) + ": " + match_words(choice.matched, choice.unmatched) +
         ", and two are needed. Cameras are matched by the photo's name without ending; the first "
         "one there is called " +
         printable(choice.known.file.cameras.front().name);
}

Imported matched(const Project& project, const fs::path& place, Progress& progress) {
  progress.begin("matching with the photos", 1);
  try {
    const CameraChoice choice = match_cameras(project, place, progress);
    if (choice.matched < kFewestPhotos) return {{}, misfit_words(choice)};
    return {project_path(choice, project), match_words(choice.matched, choice.unmatched)};
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    return {{}, error.what()};
  }
}

void install(Workspace& workspace, const Imported& imported) {
  CalibrateStepState& state = workspace.calibrate;
  state.import = {};
  state.said.clear();
  if (imported.cameras.empty()) {
    state.said.push_back({Tone::bad, imported.words});
    return;
  }
  const bool again = imported.cameras == workspace.project().cameras;
  const bool done = done_or_told(state.said, [&] {
    if (again) return reread_files(workspace);
    edit(workspace, files_edit(workspace.project(), FileKind::cameras, imported.cameras));
  });
  if (again) state.known.place.clear();
  if (done) state.said.push_back({Tone::good, "Imported: " + imported.words + "."});
}

}  // namespace

void import_cameras(Workspace& workspace, const fs::path& place) {
  CalibrateStepState& state = workspace.calibrate;
  state.said.clear();
  if (workspace.project().photos.empty()) {
    state.said.push_back(
        {Tone::note, "Add the photos first (step Photos): cameras are matched with them."});
    return;
  }
  state.said.push_back({Tone::busy, "Matching " + printable(place.string()) + " with the photos."});
  state.import = {};
  state.import.id = workspace.jobs.start(
      "Importing cameras",
      [project = std::make_shared<const Project>(workspace.project()), place](Progress& progress) {
        return matched(*project, place, progress);
      },
      [&workspace, folder = workspace.project().folder](const Imported& imported) {
        const bool same = workspace.session && workspace.project().folder == folder;
        if (same) install(workspace, imported);
      },
      Lane::interactive, "camera-import");
}

void follow_import(Workspace& workspace) {
  CalibrateStepState& state = workspace.calibrate;
  if (!was_stopped(state.import, workspace.jobs)) return;
  state.said = {{Tone::note, "The import was stopped; the project's cameras are as they were."}};
}

}  // namespace bosk
