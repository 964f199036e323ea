#include "ui/workstation/export/export_step.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/base/number_text.h"
#include "core/base/system_error.h"
#include "core/photo/camera_files.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/options_panel.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

// What is there already of what would be written.
std::string replaced_text(const std::vector<fs::path>& files) {
  std::error_code none;
  std::vector<fs::path> there;
  for (const fs::path& file : files) {
    if (fs::exists(file, none)) there.push_back(file);
  }
  if (there.empty()) return {};
  const std::string first = printable(there.front().filename().string());
  if (files.size() == 1) {
    return "replaces " + first + ", " + size_text(fs::file_size(there.front(), none));
  }
  return "replaces " + std::to_string(there.size()) + " of " + std::to_string(files.size()) +
         " files, " + first + " first";
}

void draw_path(ExportStepState& state, const ExportItem& item) {
  std::string& path = state.paths[item.id];
  if (path.empty() && !ImGui::IsAnyItemActive()) path = item.usual;
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputText(("##" + item.id).c_str(), &path);
  mark("export/" + item.id + "/path");
  tooltip("where it goes; from the project's folder unless it begins with /");
}

std::string obstacle_to_writing(const Workspace& workspace, const ExportItem& item) {
  const ExportStepState& state = workspace.export_tree;
  if (!item.obstacle.empty()) return item.obstacle;
  if (state.paths.at(item.id).empty()) return "type where it should go";
  const auto job = state.jobs.find(item.id);
  if (job != state.jobs.end() && workspace.jobs.is_open(job->second)) return "it is being written";
  return {};
}

void draw_item(Workspace& workspace, const ExportItem& item) {
  ExportStepState& state = workspace.export_tree;
  ImGui::PushID(item.id.c_str());
  ImGui::TextUnformatted(item.title.c_str());
  ImGui::SameLine();
  ImGui::TextDisabled("%s", item.what.c_str());
  draw_path(state, item);
  const fs::path path = workspace.project().absolute(state.paths[item.id]);
  if (button("export/" + item.id + "/write", "Write", "writes it, in the background",
             obstacle_to_writing(workspace, item))) {
    state.told.erase(item.id);
    state.jobs[item.id] = item.start(path);
  }
  ImGui::SameLine();
  ImGui::TextUnformatted(item.size.c_str());
  const std::string replaced = state.paths[item.id].empty() ? "" : replaced_text(item.files(path));
  if (!replaced.empty()) {
    ImGui::SameLine();
    badge(Tone::note, replaced);
    mark("export/" + item.id + "/replaces");
  }
  const auto told = state.told.find(item.id);
  if (told != state.told.end()) {
    badge(Tone::good, told->second);
    mark("export/" + item.id + "/told");
  }
  ImGui::Separator();
  ImGui::PopID();
}

void draw_camera_format(ExportStepState& state) {
  ImGui::SetNextItemWidth(12.0f * ImGui::GetFontSize());
  if (ImGui::BeginCombo("format of the cameras", state.camera_format.c_str())) {
    for (const std::string& name : camera_format_names()) {
      if (!ImGui::Selectable(name.c_str(), name == state.camera_format)) continue;
      state.camera_format = name;
      state.paths.erase("cameras");
    }
    ImGui::EndCombo();
  }
  mark("export/format");
}

void draw_turntable_settings(ExportStepState& state) {
  ImGui::SetNextItemWidth(8.0f * ImGui::GetFontSize());
  if (ImGui::InputInt("pictures of the turntable", &state.turntable_frames)) {
    state.turntable_frames = std::clamp(state.turntable_frames, 1, 9999);
  }
  mark("export/frames");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(10.0f * ImGui::GetFontSize());
  if (ImGui::InputInt2("width and height, px", &state.turntable_px.x)) {
    state.turntable_px = glm::clamp(state.turntable_px, 1, 16384);
  }
  mark("export/turntable_px");
}

}  // namespace

void draw_export_step(Workspace& workspace) {
  draw_package_state(workspace);
  for (const char* stage : {"view", "matte"}) load_if_stored(workspace, stage);
  ImGui::BeginChild("export", {0, 0});
  ImGui::TextUnformatted("What the package says of itself");
  draw_stage_options(workspace, "pack", {"name", "licence", "credit"});
  ImGui::Separator();
  draw_item(workspace, package_item(workspace));
  draw_item(workspace, pictures_item(workspace));
  draw_turntable_settings(workspace.export_tree);
  draw_item(workspace, turntable_item(workspace));
  draw_item(workspace, report_item(workspace));
  draw_item(workspace, mattes_item(workspace));
  draw_camera_format(workspace.export_tree);
  draw_item(workspace, cameras_item(workspace));
  ImGui::EndChild();
}

}  // namespace bosk
