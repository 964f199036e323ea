#include "ui/workstation/textures_step.h"

#include <imgui.h>

#include <algorithm>

#include "core/compress/texture_sheets.h"
#include "core/package/container.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/options_panel.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kControlsEms = 19.0f;
constexpr int kSheetAcross = 32, kSheetCells = 32 * 24, kCellAcross = 4;
constexpr double kMegabyte = 1e6;

void follow_textures(Workspace& workspace) {
  TexturesStepState& state = workspace.textures;
  for (const char* stage : {"texture", "compress", "pack"}) load_if_stored(workspace, stage);
  const auto billboards = workspace.results.billboards;
  if (!billboards) return;
  const int levels = int(billboards->levels.size());
  if (state.level < 0 || state.level >= levels) state.level = chosen_level(*billboards);
  const BillboardLevel& level = billboards->levels[std::size_t(state.level)];
  state.cell = std::clamp(state.cell, 0, std::max(0, int(level.cells.size()) - 1));
  state.view = std::clamp(state.view, 0, std::max(0, int(level.views.size()) - 1));
  const bool packed = is_made_from(workspace, "pack", "texture");
  const auto package = packed ? workspace.results.package : nullptr;
  if (workspace.jobs.is_open(state.rows_job)) return;
  if (state.counted == billboards && state.counted_package == package) return;
  state.counted = billboards;
  state.counted_package = package;
  state.rows_job = workspace.jobs.start(
      "Counting textures", [=](Progress&) { return level_rows(*billboards, package.get()); },
      [&state](std::vector<LevelRow> rows) { state.rows = std::move(rows); }, Lane::interactive,
      "textures/rows");
}

void draw_row(TexturesStepState& state, int place) {
  const LevelRow& row = state.rows[std::size_t(place)];
  const LevelStatistics& level = row.statistics;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string label = std::to_string(level.level);
  if (ImGui::Selectable(label.c_str(), state.level == place, ImGuiSelectableFlags_SpanAllColumns)) {
    state.level = place;
    state.cell = 0;
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
             making ? "it is at work" : obstacle_to(workspace, "texture"))) {
    run_to(workspace, "texture");
  }
  ImGui::TextDisabled("Options apply to the next run.");
  draw_stage_options(workspace, "texture");
}

void draw_cell_choice(TexturesStepState& state, const BillboardLevel& level) {
  const float wide = 0.25f * ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(wide);
  ImGui::SliderInt("cell", &state.cell, 0, std::max(0, int(level.cells.size()) - 1), "%d",
                   ImGuiSliderFlags_AlwaysClamp);
  mark("textures/cell");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(wide);
  ImGui::SliderInt("view of the sheet", &state.view, 0, std::max(0, int(level.views.size()) - 1),
                   "%d", ImGuiSliderFlags_AlwaysClamp);
  mark("textures/view");
}

// The first cell of the page of the sheet that holds the chosen one.
int page_of(const TexturesStepState& state) { return state.cell / kSheetCells * kSheetCells; }

// A page of the level's cells from one view; pressing one chooses it.
void draw_sheet(Workspace& workspace, const ImVec2& area) {
  TexturesStepState& state = workspace.textures;
  const Billboards& billboards = *workspace.results.billboards;
  const int first = page_of(state);
  const auto sheet = [&] {
    return view_textures(billboards, std::size_t(state.level), std::size_t(state.view),
                         std::size_t(first), kSheetCells, kSheetAcross);
  };
  const std::string name = "textures/sheet/" + std::to_string(state.level) + "/" +
                           std::to_string(state.view) + "/" + std::to_string(first);
  const Texture texture =
      workspace.pictures.show(name, textures_revision(workspace), [&] { return sheet().picture; });
  const glm::dvec2 size_px(texture.size_px);
  const ImagePlace place =
      draw_image_view("textures/sheet", state.sheet_view, texture, size_px, area);
  const int step = billboards.levels[std::size_t(state.level)].texels + 1;
  const auto corner = [&](int number) {
    return glm::dvec2(number % kSheetAcross, number / kSheetAcross) * double(step) - 1.0;
  };
  const glm::dvec2 least = place.screen_from_picture(corner(state.cell - first));
  const double edge = double(step + 1) * place.scale;
  ImGui::GetWindowDrawList()->AddRect({float(least.x), float(least.y)},
                                      {float(least.x + edge), float(least.y + edge)},
                                      colour_u32(Tone::note), 0.0f, 0, 2.0f);
  if (!place.hovered || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
  const glm::ivec2 tile(glm::floor((place.mouse_px() + 0.5) / double(step)));
  const auto cells = int(billboards.levels[std::size_t(state.level)].cells.size());
  const int cell = first + tile.y * kSheetAcross + tile.x;
  const bool on_sheet = tile.x >= 0 && tile.x < kSheetAcross && tile.y >= 0 && cell >= first;
  if (on_sheet && cell < cells) state.cell = cell;
}

// The chosen cell from every view: as baked, and as the codebooks give it.
void draw_cell(Workspace& workspace, const ImVec2& area) {
  TexturesStepState& state = workspace.textures;
  const Billboards& billboards = *workspace.results.billboards;
  const auto level = std::size_t(state.level), cell = std::size_t(state.cell);
  const std::string place = std::to_string(state.level) + "/" + std::to_string(state.cell);
  const std::uint64_t revision = textures_revision(workspace);
  const Texture baked = workspace.pictures.show("textures/baked/" + place, revision, [&] {
    return cell_textures(billboards, level, cell, kCellAcross).picture;
  });
  const glm::dvec2 size_px(baked.size_px);
  const auto coded = codebooks_of_shown(workspace);
  const ImVec2 part(coded ? 0.49f * area.x : area.x, area.y);
  draw_image_view("textures/baked", state.cell_view, baked, size_px, part);
  if (!coded) return;
  ImGui::SameLine();
  const Texture decoded = workspace.pictures.show("textures/coded/" + place, revision, [&] {
    return coded_cell_textures(billboards, *coded, coded->atlas_rgba, level, cell, kCellAcross)
        .picture;
  });
  draw_image_view("textures/coded", state.cell_view, decoded, size_px, part);
}

void draw_pictures(Workspace& workspace) {
  TexturesStepState& state = workspace.textures;
  const auto& levels = workspace.results.billboards->levels;
  draw_cell_choice(state, levels[std::size_t(state.level)]);
  if (levels[std::size_t(state.level)].cells.empty()) return;
  ImGui::TextDisabled(codebooks_of_shown(workspace)
                          ? "All cells from one view: press one.   Its views: original | compressed"
                          : "All cells from one view: press one.   Its views");
  const ImVec2 left = ImGui::GetContentRegionAvail();
  const ImVec2 half(std::max(2.0f, 0.45f * left.x), std::max(1.0f, left.y));
  draw_sheet(workspace, half);
  ImGui::SameLine();
  draw_cell(workspace, {std::max(2.0f, 0.52f * left.x), half.y});
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
  for (const LevelStatistics& level : level_statistics(billboards)) rows.push_back({level, 0});
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

void draw_textures_step(Workspace& workspace) {
  follow_textures(workspace);
  const float em = ImGui::GetFontSize();
  ImGui::BeginChild("texture controls", {kControlsEms * em, 0});
  draw_controls(workspace);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("texture views", {0, 0}, false, ImGuiWindowFlags_NoScrollWithMouse);
  const auto& billboards = workspace.results.billboards;
  if (billboards && !billboards->levels.empty()) {
    draw_table(workspace.textures);
    draw_pictures(workspace);
  } else {
    paragraph(Tone::muted, "No textures yet.");
  }
  ImGui::EndChild();
}

}  // namespace bosk
