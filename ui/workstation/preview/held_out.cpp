#include "ui/workstation/preview/held_out.h"

#include <imgui.h>

#include <algorithm>

#include "core/base/number_text.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

ContentHash package_key(const Workspace& workspace) {
  const auto wanted = workspace.wanted.find("pack");
  return wanted == workspace.wanted.end() ? ContentHash{} : wanted->second;
}

void draw_row(const std::string& name, const ViewScore& score) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name.c_str());
  for (const ScoreField& field : kScoreFields) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(number_text(score.*field.value, 3).c_str());
  }
}

void draw_table(Workspace& workspace, const Evaluation& evaluation) {
  const ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit;
  if (!ImGui::BeginTable("scores", 1 + int(kScoreFields.size()), flags)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("view");
  for (const ScoreField& field : kScoreFields) ImGui::TableSetupColumn(field.name);
  ImGui::TableHeadersRow();
  draw_row("mean", evaluation.scores.mean);
  draw_row("worst", evaluation.scores.worst);
  for (const NamedScore& view : evaluation.scores.views) {
    ImGui::TableNextColumn();
    if (button("preview/scores/" + view.name, view.name, "compare this photo with its render")) {
      workspace.preview.compare.view = {view.name, true};
      workspace.preview.tab = PreviewTab::compare;
    }
    for (const ScoreField& field : kScoreFields) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(number_text(view.score.*field.value, 3).c_str());
    }
  }
  ImGui::EndTable();
}

}  // namespace

bool is_held_out_current(const Workspace& workspace) {
  const HeldOutState& state = workspace.preview.held_out;
  return state.evaluation && state.of_package == package_key(workspace);
}

std::string obstacle_to_scoring(const Workspace& workspace) {
  const HeldOutState& state = workspace.preview.held_out;
  const std::string obstacle = obstacle_to_stages(workspace);
  if (!obstacle.empty()) return obstacle;
  if (workspace.jobs.is_open(state.job)) return "scoring is at work";
  const int photos = int(workspace.capture->photos.size());
  if (state.every > photos) {
    return "there are only " + std::to_string(photos) +
           " photos: choose a smaller number in Preview, Scores";
  }
  return {};
}

void start_held_out_scoring(Workspace& workspace) {
  if (!obstacle_to_scoring(workspace).empty()) return;
  HeldOutState& state = workspace.preview.held_out;
  const ContentHash key = package_key(workspace);
  state.job = workspace.jobs.start(
      "Scoring on held-out photos",
      [project = workspace.project(), capture = workspace.capture,
       every = state.every](Progress& progress) {
        const EvaluationSource source = evaluation_source(project, *capture, progress);
        return std::make_shared<const Evaluation>(evaluate_held_out(source, every, progress));
      },
      [&workspace, folder = workspace.project().folder,
       key](const std::shared_ptr<const Evaluation>& evaluation) {
        if (!workspace.session || workspace.project().folder != folder) return;
        workspace.preview.held_out.evaluation = evaluation;
        workspace.preview.held_out.of_package = key;
        workspace.seen_revision = 0;  // more is stored now
      });
}

void draw_held_out(Workspace& workspace) {
  HeldOutState& state = workspace.preview.held_out;
  paragraph(
      "How good is the tree from where no photo was taken? Every n-th photo is left out of all "
      "stages, a package is made of the rest, and is compared with what was left out. This takes "
      "as long as making the package.");
  ImGui::SetNextItemWidth(8.0f * ImGui::GetFontSize());
  if (ImGui::InputInt("every n-th photo", &state.every)) {
    state.every = std::clamp(state.every, 2, 1000);
  }
  mark("preview/every");
  ImGui::SameLine();
  if (button("preview/score", "Score on held-out photos",
             "makes a package without these photos and scores it on them",
             obstacle_to_scoring(workspace))) {
    start_held_out_scoring(workspace);
  }
  if (!state.evaluation) return;
  badge(is_held_out_current(workspace) ? Tone::good : Tone::note,
        is_held_out_current(workspace) ? "held out" : "out of date");
  ImGui::SameLine();
  ImGui::TextUnformatted(state.evaluation->title.c_str());
  paragraph(Tone::muted,
            "psnr and crop_psnr in dB; crop: inside the tree's box; alpha_mae: mean error of "
            "opacity; edge_ratio: below 1 is blur, above 1 noise; colour_error: CIEDE2000, about 1 "
            "is just visible.");
  draw_table(workspace, *state.evaluation);
}

}  // namespace bosk
