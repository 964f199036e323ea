#include "ui/workstation/codebook/codebook_step.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/plot.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/options_panel.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kControlsEms = 19.0f, kPlotEms = 16.0f;
constexpr double kMegabyte = 1e6;
constexpr int kFewest = 1, kMost = 4096;

const char* option_of(const CodebookStepState& state) {
  return state.of_colours ? "compress.colour_codewords" : "compress.alpha_codewords";
}

void start_curve(Workspace& workspace) {
  CodebookStepState& state = workspace.codebook;
  const auto billboards = workspace.results.billboards;
  state.curve.reset();
  state.curve_of = billboards;
  state.growing = std::make_shared<Mailbox<std::vector<CodebookPoint>>>();
  state.curve_job = workspace.jobs.start(
      "Curve over codewords",
      [billboards, options = workspace.project().recipe.compress, growing = state.growing,
       jobs = &workspace.jobs](Progress& progress) {
        std::vector<CodebookPoint> points;
        return codebook_curve(*billboards, options, usual_codeword_counts(), progress,
                              [&](const CodebookPoint& point) {
                                points.push_back(point);
                                growing->put(points);
                                jobs->wake();
                              });
      },
      [&state](std::vector<CodebookPoint> curve) {
        state.curve = std::make_shared<const std::vector<CodebookPoint>>(std::move(curve));
      });
}

void follow_codebook(Workspace& workspace) {
  CodebookStepState& state = workspace.codebook;
  for (const char* stage : {"texture", "compress"}) load_if_stored(workspace, stage);
  follow_rows(workspace);
  if (!state.growing) return;
  if (auto curve = state.growing->take()) state.curve = std::move(curve);
}

void draw_buttons(Workspace& workspace) {
  const CodebookStepState& state = workspace.codebook;
  const bool making = is_running(workspace, "compress");
  if (button("codebook/run", "Train codebooks", "finds the patterns that stand for all textures",
             making ? "it is at work" : obstacle_to_stages(workspace))) {
    run_to(workspace, "compress");
  }
  std::string obstacle = workspace.results.billboards ? "" : "bake the textures first";
  if (workspace.jobs.is_open(state.curve_job)) obstacle = "it is at work";
  if (button("codebook/curve", "Measure the curve",
             "quality and size for 16 to 4096 codewords, from a sample of the tree; some seconds",
             obstacle)) {
    start_curve(workspace);
  }
}

void draw_choice_of_codebook(CodebookStepState& state) {
  if (ImGui::RadioButton("colours", state.of_colours)) state.of_colours = true;
  mark("codebook/colours");
  ImGui::SameLine();
  if (ImGui::RadioButton("opacities", !state.of_colours)) state.of_colours = false;
  mark("codebook/opacities");
}

// What the present choice of both numbers is expected to give.
void draw_expectation(const Workspace& workspace) {
  const CodebookStepState& state = workspace.codebook;
  if (!state.curve || state.curve->empty()) return;
  CompressOptions options = workspace.project().recipe.compress;
  if (state.codewords_held) {
    (state.of_colours ? options.colour_codewords : options.alpha_codewords) = *state.codewords_held;
  }
  const CodebookPoint colour = at_codewords(*state.curve, options.colour_codewords);
  const CodebookPoint alpha = at_codewords(*state.curve, options.alpha_codewords);
  const double bytes = double(colour.colour_bytes + alpha.alpha_bytes + colour.other_bytes);
  ImGui::Text("%d colours: about %.1f dB", options.colour_codewords, colour.colour_psnr_db);
  ImGui::Text("%d opacities: about %.1f dB", options.alpha_codewords, alpha.alpha_psnr_db);
  ImGui::Text("package: about %.2f MB", bytes / kMegabyte);
  if (state.curve_of != workspace.results.billboards) {
    badge(Tone::note, "the curve is of older textures");
  }
}

void draw_controls(Workspace& workspace) {
  draw_buttons(workspace);
  draw_expectation(workspace);
  ImGui::TextDisabled("Options apply to the next run.");
  draw_stage_options(workspace, "compress");
}

Plot plot_of(const Workspace& workspace) {
  const CodebookStepState& state = workspace.codebook;
  Plot plot;
  plot.x = {"codewords", true, 12.0, double(kMost) * 1.3};
  plot.y = {"PSNR, dB"};
  plot.right = PlotAxis{"package, MB"};
  PlotLine colour{"colour", {}}, alpha{"opacity", {}}, bytes{"size", {}, true};
  if (state.curve) {
    for (const CodebookPoint& point : *state.curve) {
      colour.points.emplace_back(point.codewords, point.colour_psnr_db);
      alpha.points.emplace_back(point.codewords, point.alpha_psnr_db);
      bytes.points.emplace_back(point.codewords, double(point.package_bytes()) / kMegabyte);
    }
  }
  plot.lines = {colour, alpha, bytes};
  const CompressOptions& options = workspace.project().recipe.compress;
  const int chosen = state.of_colours ? options.colour_codewords : options.alpha_codewords;
  plot.mark_x = double(state.codewords_held.value_or(chosen));
  return plot;
}

// Choosing by dragging on the chart: one edit, when it is let go.
void hear_choice(Workspace& workspace, const std::optional<double>& dragged) {
  CodebookStepState& state = workspace.codebook;
  if (dragged) {
    state.codewords_held = std::clamp(int(std::lround(*dragged)), kFewest, kMost);
    return;
  }
  if (!state.codewords_held) return;
  const std::string wanted = std::to_string(*state.codewords_held);
  state.codewords_held.reset();
  if (option_text(workspace.project().recipe, option_of(state)) == wanted) return;
  edit(workspace, option_edit(workspace.project(), option_of(state), wanted));
}

void draw_curve(Workspace& workspace) {
  draw_choice_of_codebook(workspace.codebook);
  ImGui::SameLine();
  ImGui::TextDisabled("drag on the chart to choose their number");
  const ImVec2 area(0, kPlotEms * ImGui::GetFontSize());
  hear_choice(workspace, draw_plot("codebook/plot", plot_of(workspace), area));
}

}  // namespace

void draw_codebook_step(Workspace& workspace) {
  follow_codebook(workspace);
  ImGui::BeginChild("codebook controls", {kControlsEms * ImGui::GetFontSize(), 0});
  draw_controls(workspace);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("codebook charts", {0, 0}, false, ImGuiWindowFlags_NoScrollWithMouse);
  draw_curve(workspace);
  draw_codebook_views(workspace);
  ImGui::EndChild();
}

}  // namespace bosk
