#include <imgui.h>

#include <algorithm>

#include "core/compress/atlas.h"
#include "core/compress/texture_sheets.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/codebook/codebook_step.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr int kCodewordsAcross = 32, kCellsAcross = 16, kCells = 16 * 16;

// The codewords in use for pictures: exact, or as the GPU sees them.
const std::vector<glm::u8vec4>& atlas_shown(CodebookStepState& state,
                                            const std::shared_ptr<const CodedTextures>& coded) {
  if (!state.as_gpu) return coded->atlas_rgba;
  if (state.bc3_of != coded) {
    state.bc3_of = coded;
    state.bc3_atlas = std::make_shared<const std::vector<glm::u8vec4>>(atlas_from_bc3(*coded));
  }
  return *state.bc3_atlas;
}

std::uint64_t revision_of(const Workspace& workspace) {
  const std::uint64_t both = textures_revision(workspace);
  return workspace.codebook.as_gpu ? ~both : both;
}

void draw_choices(CodebookStepState& state, const Billboards& billboards) {
  const BillboardLevel& level = billboards.levels[std::size_t(state.level)];
  const float wide = 0.2f * ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(wide);
  const std::string name = "level " + std::to_string(level.level);
  ImGui::SliderInt("##level", &state.level, 0, int(billboards.levels.size()) - 1, name.c_str(),
                   ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  mark("codebook/level");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(wide);
  const int last = int(billboards.levels[std::size_t(state.level)].views.size()) - 1;
  state.view = std::clamp(state.view, 0, std::max(0, last));
  ImGui::SliderInt("##view", &state.view, 0, std::max(0, last), "view %d",
                   ImGuiSliderFlags_AlwaysClamp);
  mark("codebook/view");
  ImGui::SameLine();
  ImGui::Checkbox("as the GPU sees it (BC3)", &state.as_gpu);
  mark("codebook/as_gpu");
}

// A level's codewords, many side by side.
void draw_codewords(Workspace& workspace, const CodedTextures& coded, const ImVec2& area) {
  CodebookStepState& state = workspace.codebook;
  const auto level = std::size_t(state.level);
  const std::string kind = state.of_colours ? "colours/" : "alphas/";
  const Texture texture = workspace.pictures.show(
      "codebook/" + kind + std::to_string(level), textures_revision(workspace), [&] {
        return (state.of_colours ? colour_codewords(coded, level, kCodewordsAcross)
                                 : alpha_codewords(coded, level, kCodewordsAcross))
            .picture;
      });
  draw_image_view("codebook/codewords", state.codewords_view, texture, glm::dvec2(texture.size_px),
                  area);
}

// Cells around the level's fullest, from one view: as baked, and as the codebooks give them.
void draw_textures(Workspace& workspace, const std::shared_ptr<const CodedTextures>& coded,
                   const ImVec2& area) {
  CodebookStepState& state = workspace.codebook;
  const Billboards& billboards = *workspace.results.billboards;
  const auto level = std::size_t(state.level), view = std::size_t(state.view);
  const auto& rows = workspace.textures.rows;
  const std::size_t first = level < rows.size() ? rows[level].fullest / kCells * kCells : 0;
  const std::string place =
      std::to_string(level) + "/" + std::to_string(view) + "/" + std::to_string(first);
  const Texture baked = workspace.pictures.show(
      "codebook/baked/" + place, textures_revision(workspace),
      [&] { return view_textures(billboards, level, view, first, kCells, kCellsAcross).picture; });
  const glm::dvec2 size_px(baked.size_px);
  const ImVec2 half(std::max(1.0f, 0.49f * area.x), area.y);
  draw_sheet_view("codebook/baked", state.textures_view, baked, size_px, half);
  ImGui::SameLine();
  const Texture decoded =
      workspace.pictures.show("codebook/coded/" + place, revision_of(workspace), [&] {
        return coded_view_textures(billboards, *coded, atlas_shown(state, coded), level, view,
                                   first, kCells, kCellsAcross)
            .picture;
      });
  draw_sheet_view("codebook/coded", state.textures_view, decoded, size_px, half);
}

}  // namespace

void draw_codebook_views(Workspace& workspace) {
  CodebookStepState& state = workspace.codebook;
  const auto coded = codebooks_of_shown(workspace);
  const auto& billboards = workspace.results.billboards;
  if (!coded || !billboards || billboards->levels.empty()) {
    paragraph(Tone::muted, "No codebooks of these textures yet.");
    return;
  }
  const int levels = int(billboards->levels.size());
  if (state.level < 0 || state.level >= levels) state.level = chosen_level(*billboards);
  draw_choices(state, *billboards);
  ImGui::TextDisabled("Codewords.   Textures: original | compressed");
  const ImVec2 left = ImGui::GetContentRegionAvail();
  const float height = std::max(1.0f, left.y);
  draw_codewords(workspace, *coded, {std::max(1.0f, 0.32f * left.x), height});
  ImGui::SameLine();
  draw_textures(workspace, coded, {std::max(2.0f, 0.66f * left.x), height});
}

}  // namespace bosk
