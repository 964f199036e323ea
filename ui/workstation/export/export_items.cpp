// What can be written, and the jobs that write it.

#include "core/base/number_text.h"
#include "core/base/system_error.h"
#include "core/package/reader.h"
#include "core/project/export.h"
#include "core/project/report.h"
#include "core/render/picture_files.h"
#include "core/render/reference.h"
#include "ui/scene_painter.h"
#include "ui/workstation/export/export_step.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

std::string about(std::size_t bytes) { return "about " + size_text(bytes) + ", estimated"; }

std::string obstacle_without_package(const Workspace& workspace) {
  if (!workspace.results.package || !is_shown(workspace, "pack")) return "make the package first";
  if (state_of(workspace, "pack") == StageState::current) return {};
  return "the package is out of date: make it again first";
}

std::string obstacle_without(const Workspace& workspace, const std::string& stage) {
  if (state_of(workspace, stage) == StageState::current) return {};
  return "make the " + std::string(stage == "matte" ? "mattes" : "package") + " first";
}

const Photos& views_of(const Workspace& workspace) {
  static const Photos kNone;
  return workspace.results.views ? *workspace.results.views : kNone;
}

ExportItem item_of(const std::string& id, const std::string& title, const std::string& what) {
  ExportItem item;
  item.id = id;
  item.title = title;
  item.what = what;
  return item;
}

// FOLDER/NAME.png for each photo.
std::vector<fs::path> pictures_in(const Workspace& workspace, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const Photo& view : views_of(workspace)) files.push_back(folder / (view.name + ".png"));
  return files;
}

// Starts `work(Progress&) -> what was written` and tells it under the item.
template <class Work>
int start(Workspace& workspace, const std::string& title, const std::string& id, Work work) {
  return workspace.jobs.start(
      title, std::move(work),
      [&workspace, id, folder = workspace.project().folder](const std::string& told) {
        const bool same = workspace.session && workspace.project().folder == folder;
        if (same) workspace.export_tree.told[id] = told;
      });
}

const Coverage& coverage(Workspace& workspace) {
  ExportStepState& state = workspace.export_tree;
  if (state.mattes != workspace.results.mattes) {
    state.mattes = workspace.results.mattes;
    state.coverage = state.mattes ? coverage_of(*state.mattes) : Coverage{};
  }
  return state.coverage;
}

std::vector<Camera> cameras_of(const Photos& views) {
  std::vector<Camera> cameras;
  for (const Photo& view : views) {
    cameras.push_back(view.original_camera);
    cameras.back().name = view.name;
  }
  return cameras;
}

std::string turntable_told(const TurntableFiles& files, const fs::path& folder) {
  return "written: " + printable(folder.string()) + ", " + std::to_string(files.pictures.size()) +
         " pictures" + (files.video ? " and turntable.mp4" : "; " + files.no_video);
}

std::vector<fs::path> camera_files(const Workspace& workspace, const fs::path& path) {
  const std::string& format = workspace.export_tree.camera_format;
  const bool text = format == "colmap";
  if (text || format == "colmap-binary") {
    const std::string ending = text ? ".txt" : ".bin";
    return {path / ("cameras" + ending), path / ("images" + ending), path / ("points3D" + ending)};
  }
  if (format == "transforms") {
    return {path.extension() == ".json" ? path : path / "transforms.json"};
  }
  if (path.extension() == ".cameramodel") return {path};
  std::vector<fs::path> files;
  for (const Photo& view : views_of(workspace)) {
    files.push_back(path / (view.name + ".cameramodel"));
  }
  return files;
}

}  // namespace

ExportItem package_item(Workspace& workspace) {
  ExportItem item =
      item_of("package", "Package", "what games and viewers draw: the same bytes as `bosk run`");
  const auto& package = workspace.results.package;
  item.usual = usual_package_path(workspace.project()).filename().string();
  item.obstacle = obstacle_without_package(workspace);
  item.size = item.obstacle.empty()
                  ? size_text(package->size()) + ", " + std::to_string(package->size()) + " bytes"
                  : "";
  item.files = [](const fs::path& path) { return std::vector<fs::path>{path}; };
  item.start = [&workspace, package](const fs::path& path) {
    return start(workspace, "Writing the package", "package", [package, path](Progress& progress) {
      progress.begin("writing", 1);
      const bool written = write_package_file(path, *package);
      return written ? "written: " + printable(path.string()) + ", " + size_text(package->size())
                     : printable(path.string()) + " holds just this package already";
    });
  };
  return item;
}

ExportItem pictures_item(Workspace& workspace) {
  ExportItem item =
      item_of("pictures", "Pictures",
              "the tree as each photo's camera sees it: RGBA PNGs in its lens and size");
  item.usual = "pictures";
  item.obstacle = obstacle_without_package(workspace);
  if (item.obstacle.empty()) item.obstacle = obstacle_without(workspace, "view");
  item.size = about(estimated_rgba_bytes(views_of(workspace), coverage(workspace)));
  item.files = [&workspace](const fs::path& path) { return pictures_in(workspace, path); };
  item.start = [&workspace](const fs::path& path) {
    return start(
        workspace, "Drawing pictures", "pictures",
        [package = workspace.results.package, name = workspace.project().name(),
         cameras = cameras_of(views_of(workspace)), path](Progress& progress) {
          const TreeModel model = read_tree(*package, name);
          const PreparedTree tree(model);
          const auto files = write_pictures(
              cameras,
              [&](const Camera& camera) { return render_tree(tree, camera, {}, progress); }, path,
              progress);
          return "written: " + printable(path.string()) + ", " + std::to_string(files.size()) +
                 " pictures";
        });
  };
  return item;
}

ExportItem turntable_item(Workspace& workspace) {
  const ExportStepState& state = workspace.export_tree;
  ExportItem item =
      item_of("turntable", "Turntable",
              "pictures once round what the step Preview shows, and a video where ffmpeg is");
  item.usual = "turntable";
  item.obstacle = obstacle_without_package(workspace);
  item.size = about(estimated_turntable_bytes(state.turntable_frames, state.turntable_px));
  item.files = [](const fs::path& path) {
    return std::vector<fs::path>{path / "frame-0000.png", path / "turntable.mp4"};
  };
  item.start = [&workspace](const fs::path& path) {
    return start(
        workspace, "Turntable", "turntable",
        [package = workspace.results.package, name = workspace.project().name(),
         look = workspace.preview.live.look, forest = workspace.preview.live.forest,
         camera = workspace.preview.live.camera, framed = workspace.preview.live.framed,
         frames = workspace.export_tree.turntable_frames,
         size_px = workspace.export_tree.turntable_px, path](Progress& progress) {
          const SceneTrees trees = {
              std::make_shared<const SceneTree>(name, read_tree(*package, name))};
          const ForestScene scene =
              scene_on(terrain_of(forest), trees, places_of(trees, {}, forest));
          ScenePainter painter(scene, look, size_px);
          const ViewCamera begin = framed ? camera : framing(scene, size_px, view_angle(look));
          return turntable_told(write_turntable(painter, path, frames, begin, progress), path);
        });
  };
  return item;
}

ExportItem report_item(Workspace& workspace) {
  const HeldOutState& held_out = workspace.preview.held_out;
  ExportItem item = item_of(
      "report", "Report", "scores on held-out photos, pictures, levels, times and settings: HTML");
  const bool scored = is_held_out_current(workspace);
  if (!scored) {
    item.what += "; first scores every " + std::to_string(held_out.every) +
                 "th photo, which takes as long as making the package";
  }
  item.usual = "report";
  item.obstacle = scored ? obstacle_to_stages(workspace) : obstacle_to_scoring(workspace);
  const std::size_t photos = workspace.capture ? workspace.capture->photos.size() : 0;
  item.size =
      about(estimated_report_bytes(views_of(workspace), photos / std::size_t(held_out.every)));
  item.files = [](const fs::path& path) {
    return std::vector<fs::path>{path / "report.html", path / "contact-sheet.png",
                                 path / "figures.txt", path / "figures.json"};
  };
  item.start = [&workspace, scored](const fs::path& path) {
    const HeldOutState& state = workspace.preview.held_out;
    return start(workspace, "Report", "report",
                 [evaluation = scored ? state.evaluation : nullptr, project = workspace.project(),
                  capture = workspace.capture, every = state.every, path](Progress& progress) {
                   if (evaluation) {
                     write_report(path, *evaluation, project);
                   } else {
                     const auto source = evaluation_source(project, *capture, progress);
                     write_report(path, evaluate_held_out(source, every, progress), project);
                   }
                   return "written: " + printable((path / "report.html").string());
                 });
  };
  return item;
}

ExportItem mattes_item(Workspace& workspace) {
  ExportItem item =
      item_of("mattes", "Mattes", "RGBA PNGs with straight alpha, in the photos' own pixels");
  item.usual = "mattes";
  item.obstacle = obstacle_without(workspace, "matte");
  if (item.obstacle.empty()) item.obstacle = obstacle_without(workspace, "view");
  item.size = about(estimated_rgba_bytes(views_of(workspace), coverage(workspace)));
  item.files = [&workspace](const fs::path& path) { return pictures_in(workspace, path); };
  item.start = [&workspace](const fs::path& path) {
    return start(workspace, "Writing mattes", "mattes",
                 [views = workspace.results.views, mattes = workspace.results.mattes,
                  path](Progress& progress) {
                   const std::size_t count = export_mattes(*views, *mattes, path, progress);
                   return "written: " + printable(path.string()) + ", " + std::to_string(count) +
                          " mattes";
                 });
  };
  return item;
}

ExportItem cameras_item(Workspace& workspace) {
  const std::string& format = workspace.export_tree.camera_format;
  ExportItem item =
      item_of("cameras", "Cameras", "of the photos, in their own lenses, for other programs");
  item.usual = "cameras-" + format;
  item.obstacle = obstacle_without(workspace, "view");
  item.size = about(estimated_camera_bytes(views_of(workspace).size()));
  item.files = [&workspace](const fs::path& path) { return camera_files(workspace, path); };
  item.start = [&workspace, format](const fs::path& path) {
    return start(workspace, "Writing cameras", "cameras",
                 [views = workspace.results.views, capture = workspace.capture, format,
                  path](Progress& progress) {
                   progress.begin("writing", 1);
                   const std::size_t count = export_cameras(*views, *capture, format, path);
                   return "written: " + printable(path.string()) + ", " + std::to_string(count) +
                          " cameras";
                 });
  };
  return item;
}

}  // namespace bosk
