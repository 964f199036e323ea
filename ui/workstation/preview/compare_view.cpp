#include "ui/workstation/preview/compare_view.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/widgets/keys.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kListEms = 11.0f;

struct ModeText {
  CompareMode mode;
  const char *name, *label, *help;
};
constexpr std::array kModes = {
    ModeText{CompareMode::photo, "preview/photo", "Photo", "the photo alone; T changes sides"},
    ModeText{CompareMode::render, "preview/render", "Render", "the tree alone; T changes sides"},
    ModeText{CompareMode::wipe, "preview/wipe", "Wipe", "drag the line between the two"},
    ModeText{CompareMode::blend, "preview/blend", "Blend", "one over the other, by a slider"},
    ModeText{CompareMode::side_by_side, "preview/side", "Side by side", "the same part of both"},
    ModeText{CompareMode::difference, "preview/difference", "Difference",
             "what differs lights up, three times as strong; black is the same"}};

// Names of what can be compared, in order.
std::vector<ComparedView> views_to_compare(const Workspace& workspace) {
  std::vector<ComparedView> views;
  if (workspace.results.views) {
    for (const Photo& photo : *workspace.results.views) views.push_back({photo.name, false});
  }
  if (const auto& evaluation = workspace.preview.held_out.evaluation) {
    for (const NamedScore& view : evaluation->scores.views) views.push_back({view.name, true});
  }
  return views;
}

void draw_list(CompareState& state, const std::vector<ComparedView>& views) {
  bool held_out_begun = false;
  ImGui::TextDisabled("seen in training");
  for (const ComparedView& view : views) {
    if (view.held_out && !held_out_begun) ImGui::TextDisabled("held out");
    held_out_begun = view.held_out;
    const std::string name = (view.held_out ? "preview/held_out/" : "preview/view/") + view.name;
    if (ImGui::Selectable((view.name + "###" + name).c_str(), view == state.view)) {
      state.view = view;
    }
    mark(name);
  }
}

void hear_keys(const Workspace& workspace, CompareState& state,
               const std::vector<ComparedView>& views) {
  if (ImGui::GetIO().WantTextInput || ImGui::GetIO().KeyCtrl) return;
  if (workspace.input.pressed('T')) {
    state.mode = state.mode == CompareMode::photo ? CompareMode::render : CompareMode::photo;
  }
  const auto now = std::find(views.begin(), views.end(), state.view);
  if (now == views.end()) return;
  if (workspace.input.pressed(kKeyPageDown) && now + 1 != views.end()) state.view = *(now + 1);
  if (workspace.input.pressed(kKeyPageUp) && now != views.begin()) state.view = *(now - 1);
}

void draw_modes(CompareState& state) {
  for (const ModeText& text : kModes) {
    const bool chosen = state.mode == text.mode;
    if (chosen) {
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    }
    if (button(text.name, text.label, text.help)) state.mode = text.mode;
    if (chosen) ImGui::PopStyleColor();
    ImGui::SameLine();
  }
  ImGui::Checkbox("tree alone", &state.tree_alone);
  mark("preview/tree_alone");
  tooltip("shows the photo cut out by its matte, over white, as it is scored");
  if (state.mode != CompareMode::blend) return;
  ImGui::SetNextItemWidth(12.0f * ImGui::GetFontSize());
  ImGui::SliderFloat("share of the render", &state.blend, 0.0f, 1.0f, "%.2f");
  mark("preview/blend_share");
}

void draw_score(const CompareState& state, const Comparison& comparison) {
  badge(state.view.held_out ? Tone::good : Tone::note,
        state.view.held_out ? "held out" : "seen in training");
  ImGui::SameLine();
  if (!comparison.score) return ImGui::TextUnformatted("the photo's matte shows nothing");
  const ViewScore& score = *comparison.score;
  ImGui::Text("%s: PSNR %.2f dB, SSIM %.3f over white; inside the tree's box %.2f dB, %.3f",
              state.view.name.c_str(), score.psnr, score.ssim, score.crop_psnr, score.crop_ssim);
  tooltip(state.view.held_out
              ? "the package that was scored was made without this photo; in undistorted pixels"
              : "the package was made from this photo, so this says how well it is remembered, not "
                "how other views look: see Scores; in the pixels of the photo's own lens");
}

}  // namespace

void draw_compare(Workspace& workspace) {
  for (const char* stage : {"view", "matte", "photo"}) load_if_stored(workspace, stage);
  CompareState& state = workspace.preview.compare;
  const std::vector<ComparedView> views = views_to_compare(workspace);
  if (std::find(views.begin(), views.end(), state.view) == views.end()) {
    state.view = views.empty() ? ComparedView{} : views.front();
  }
  hear_keys(workspace, state, views);
  ImGui::BeginChild("views", {kListEms * ImGui::GetFontSize(), 0});
  draw_list(state, views);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("comparison", {0, 0}, false, ImGuiWindowFlags_NoScrollWithMouse);
  draw_modes(state);
  const KeptComparison* kept = state.view.name.empty() ? nullptr : follow_comparison(workspace);
  if (kept) {
    draw_score(state, *kept->comparison);
    draw_comparison(workspace, *kept);
  } else {
    paragraph("The tree is being drawn as this photo's camera sees it.");
  }
  ImGui::EndChild();
}

}  // namespace bosk
