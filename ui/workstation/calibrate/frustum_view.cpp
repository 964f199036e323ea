#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/image/orientation.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/landmarks.h"
#include "ui/workstation/calibrate/calibrate_panels.h"
#include "ui/workstation/calibrate/frusta_scene.h"
#include "ui/workstation/photos/camera_wheel.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr int kPieces = 4;              // along a photo's edge: quads are drawn without perspective
constexpr int kGridHalf = 8;            // squares of the ground to either side
constexpr double kErrorBarShare = 0.3;  // of a frustum's depth: the median error bar
constexpr float kClickPx = 4.0f;        // a press that moves further is a drag

void draw_ground(const FrustaScene& scene, const glm::dvec3& middle, double step) {
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Border);
  const glm::dvec3 origin(step * std::round(middle.x / step), step * std::round(middle.y / step),
                          0.0);
  const double reach = step * kGridHalf;
  for (int i = -kGridHalf; i <= kGridHalf; ++i) {
    const double at = i * step;
    scene.line(origin + glm::dvec3(at, -reach, 0), origin + glm::dvec3(at, reach, 0), colour, 1.0f);
    scene.line(origin + glm::dvec3(-reach, at, 0), origin + glm::dvec3(reach, at, 0), colour, 1.0f);
  }
}

// The world's axes at its origin, z the longest.
void draw_axes(const FrustaScene& scene, double length) {
  struct Axis {
    glm::dvec3 end;
    Tone tone;
    const char* words;
    float width;
  };
  const Axis axes[] = {{{0.5 * length, 0, 0}, Tone::muted, "x", 2.0f},
                       {{0, 0.5 * length, 0}, Tone::muted, "y", 2.0f},
                       {{0, 0, length}, Tone::good, "up (z)", 4.0f}};
  for (const Axis& axis : axes) {
    scene.line({0, 0, 0}, axis.end, colour_u32(axis.tone), axis.width);
    scene.text(axis.end, colour_u32(axis.tone), axis.words);
  }
}

// Where a place of the picture as delivered is in the upright thumbnail.
ImVec2 texture_at(double across, double down, int orientation) {
  const glm::dvec2 at = upright_from_pixel({across, down}, {2, 2}, orientation);
  return {float(at.x), float(at.y)};
}

// In pieces, each drawn flat: so the picture keeps its perspective.
void draw_picture(const FrustaScene& scene, const Frustum& frustum, const Texture& texture,
                  int orientation) {
  for (int row = 0; row < kPieces; ++row) {
    for (int column = 0; column < kPieces; ++column) {
      std::array<glm::dvec3, 4> corners;
      ImVec2 textures[4];
      for (int i = 0; i < 4; ++i) {
        const double across = double(column + (i == 1 || i == 2)) / kPieces;
        const double down = double(row + (i >= 2)) / kPieces;
        corners[std::size_t(i)] = frustum.at(across, down);
        textures[i] = texture_at(across, down, orientation);
      }
      const auto seen = seen_quad(scene.eye, corners);
      if (!seen) continue;
      scene.draw->AddImageQuad(texture.id, scene.on_screen((*seen)[0]), scene.on_screen((*seen)[1]),
                               scene.on_screen((*seen)[2]), scene.on_screen((*seen)[3]),
                               textures[0], textures[1], textures[2], textures[3]);
    }
  }
}

void draw_edges(const FrustaScene& scene, const Frustum& frustum, bool selected) {
  const ImU32 colour = selected ? colour_u32(Tone::note) : colour_u32(Tone::neutral, 0.6f);
  const float width = selected ? 3.0f : 1.0f;
  for (std::size_t i = 0; i < 4; ++i) {
    scene.line(frustum.eye, frustum.corners[i], colour, width);
    scene.line(frustum.corners[i], frustum.corners[(i + 1) % 4], colour, width);
  }
}

void draw_frustum(Workspace& workspace, const FrustaScene& scene, const Frustum& frustum) {
  const PhotoRow* row = row_of(workspace, frustum.name);
  const Texture picture = row ? thumbnail_of(workspace, row->file) : Texture();
  if (picture) draw_picture(scene, frustum, picture, orientation_of(workspace, frustum.name));
  draw_edges(scene, frustum, frustum.name == workspace.calibrate.selected);
  const auto middle = seen_line(scene.eye, frustum.middle(), frustum.middle());
  if (!middle) return;
  const ImVec2 at = scene.on_screen(middle->first);
  if (scene.shows(at)) mark("calibrate/frustum/" + frustum.name, at, at);
}

// The nearest picture under the mouse; empty: none.
std::string picture_at(const FrustaScene& scene, const std::vector<Frustum>& frusta,
                       const std::vector<std::size_t>& order, const ImVec2& mouse) {
  const glm::dvec2 pixel(double(mouse.x - scene.least.x), double(mouse.y - scene.least.y));
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    const auto seen = seen_quad(scene.eye, frusta[*i].corners);
    if (seen && is_inside(*seen, pixel)) return frusta[*i].name;
  }
  return {};
}

glm::dvec2 vector_of(const ImVec2& point) { return {double(point.x), double(point.y)}; }

void hear_view(Workspace& workspace, const std::vector<Camera>& cameras, double height) {
  CalibrateStepState& state = workspace.calibrate;
  const ImGuiIO& io = ImGui::GetIO();
  const glm::dvec2 delta = vector_of(io.MouseDelta);
  const bool left = ImGui::IsItemActive() && ImGui::IsMouseDragging(0, kClickPx);
  const bool middle = ImGui::IsItemActive() && ImGui::IsMouseDragging(2, 0.0f);
  if ((left || middle) && delta != glm::dvec2(0.0)) {
    state.through.clear();
    const bool move = middle || ImGui::IsKeyDown(kKeySpace);
    state.view = move ? moved(state.view, delta, height) : turned(state.view, delta, height);
  }
  if (!ImGui::IsItemHovered()) return;
  if (io.MouseWheel != 0.0f) {
    state.through.clear();
    state.view = nearer(state.view, double(io.MouseWheel));
  }
  if (workspace.input.pressed(kKeyHome) && !io.WantTextInput) {
    state.through.clear();
    state.view = overview_of(cameras, middle_of(cameras));
  }
}

// Another set of cameras is shown as a whole first; those that were solved again are the same set.
void follow_cameras_shown(CalibrateStepState& state, const std::vector<Camera>& cameras) {
  if (state.view_revision == state.known.revision) return;
  state.view_revision = state.known.revision;
  const bool solved = state.known.place.empty();
  if (std::exchange(state.view_of_solved, solved) && solved) return;
  state.view = overview_of(cameras, middle_of(cameras));
}

Camera eye_of_scene(const CalibrateStepState& state, const std::vector<Camera>& cameras,
                    const glm::dvec2& size) {
  const auto through = std::find_if(cameras.begin(), cameras.end(), [&](const Camera& camera) {
    return camera.name == state.through;
  });
  return through == cameras.end() ? camera_of(state.view, size) : camera_through(*through, size);
}

void draw_scale(const FrustaScene& scene, double step, bool metres) {
  char words[128];
  std::snprintf(words, sizeof words,
                "ground z = 0, a square is %g %s   drag: turn, wheel: nearer, Home: all", step,
                metres ? "m" : "of the cameras' distance");
  const ImVec2 at(scene.least.x + 8.0f, scene.most.y - 1.5f * ImGui::GetTextLineHeight());
  scene.draw->AddText(at, ImGui::GetColorU32(ImGuiCol_TextDisabled), words);
}

// Null where the cameras are those of a file.
std::shared_ptr<const Calibration> shown_calibration(const CalibrateStepState& state) {
  return state.known.place.empty() ? state.solved.calibration : nullptr;
}

// A click chooses the picture under the mouse.
void hear_pictures(Workspace& workspace, const std::string& under) {
  tooltip(under);
  const bool clicked =
      ImGui::IsMouseReleased(0) && ImGui::GetIO().MouseDragMaxDistanceSqr[0] < kClickPx * kClickPx;
  if (!clicked || under.empty()) return;
  workspace.calibrate.selected = under;
  show_on_canvas(workspace, under);
}

}  // namespace

void draw_frusta(Workspace& workspace, const std::vector<Camera>& cameras) {
  CalibrateStepState& state = workspace.calibrate;
  follow_cameras_shown(state, cameras);
  const ImVec2 area = ImGui::GetContentRegionAvail();
  std::vector<SceneLabel> labels;
  FrustaScene scene;
  scene.labels = &labels;
  scene.draw = ImGui::GetWindowDrawList();
  scene.least = ImGui::GetCursorScreenPos();
  const ImVec2 size(std::max(1.0f, area.x), std::max(1.0f, area.y));
  scene.most = {scene.least.x + size.x, scene.least.y + size.y};
  ImGui::InvisibleButton("view", size, 7);  // all three buttons
  mark("calibrate/view");
  hear_view(workspace, cameras, double(size.y));
  scene.eye = eye_of_scene(state, cameras, vector_of(size));

  const glm::dvec3 middle = middle_of(cameras);
  const double depth = frustum_depth(cameras, middle);
  std::vector<Frustum> frusta;
  for (const Camera& camera : cameras) frusta.push_back(frustum_of(camera, depth));
  const auto order = back_to_front(frusta, scene.eye.centre_in_world());
  const double step = grid_step(10.0 * depth);

  scene.draw->PushClipRect(scene.least, scene.most, true);
  draw_ground(scene, middle, step);
  draw_axes(scene, 4.0 * depth);
  for (const std::size_t i : order) draw_frustum(workspace, scene, frusta[i]);
  const auto solved = shown_calibration(state);
  if (solved) draw_error_bars(scene, *solved, kErrorBarShare * depth);
  draw_labels(scene);
  draw_scale(scene, step, !solved || solved->scale_known);
  scene.draw->PopClipRect();

  if (!ImGui::IsItemHovered()) return;
  hear_pictures(workspace, picture_at(scene, frusta, order, ImGui::GetIO().MousePos));
}

}  // namespace bosk
