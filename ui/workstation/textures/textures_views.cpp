#include <imgui.h>

#include <algorithm>

#include "core/compress/texture_sheets.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/textures/textures_step.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr int kSheetAcross = 32, kSheetCells = 32 * 24, kCellAcross = 4;

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
      draw_sheet_view("textures/sheet", state.sheet_view, texture, size_px, area);
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
  draw_sheet_view("textures/baked", state.cell_view, baked, size_px, part);
  if (!coded) return;
  ImGui::SameLine();
  const Texture decoded = workspace.pictures.show("textures/coded/" + place, revision, [&] {
    return coded_cell_textures(billboards, *coded, coded->atlas_rgba, level, cell, kCellAcross)
        .picture;
  });
  draw_sheet_view("textures/coded", state.cell_view, decoded, size_px, part);
}

}  // namespace

ImagePlace draw_sheet_view(const std::string& name, ImageView& view, const Texture& texture,
                           const glm::dvec2& size_px, const ImVec2& area) {
  const ImVec2 least = ImGui::GetCursorScreenPos();
  const ImVec2 most(least.x + area.x, least.y + area.y);
  const ImagePlace place = place_of(view, size_px, least, most);
  const glm::dvec2 from = place.screen_from_picture(glm::dvec2(-1.5));
  const glm::dvec2 to = place.screen_from_picture(size_px + 0.5);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(least, most, true);
  draw.AddRectFilled({float(from.x), float(from.y)}, {float(to.x), float(to.y)},
                     ImGui::GetColorU32(ImVec4(0.86f, 0.88f, 0.9f, 1.0f)));
  draw.PopClipRect();
  return draw_image_view(name, view, texture, size_px, area);
}

void draw_textures_views(Workspace& workspace) {
  TexturesStepState& state = workspace.textures;
  const auto& levels = workspace.results.billboards->levels;
  const BillboardLevel& level = levels[std::size_t(state.level)];
  draw_cell_choice(state, level);
  const bool there = state.cell >= 0 && std::size_t(state.cell) < level.cells.size() &&
                     std::size_t(state.view) < level.views.size();
  if (!there) return;  // of an empty level there is nothing to see
  ImGui::TextDisabled(codebooks_of_shown(workspace)
                          ? "All cells from one view: press one.   Its views: original | compressed"
                          : "All cells from one view: press one.   Its views");
  const ImVec2 left = ImGui::GetContentRegionAvail();
  const ImVec2 half(std::max(2.0f, 0.45f * left.x), std::max(1.0f, left.y));
  draw_sheet(workspace, half);
  ImGui::SameLine();
  draw_cell(workspace, {std::max(2.0f, 0.52f * left.x), half.y});
}

}  // namespace bosk
