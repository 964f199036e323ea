#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/matte/matte.h"
#include "ui/workstation/export/export_sizes.h"

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct ExportStepState {
  std::map<std::string, std::string> paths;  // as typed, by item; relative to the project
  std::map<std::string, std::string> told;   // what was written last, by item
  std::map<std::string, int> jobs;           // at work on it, by item
  std::string camera_format = "colmap";
  int turntable_frames = 72;
  glm::ivec2 turntable_px{1280, 800};
  std::shared_ptr<const Mattes> mattes;  // that `coverage` was taken of
  Coverage coverage;
};

// One thing that can be written.
struct ExportItem {
  std::string id;        // of its landmarks, "export/ID/..."
  std::string title;     // "Package"
  std::string what;      // one line
  std::string usual;     // path unless another is typed
  std::string size;      // "2.31 MiB", or "about 12 MiB, estimated"
  std::string obstacle;  // why it can't be written now; empty: it can
  // Files that would be written to this path, to say which are replaced; may be incomplete.
  std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)> files;
  // Starts a job that writes to this path; gives its id.
  std::function<int(const std::filesystem::path&)> start;
};

void draw_export_step(Workspace& workspace);

// Each in export_items.cpp, as the workspace stands now.
ExportItem package_item(Workspace& workspace);
ExportItem pictures_item(Workspace& workspace);
ExportItem turntable_item(Workspace& workspace);
ExportItem report_item(Workspace& workspace);
ExportItem mattes_item(Workspace& workspace);
ExportItem cameras_item(Workspace& workspace);

}  // namespace bosk
