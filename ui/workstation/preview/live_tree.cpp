#include "ui/workstation/preview/live_tree.h"

#include <imgui.h>

#include <algorithm>

#include "core/image/image_io.h"
#include "core/package/reader.h"
#include "core/render/reference.h"
#include "ui/view_marks.h"
#include "ui/widgets/camera_mouse.h"
#include "ui/widgets/figures_table.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/option_widget.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr double kMostAtRest = 1000.0;  // ms that a whole picture may take once nothing moves
constexpr int kSlowHeight = 320;        // pixels of a picture that the CPU draws
constexpr float kOptionsEms = 19.0f;
constexpr glm::vec3 kGrey(0.62f);  // behind the CPU's pictures

using Package = std::shared_ptr<const std::vector<std::byte>>;

struct MadeScene {
  std::shared_ptr<const SceneTree> tree;
  std::shared_ptr<const ForestScene> scene;
};

MadeScene made_scene(const Package& package, std::shared_ptr<const SceneTree> tree,
                     const ScatterOptions& options, const std::string& name, Progress& progress) {
  progress.begin("making the tree ready", 1);
  if (!tree) tree = std::make_shared<const SceneTree>(name, read_tree(*package, name));
  progress.check();
  const SceneTrees trees = {tree};
  auto scene = std::make_shared<const ForestScene>(
      scene_on(terrain_of(options), trees, places_of(trees, {}, options)));
  return {tree, scene};
}

// Makes a scene of the newest package and the forest wanted, beside the window.
void follow_package(Workspace& workspace) {
  LiveTreeState& state = workspace.preview.live;
  const Package& package = workspace.results.package;
  const std::string forest_text = values_text(describe(state.forest));
  if (state.package == package && state.forest_text == forest_text) return;
  if (state.package != package) state.tree.reset();
  state.package = package;
  state.forest_text = forest_text;
  workspace.jobs.start(
      "Making the tree ready to look at",
      [package, tree = state.tree, options = state.forest, name = workspace.project().name()](
          Progress& progress) { return made_scene(package, tree, options, name, progress); },
      [&state, package](const MadeScene& made) {
        if (state.package != package) return;  // the project was closed or made another since
        state.tree = made.tree;
        state.scene = made.scene;
      },
      Lane::interactive, "preview scene");
}

void frame_tree(LiveTreeState& state, const glm::ivec2& size_px) {
  state.camera = framing(*state.scene, size_px, view_angle(state.look));
  state.framed = true;
}

void hear(Workspace& workspace, const glm::ivec2& size_px) {
  LiveTreeState& state = workspace.preview.live;
  const Terrain& terrain = state.scene->terrain;
  if (ImGui::IsItemHovered()) state.camera = zoomed_by_wheel(state.camera, terrain);
  if (ImGui::IsItemActive()) {
    state.camera = moved_by_drag(state.camera, terrain, double(size_px.y), view_angle(state.look));
  }
  const bool home =
      ImGui::IsItemHovered() && workspace.input.pressed(kKeyHome) && !ImGui::GetIO().WantTextInput;
  if (home || !state.framed) frame_tree(state, size_px);
}

// In how many pixels the wanted picture is drawn now.
PictureKey key_for_now(LiveTreeState& state, const PictureKey& key, bool at_rest) {
  const double whole_ms = whole_picture_ms(state.pace, key.size_px);
  if (state.wanted != key) {
    state.wanted = key;
    state.share = share_while_moving(whole_ms, state.look.frame_ms);
  } else if (at_rest && whole_ms <= kMostAtRest) {
    state.share = 1.0;
  }
  PictureKey now = key;
  now.size_px = glm::max(glm::ivec2(glm::dvec2(key.size_px) * state.share), glm::ivec2(1));
  return now;
}

// Draws through Workspace::tree_pictures, when anything changed or better can be had.
void draw_fast(Workspace& workspace, const PictureKey& key) {
  LiveTreeState& state = workspace.preview.live;
  const DrawWithBudget draw = [&](const PictureKey& now, std::uint64_t budget) {
    const Camera camera = camera_of(now.camera, now.size_px, view_angle(state.look));
    const DrawnPicture drawn =
        workspace.tree_pictures.draw(state.scene, camera, state.look, budget, now.wind_time_s);
    state.texture = drawn.texture;
    state.trouble = drawn.trouble;
    return drawn.figures;
  };
  if (state.drawn_scene != state.scene.get()) state.pace.drawn.reset();
  state.drawn_scene = state.scene.get();
  const bool moving = state.wanted != key;
  const PictureKey now = key_for_now(state, key, workspace.input.at_rest);
  const PicturePace before = state.pace;
  // A sharper picture has as many billboards as a first one, and says nothing of what moving ones
  // may cost
  const bool sharper = !moving && before.drawn;
  if (sharper) {
    state.pace.moving_budget = std::max(before.moving_budget, PicturePace().moving_budget);
    state.pace.moving_cost = {};
  }
  const bool drew = draw_when_changed(state.pace, now, state.look, draw);
  if (sharper) {
    state.pace.moving_budget = before.moving_budget;
    state.pace.moving_cost = before.moving_cost;
  }
  if (!drew && workspace.input.at_rest) refine_at_rest(state.pace, state.look, draw);
  const bool could_be_sharper =
      state.share < 1.0 && whole_picture_ms(state.pace, key.size_px) <= kMostAtRest;
  if (could_be_sharper || better_budget(state.pace, state.look))
    workspace.next_frame = NextFrame::at_rest;
  if (state.look.wind_m > 0.0) workspace.next_frame = NextFrame::at_once;
}

// Starts a picture by the CPU where the newest is of something else; one at a time, so that there
// is something to see while the hand moves.
void draw_slowly(Workspace& workspace, const PictureKey& key) {
  LiveTreeState& state = workspace.preview.live;
  const bool same = state.job_key == key && state.job_scene == state.scene.get();
  if (same || workspace.jobs.is_open(state.job)) return;
  state.job_key = key;
  state.job_scene = state.scene.get();
  state.job = workspace.jobs.start(
      "Drawing the tree",
      [tree = state.scene->trees.front(), key, look = state.look](Progress& progress) {
        return slow_picture(*tree, key, look, kSlowHeight, progress);
      },
      [&state, scene = state.scene](Image<glm::u8vec4> picture) {
        if (state.job_scene != scene.get()) return;  // another project's
        state.slow_picture = std::make_shared<const Image<glm::u8vec4>>(std::move(picture));
        ++state.slow_revision;
      },
      Lane::interactive, "preview picture");
}

void show(Workspace& workspace, const ImVec2& least, const ImVec2& most) {
  LiveTreeState& state = workspace.preview.live;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (workspace.tree_pictures.draw) {
    if (state.texture) list.AddImage(state.texture.id, least, most, {0, 1}, {1, 0});
    return;
  }
  if (!state.slow_picture) return;
  const Texture texture = workspace.pictures.show("preview/live", state.slow_revision,
                                                  [&] { return *state.slow_picture; });
  if (texture) list.AddImage(texture.id, least, most);
}

ImU32 colour_u32(const glm::u8vec3& colour) { return IM_COL32(colour.r, colour.g, colour.b, 255); }

void draw_marks_over(const LiveTreeState& state, const glm::ivec2& size_px, const ImVec2& least,
                     float points_per_px) {
  const Camera camera = camera_of(state.camera, size_px, view_angle(state.look));
  for (const ViewMark& mark : view_marks(*state.scene, camera, target_of(state.camera))) {
    ImGui::GetWindowDrawList()->AddCircleFilled(
        {least.x + float(mark.pixel.x + 0.5) * points_per_px,
         least.y + float(mark.pixel.y + 0.5) * points_per_px},
        float(kMarkRadius) * points_per_px,
        colour_u32(mark.is_mixed ? kMixedMarkColour : kMarkColour));
  }
}

void draw_picture(Workspace& workspace, const ImVec2& area) {
  LiveTreeState& state = workspace.preview.live;
  const float px_per_point = std::max(0.1f, ImGui::GetIO().DisplayFramebufferScale.x);
  const glm::ivec2 size_px(std::max(1, int(area.x * px_per_point)),
                           std::max(1, int(area.y * px_per_point)));
  const ImVec2 least = ImGui::GetCursorScreenPos();
  const ImVec2 most(least.x + area.x, least.y + area.y);
  ImGui::InvisibleButton("tree", area, 7);  // all three buttons
  mark("preview/tree");
  hear(workspace, size_px);
  const PictureKey key = picture_key(state.camera, size_px, state.look, ImGui::GetTime());
  if (workspace.tree_pictures.draw) {
    draw_fast(workspace, key);
  } else {
    draw_slowly(workspace, key);
  }
  show(workspace, least, most);
  if (state.look.cameras) draw_marks_over(state, size_px, least, 1.0f / px_per_point);
}

void draw_options(Workspace& workspace) {
  LiveTreeState& state = workspace.preview.live;
  if (button("preview/home", "Show all (Home)", "puts the eye where all of it is seen")) {
    state.framed = false;
  }
  ImGui::PushItemWidth(0.5f * ImGui::GetContentRegionAvail().x);
  for (const Option& option : describe(state.look)) {
    draw_option(option);
    mark("preview/look/" + option.name);
  }
  ImGui::Separator();
  ImGui::TextUnformatted("Forest");
  for (const Option& option : describe(state.forest)) {
    draw_option(option);
    mark("preview/forest/" + option.name);
  }
  ImGui::PopItemWidth();
  ImGui::Separator();
  if (!workspace.tree_pictures.draw) {
    paragraph(Tone::note,
              "Without OpenGL one tree is drawn by the CPU, small, in its own colours.");
  } else if (state.trouble.empty()) {
    draw_figures_table(state.pace.figures);
  } else {
    paragraph(Tone::bad, state.trouble);
  }
}

}  // namespace

Image<glm::u8vec4> slow_picture(const SceneTree& tree, const PictureKey& key,
                                const ViewOptions& options, int most_px, Progress& progress) {
  const double shrink = std::min(1.0, double(most_px) / double(key.size_px.y));
  const glm::ivec2 size_px = glm::max(glm::ivec2(glm::dvec2(key.size_px) * shrink), glm::ivec2(1));
  RenderOptions render;
  render.detail = options.detail;
  render.blend = options.blend;
  const Camera camera = camera_of(key.camera, size_px, view_angle(options));
  const Image<glm::vec3> over =
      over_colour(render_tree(tree.prepared, camera, render, progress), kGrey);
  Image<glm::u8vec4> picture(over.width(), over.height());
  std::transform(over.pixels().begin(), over.pixels().end(), picture.pixels().begin(),
                 [](const glm::vec3& colour) {
                   return glm::u8vec4(byte_from_unit(colour.r), byte_from_unit(colour.g),
                                      byte_from_unit(colour.b), 255);
                 });
  return picture;
}

void draw_live_tree(Workspace& workspace) {
  follow_package(workspace);
  if (!workspace.preview.live.scene) return paragraph("The tree is being made ready.");
  const float options_width = kOptionsEms * ImGui::GetFontSize();
  const ImVec2 left = ImGui::GetContentRegionAvail();
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  draw_picture(workspace,
               {std::max(1.0f, left.x - options_width - spacing), std::max(1.0f, left.y)});
  ImGui::SameLine();
  ImGui::BeginChild("preview options", {0, 0});
  draw_options(workspace);
  ImGui::EndChild();
}

}  // namespace bosk
