#include "ui/workstation/matte/matte_step.h"

#include <imgui.h>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/image/orientation.h"
#include "core/photo/decode.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/capture_files.h"
#include "ui/workstation/matte/matte_paint.h"
#include "ui/workstation/photos/photo_shelf.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

constexpr float kToolsEms = 20.0f;

// Pixels to paint on are the import's; it is quick and needs no question.
void follow_import(Workspace& workspace) {
  MatteStepState& step = workspace.matte;
  if (state_of(workspace, "photo") == StageState::current || workspace.running_job != 0) return;
  if (!workspace.capture || !obstacle_to_stages(workspace).empty()) return;
  const std::uint64_t revision = workspace.session->revision();
  if (step.asked_import == revision) return;
  step.asked_import = revision;
  run_to(workspace, "photo");
}

// The full mattes follow when the live one has caught up with the last stroke; the next stroke
// stops them.
void follow_hand(Workspace& workspace) {
  MatteStepState& step = workspace.matte;
  const bool own_job = step.kept_up_job != 0 && step.kept_up_job == workspace.running_job;
  if (step.in_hand && own_job) workspace.jobs.cancel(workspace.running_job);
  if (!step.keep_up || step.in_hand || workspace.running_job != 0) return;
  const bool live_due = step.canvas.ready && !(step.canvas.live_of == step.canvas.live_asked);
  const bool half_drawn = !step.canvas.painted.empty() && !step.canvas.live.what_is_missing.empty();
  if (live_due || half_drawn || !obstacle_to_stages(workspace).empty()) return;
  const StageState state = state_of(workspace, "matte");
  const std::uint64_t revision = workspace.session->revision();
  if (state == StageState::current || step.kept_up_at == revision) return;
  step.kept_up_at = revision;
  run_to(workspace, "matte");
  step.kept_up_job = workspace.running_job;
}

// One line on what is seen, over the canvas.
void draw_caption(const Workspace& workspace) {
  const MatteCanvas& canvas = workspace.matte.canvas;
  const Image<glm::vec4>* matte = nullptr;
  const ShownMatte shown = shown_matte(workspace, matte);
  ImGui::TextUnformatted(
      (workspace.matte.photo + ", " + name_of(workspace.matte.view) + ".").c_str());
  ImGui::SameLine();
  if (shown == ShownMatte::full) return badge(Tone::good, "full matte");
  if (shown == ShownMatte::live) return badge(Tone::busy, "live matte, reduced");
  if (shown == ShownMatte::outdated) badge(Tone::note, "full matte of an earlier state");
  if (shown == ShownMatte::none) badge(Tone::muted, "no matte yet");
  if (canvas.live.what_is_missing.empty() || canvas.painted.empty()) return;
  ImGui::SameLine();
  ImGui::TextUnformatted(shown == ShownMatte::outdated
                             ? "Matte all photos to see what the strokes correct."
                             : canvas.live.what_is_missing.c_str());
}

void draw_upright(const Texture& texture, int orientation, const ImagePlace& place) {
  if (!texture) return;
  const auto uv = corner_textures(orientation);
  const auto corner = [&](std::size_t i) { return ImVec2(uv[i].x, uv[i].y); };
  const glm::dvec2 end = place.origin + place.size_px * place.scale;
  const float x = float(place.origin.x), y = float(place.origin.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(place.least, place.most, true);
  draw.AddImageQuad(texture.id, {x, y}, {float(end.x), y}, {float(end.x), float(end.y)},
                    {x, float(end.y)}, corner(0), corner(1), corner(2), corner(3));
  draw.PopClipRect();
}

void draw_canvas(Workspace& workspace) {
  MatteStepState& step = workspace.matte;
  draw_caption(workspace);
  if (!step.canvas.trouble.empty()) paragraph(Tone::bad, step.canvas.trouble);
  const Photo* photo = photo_on_canvas(workspace);
  if (!photo) return ImGui::TextDisabled("The photo is being opened.");
  const int orientation = orientation_on_canvas(workspace);
  const glm::ivec2 size = upright_size({photo->srgb.width(), photo->srgb.height()}, orientation);
  const ImagePlace place = draw_image_view("matte/canvas", step.image_view, {}, size);
  hear_brush(workspace, place);  // before the picture, so that this frame shows it
  draw_upright(canvas_texture(workspace), orientation, place);
  draw_brush(workspace, place);
}

void draw_main(Workspace& workspace) {
  const auto& imported = workspace.results.imported;
  if (imported && !imported->photos.empty()) {
    return workspace.matte.sheet ? draw_matte_sheet(workspace) : draw_canvas(workspace);
  }
  const std::string obstacle = obstacle_to_stages(workspace);
  if (!obstacle.empty()) return paragraph("First " + obstacle + ".");
  paragraph(workspace.running_job != 0 ? "The photos are being read."
                                       : "The photos could not be read; see the jobs below.");
}

// What is wrong with a matte; empty: nothing.
std::string trouble_with_matte(const fs::path& file, const DecodeLimits& limits,
                               Progress& progress) {
  progress.begin("looking at a matte", 1);
  try {
    decode_matte(file, limits, progress);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    return error.what();
  }
  return {};
}

void install_mattes(Workspace& workspace, const fs::path& folder, std::size_t count,
                    const std::string& trouble) {
  MatteStepState& step = workspace.matte;
  const Project& project = workspace.project();
  step.taking = {};
  step.said.clear();
  if (!trouble.empty()) {
    step.said.push_back({Tone::bad, trouble + ". A folder that is dropped here is taken for mattes "
                                              "where its files are called like the photos; photos "
                                              "are dropped on step Photos."});
    return;
  }
  const std::string words = std::to_string(count) + " of " + std::to_string(project.photos.size());
  const bool again = project.absolute(project.mattes) == folder;
  const bool done = done_or_told(step.said, [&] {
    if (again) return reread_files(workspace);
    edit(workspace, files_edit(project, FileKind::mattes, project.relative(folder)));
  });
  if (!done) return;
  step.said.push_back({Tone::good, "Took " + printable(folder.filename().string()) +
                                       " for the project's mattes: " + words +
                                       " photos have one. Undo goes back to strokes."});
}

}  // namespace

void take_mattes(Workspace& workspace, const std::vector<fs::path>& files) {
  MatteStepState& step = workspace.matte;
  step.said = {{Tone::busy, "Looking whether these are mattes."}};
  step.taking = {};
  step.taking.id = workspace.jobs.start(
      "Looking at mattes",
      [file = files.front(), limits = decode_limits(workspace.project().recipe.photo)](
          Progress& progress) { return trouble_with_matte(file, limits, progress); },
      [&workspace, project = workspace.project().folder, folder = files.front().parent_path(),
       count = files.size()](const std::string& trouble) {
        const bool same = workspace.session && workspace.project().folder == project;
        if (same) install_mattes(workspace, folder, count, trouble);
      },
      Lane::interactive, "matte/take");
}

std::string strokes_obstacle(const Workspace& workspace) {
  if (!workspace.capture) return "strokes can be drawn once photos and their cameras are there";
  if (!workspace.capture->mattes.empty()) {
    return "this project has finished mattes, so strokes are not used";
  }
  return {};
}

int orientation_on_canvas(const Workspace& workspace) {
  return orientation_of(workspace, workspace.matte.canvas.photo);
}

void draw_matte_step(Workspace& workspace) {
  MatteStepState& step = workspace.matte;
  if (was_stopped(step.taking, workspace.jobs)) {
    step.said = {{Tone::note, "That was stopped; the project's mattes are as they were."}};
  }
  follow_photos(workspace);
  follow_import(workspace);
  follow_mattes(workspace);
  follow_canvas(workspace);
  follow_hand(workspace);
  hear_matte_keys(workspace);
  ImGui::BeginChild("matte tools", {kToolsEms * ImGui::GetFontSize(), 0.0f});
  draw_notices(step.said);
  draw_matte_tools(workspace);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("matte main", {0.0f, 0.0f}, false,
                    step.sheet ? 0 : ImGuiWindowFlags_NoScrollWithMouse);
  draw_main(workspace);
  ImGui::EndChild();
}

}  // namespace bosk
