#include "ui/workstation/textures/textures_step.h"

#include <imgui.h>

#include <algorithm>

#include "core/package/container.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/options_panel.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kControlsEms = 19.0f;
constexpr double kMegabyte = 1e6;

// Brings the choices into the range of what there is.
void keep_choices(TexturesStepState& state, const Billboards& billboards) {
  const int levels = int(billboards.levels.size());
  if (state.level < 0 || state.level >= levels) state.level = chosen_level(billboards);
  const auto place = std::size_t(state.level);
  const BillboardLevel& level = billboards.levels[place];
  if (state.cell < 0 && place < state.rows.size()) state.cell = int(state.rows[place].fullest);
  state.cell = std::min(state.cell, int(level.cells.size()) - 1);
  state.view = std::clamp(state.view, 0, std::max(0, int(level.views.size()) - 1));
}

void draw_row(TexturesStepState& state, int place) {
  const LevelRow& row = state.rows[std::size_t(place)];
  const LevelStatistics& level = row.statistics;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string label = std::to_string(level.level);
  if (ImGui::Selectable(label.c_str(), state.level == place, ImGuiSelectableFlags_SpanAllColumns)) {
    state.level = place;
    state.cell = -1;
  }
  mark("textures/level_" + label);
  const auto column = [](const char* format, auto... values) {
    ImGui::TableNextColumn();
    ImGui::Text(format, values...);
  };
  column("%zu", level.cells);
  column("%zu", level.views);
  column("%zu", level.textures);
  column("%.0f %%", 100.0 * level.pruned_share());
  column("%.2f", double(level.raw_bytes) / kMegabyte);
  column("%.2f", double(level.index_bytes) / kMegabyte);
  ImGui::TableNextColumn();
  if (row.packed_bytes > 0) ImGui::Text("%.3f", double(row.packed_bytes) / kMegabyte);
}

void draw_table(TexturesStepState& state) {
  static constexpr const char* kHeads[] = {"level", "cells",  "views",      "textures",
                                           "clear", "raw MB", "indices MB", "packed MB"};
  if (!ImGui::BeginTable("levels", int(std::size(kHeads)),
                         ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
    return;
  }
  for (const char* head : kHeads) ImGui::TableSetupColumn(head);
  ImGui::TableHeadersRow();
  for (int i = 0; i < int(state.rows.size()); ++i) draw_row(state, i);
  ImGui::EndTable();
}

void draw_controls(Workspace& workspace) {
  const bool making = is_running(workspace, "texture");
  if (button("textures/run", "Bake textures", "makes billboards at every level from the volume",
             making ? "it is at work" : obstacle_to_stages(workspace))) {
    run_to(workspace, "texture");
  }
  ImGui::TextDisabled("Options apply to the next run.");
  draw_stage_options(workspace, "texture");
}

std::size_t bytes_of_level(const Container& container, std::size_t level) {
  std::size_t bytes = 0;
  for (const SectionEntry& section : container.sections) {
    const bool of_levels = section.type == kCellsSection || section.type == kLiveSection ||
                           section.type == kAlphaSection || section.type == kColourSection;
    if (of_levels && section.instance == level) bytes += section.length;
  }
  return bytes;
}

}  // namespace

int chosen_level(const Billboards& billboards) {
  for (int i = int(billboards.levels.size()) - 1; i >= 0; --i) {
    if (billboards.levels[std::size_t(i)].views.size() > 1) return i;
  }
  return int(billboards.levels.size()) - 1;
}

std::vector<LevelRow> level_rows(const Billboards& billboards,
                                 const std::vector<std::byte>* package) {
  std::vector<LevelRow> rows;
  for (const LevelStatistics& level : level_statistics(billboards)) {
    rows.push_back({level, fullest_cell(billboards.levels[rows.size()]), 0});
  }
  if (!package) return rows;
  const Container container = open_container(*package);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].packed_bytes = bytes_of_level(container, i);
  return rows;
}

std::shared_ptr<const CodedTextures> codebooks_of_shown(const Workspace& workspace) {
  if (!workspace.results.billboards || !is_made_from(workspace, "compress", "texture")) return {};
  return workspace.results.textures;
}

std::uint64_t textures_revision(const Workspace& workspace) {
  const auto part = [&](const char* stage) {
    const auto made = workspace.made.find(stage);
    return made == workspace.made.end() ? std::uint64_t(0) : made->second.low;
  };
  return part("texture") ^ (part("compress") * 3);
}

void follow_rows(Workspace& workspace) {
  TexturesStepState& state = workspace.textures;
  const auto billboards = workspace.results.billboards;
  if (!billboards) return;
  const bool packed = is_made_from(workspace, "pack", "texture");
  const auto package = packed ? workspace.results.package : nullptr;
  if (state.counted == billboards && state.counted_package == package) return;
  if (state.counted !=
      billboards) {  // rows of others would name levels and cells that are not here
    state.cell = -1;
    state.rows.clear();
  }
  state.counted = billboards;
  state.counted_package = package;
  workspace.jobs.start(
      "Counting textures", [=](Progress&) { return level_rows(*billboards, package.get()); },
      [&state, billboards, package](std::vector<LevelRow> rows) {
        const bool same = state.counted == billboards && state.counted_package == package;
        if (same) state.rows = std::move(rows);
      },
      Lane::interactive, "textures/rows");
}

void draw_textures_step(Workspace& workspace) {
  for (const char* stage : {"texture", "compress", "pack"}) load_if_stored(workspace, stage);
  follow_rows(workspace);
  if (workspace.results.billboards && !workspace.results.billboards->levels.empty()) {
    keep_choices(workspace.textures, *workspace.results.billboards);
  }
  const float em = ImGui::GetFontSize();
  ImGui::BeginChild("texture controls", {kControlsEms * em, 0});
  draw_controls(workspace);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("texture views", {0, 0}, false, ImGuiWindowFlags_NoScrollWithMouse);
  const auto& billboards = workspace.results.billboards;
  if (billboards && !billboards->levels.empty()) {
    draw_table(workspace.textures);
    draw_textures_views(workspace);
  } else {
    paragraph(Tone::muted, "No textures yet.");
  }
  ImGui::EndChild();
}

}  // namespace bosk
