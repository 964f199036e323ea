#include "ui/workstation/named_paths.h"

#include "core/base/system_error.h"
#include "ui/workstation/calibrate/camera_import.h"
#include "ui/workstation/path_kinds.h"
#include "ui/workstation/photos/photo_edits.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

void open_named_project(Workspace& workspace, const fs::path& folder) {
  Notices told;
  if (folder == fs::absolute(workspace.project().folder).lexically_normal()) {
    told.push_back({Tone::neutral, "This project is open already."});
  } else if (done_or_told(told, [&] { open_project(workspace, folder); })) {
    told.push_back({Tone::good, "Opened " + printable(folder.filename().string()) + "."});
  }
  workspace.step = WorkStep::photos;
  workspace.photos.said = std::move(told);
}

constexpr std::size_t kFewestMattes = 2;  // a run needs two photos

// Mattes in a folder that was dropped on step Matte; none where it is anything else.
std::vector<fs::path> mattes_dropped(const Workspace& workspace,
                                     const std::vector<fs::path>& named) {
  if (workspace.step != WorkStep::matte || named.size() != 1) return {};
  std::vector<fs::path> photos = workspace.project().photos;
  for (fs::path& photo : photos) photo = workspace.project().absolute(photo);
  return mattes_for(photos, named.front());
}

}  // namespace

void take_paths(Workspace& workspace, const std::vector<fs::path>& named) {
  const std::vector<fs::path> mattes = mattes_dropped(workspace, named);
  if (mattes.size() >= kFewestMattes) return take_mattes(workspace, mattes);
  const NamedPaths paths = sorted_out(named);
  if (!paths.project.empty()) return open_named_project(workspace, paths.project);
  workspace.photos.said.clear();
  const bool only_cameras = !paths.cameras.empty() && paths.photos.empty();
  workspace.step = only_cameras ? WorkStep::calibrate : WorkStep::photos;
  if (!paths.photos.empty()) add_photos(workspace, paths.photos);
  if (!paths.cameras.empty()) import_cameras(workspace, paths.cameras);
  Notices& told = only_cameras ? workspace.calibrate.said : workspace.photos.said;
  if (!paths.cameras.empty() && !only_cameras) {
    told.push_back({Tone::neutral, "The cameras in " +
                                       printable(paths.cameras.filename().string()) +
                                       " went to step Calibrate."});
  }
  for (const std::string& sentence : paths.left_out) told.push_back({Tone::note, sentence});
}

void hear_drops(Workspace& workspace) {
  if (!workspace.session || workspace.input.dropped.empty()) return;
  take_paths(workspace, workspace.input.dropped);
  workspace.input.dropped.clear();
}

}  // namespace bosk
