#include "ui/workstation/volume/volume_step.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "ui/widgets/bars.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/options_panel.h"
#include "ui/workstation/stage_run.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kControlsEms = 19.0f, kChartsEms = 11.0f;

bool is_making(const Workspace& workspace) {
  return is_running(workspace, "radiance") || is_running(workspace, "opacity");
}

void show(VolumeStepState& state, std::shared_ptr<const VolumeLook> look) {
  state.look = std::move(look);
  ++state.look_revision;
  const int photos = int(state.look->cameras.size());
  state.photo = std::clamp(state.photo, 0, std::max(0, photos - 1));
}

// Takes over what the run at work has told.
void hear_run(VolumeStepState& state) {
  if (!state.watch) return;
  auto look = state.watch->looks.take();
  if (!look) return;
  state.stage = look->stage;
  state.passes[look->stage] = look->passes;
  state.looked_at.reset();  // the result, once there, is looked at anew
  show(state, std::move(look));
}

template <class Volume>
void look_at_result(Workspace& workspace, const std::shared_ptr<const Volume>& volume) {
  VolumeStepState& state = workspace.volume;
  const auto views = workspace.results.views;
  const auto mattes = workspace.results.mattes;
  if (!volume || !views || workspace.jobs.is_open(state.look_job)) return;
  if (state.looked_at == volume && state.looked_with == mattes) return;
  state.looked_at = volume;
  state.looked_with = mattes;
  state.look_job = workspace.jobs.start(
      "Looking at the volume", [=](Progress&) { return look_at(*volume, *views, mattes.get()); },
      [&state](VolumeLook look) {
        show(state, std::make_shared<const VolumeLook>(std::move(look)));
      },
      Lane::interactive, "volume/look");
}

void load_what_is_stored(Workspace& workspace) {
  for (const char* stage : {"view", "matte", "radiance", "opacity", "photo"}) {
    load_if_stored(workspace, stage);
  }
}

void draw_run_buttons(Workspace& workspace) {
  const std::string obstacle = obstacle_to_stages(workspace);
  const bool making = is_making(workspace);
  if (button("volume/run_opacity", "Make opacity",
             "finds where the tree is and how dense, from the mattes",
             making ? "it is at work" : obstacle)) {
    run_to(workspace, "opacity");
  }
  ImGui::SameLine();
  if (button("volume/run_radiance", "Refine with colour",
             "refines opacity and colour together until the volume looks like the photos; makes "
             "opacity first where it is missing",
             making ? "it is at work" : obstacle)) {
    run_to(workspace, "radiance");
  }
  VolumeStepState& state = workspace.volume;
  const bool stopping = state.watch && state.watch->stop_wanted;
  std::string reason = making ? "" : "nothing is at work";
  if (making && (!state.watch || state.watch->told == 0)) {
    reason = "it has not made a pass yet: there is nothing to keep";
  }
  if (making && stopping) reason = "it ends after this pass";
  if (button("volume/stop", "Stop and keep",
             "ends the stage at work after its present pass and keeps what it has; one undo and "
             "a run make the rest",
             reason)) {
    state.watch->stop_wanted = true;
  }
}

// Where a stage was stopped early, a way on to its end.
void draw_stopped(Workspace& workspace) {
  const Recipe& recipe = workspace.project().recipe;
  const std::pair<std::string, int> stops[] = {{"opacity", recipe.opacity.stop_after},
                                               {"radiance", recipe.radiance.stop_after}};
  for (const auto& [stage, pass] : stops) {
    if (pass == 0) continue;
    badge(Tone::note, title_of_stage(stage) + " ends after pass " + std::to_string(pass));
    ImGui::SameLine();
    if (button("volume/whole_" + stage, "All passes", "makes it whole in the next run")) {
      edit(workspace, option_edit(workspace.project(), stage + ".stop_after", "0"));
    }
  }
}

void draw_choice_of_result(Workspace& workspace) {
  VolumeStepState& state = workspace.volume;
  for (const char* stage : {"opacity", "radiance"}) {
    ImGui::BeginDisabled(!is_shown(workspace, stage) || is_making(workspace));
    const std::string label = title_of_stage(stage) + "##show";
    if (ImGui::RadioButton(label.c_str(), state.stage == stage)) state.stage = stage;
    ImGui::EndDisabled();
    mark(std::string("volume/show_") + stage, is_shown(workspace, stage));
    ImGui::SameLine();
  }
  ImGui::NewLine();
}

void draw_state_of_look(const VolumeLook& look) {
  if (look.pass > 0) {
    badge(Tone::busy, "Pass " + std::to_string(look.pass) + " of " + std::to_string(look.planned));
  }
  ImGui::TextDisabled("%zu cells", look.volume.cells);
}

void draw_controls(Workspace& workspace) {
  draw_run_buttons(workspace);
  draw_stopped(workspace);
  draw_choice_of_result(workspace);
  if (workspace.volume.look) draw_state_of_look(*workspace.volume.look);
  ImGui::TextDisabled("Options apply to the next run. All of them at once:");
  draw_preset_choice(workspace);
  for (const char* stage : {"opacity", "radiance"}) {
    const std::string title = title_of_stage(stage) + " options";
    const bool open = ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
    mark(std::string("volume/options_") + stage);
    if (open) draw_stage_options(workspace, stage);
  }
}

void draw_residuals(VolumeStepState& state, const ImVec2& area) {
  std::vector<Bar> bars;
  for (const PhotoResidual& residual : state.look->residuals) {
    bars.push_back({residual.name, residual.alpha_error});
  }
  const auto pressed = draw_bars("volume/residuals", bars, state.photo,
                                 "mean |opacity - matte|; press to see the photo", area);
  if (pressed) state.photo = *pressed;
}

void draw_convergence(const VolumeStepState& state, const ImVec2& area) {
  Plot plot;
  plot.x.label = "pass";
  plot.y.label = "|opacity - matte|";
  PlotLine error{"error", {}}, psnr{"PSNR", {}, true};
  const auto passes = state.passes.find(state.stage);
  if (passes != state.passes.end()) {
    for (const VolumePass& pass : passes->second) {
      error.points.emplace_back(pass.pass, pass.alpha_error);
      if (state.stage == "radiance") psnr.points.emplace_back(pass.pass, pass.psnr_db);
    }
  }
  plot.lines.push_back(error);
  if (!psnr.points.empty()) {
    plot.right = PlotAxis{"dB"};
    plot.lines.push_back(psnr);
  }
  if (error.points.empty()) {
    ImGui::BeginChild("no passes", area);
    paragraph(Tone::muted, "Drawn while the volume is made.");
    return ImGui::EndChild();
  }
  draw_plot("volume/convergence", plot, area);
}

void draw_charts(VolumeStepState& state) {
  const ImVec2 left = ImGui::GetContentRegionAvail();
  const float height = left.y - ImGui::GetTextLineHeightWithSpacing();
  ImGui::BeginGroup();
  ImGui::TextDisabled("Residual of each photo");
  draw_residuals(state, {0.48f * left.x, height});
  ImGui::EndGroup();
  ImGui::SameLine();
  ImGui::BeginGroup();
  ImGui::TextDisabled("Convergence over the passes of the newest run");
  draw_convergence(state, {0.48f * left.x, height});
  ImGui::EndGroup();
}

}  // namespace

void follow_volume(Workspace& workspace) {
  hear_run(workspace.volume);
  if (is_making(workspace)) return;
  load_what_is_stored(workspace);
  if (workspace.volume.stage == "radiance" && workspace.results.radiance) {
    look_at_result(workspace, workspace.results.radiance);
  } else {
    look_at_result(workspace, workspace.results.opacity);
  }
}

void draw_volume_step(Workspace& workspace) {
  follow_volume(workspace);
  const float em = ImGui::GetFontSize();
  ImGui::BeginChild("volume controls", {kControlsEms * em, 0});
  draw_controls(workspace);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("volume views", {0, 0}, false, ImGuiWindowFlags_NoScrollWithMouse);
  if (workspace.volume.look) {
    ImGui::BeginChild("volume pictures", {0, -kChartsEms * em}, false,
                      ImGuiWindowFlags_NoScrollWithMouse);
    draw_volume_views(workspace);
    ImGui::EndChild();
    draw_charts(workspace.volume);
  } else {
    paragraph(Tone::muted, "No volume yet. It grows here, pass by pass, while it is made.");
  }
  ImGui::EndChild();
}

}  // namespace bosk
