#include <imgui.h>

#include <cmath>

#include "ui/widgets/keys.h"
#include "ui/workstation/calibrate/photo_canvas.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr double kReachPx = 10.0;  // of the mouse to a mark, on the screen
constexpr float kClickPx = 3.0f;   // a press that moves further is a drag

glm::dvec2 vector_of(const ImVec2& point) { return {double(point.x), double(point.y)}; }

// Where the mouse was when the button went down or up: a slow frame sees only its last place.
ImVec2 place_of_button(const WindowInput& input, const std::optional<std::size_t>& at) {
  if (at && *at < input.mouse_path.size()) return input.mouse_path[*at];
  return ImGui::GetIO().MousePos;
}

bool is_drag(const ImVec2& from, const ImVec2& to) {
  return std::hypot(to.x - from.x, to.y - from.y) > kClickPx;
}

void press(PhotoCanvas& canvas, const CanvasPhoto& photo, const ImagePlace& place,
           const std::vector<PhotoMark>& marks, const ImVec2& mouse) {
  const glm::dvec2 upright = place.picture_from_screen(vector_of(mouse));
  const PhotoMark* taken = mark_at(marks, photo.delivered(upright), kReachPx / place.scale);
  if (!taken) {
    canvas.held = HeldMark{canvas.point, photo.delivered(upright), {}, mouse, false};
    canvas.pressed_on_nothing = true;
    return;
  }
  canvas.point = taken->point;
  canvas.held =
      HeldMark{taken->point, taken->pixel, photo.upright(taken->pixel) - upright, mouse, false};
  canvas.pressed_on_nothing = false;
}

void drag(PhotoCanvas& canvas, const CanvasPhoto& photo, const ImagePlace& place,
          const ImVec2& mouse) {
  HeldMark& held = *canvas.held;
  held.moved = held.moved || is_drag(held.pressed, mouse);
  if (!held.moved && !canvas.pressed_on_nothing) return;
  const glm::dvec2 upright = place.picture_from_screen(vector_of(mouse)) + held.from_mouse;
  held.pixel = photo.delivered(upright);
}

bool is_in_photo(const CanvasPhoto& photo, const glm::dvec2& pixel) {
  return pixel.x >= -0.5 && pixel.y >= -0.5 && pixel.x <= photo.size_px.x - 0.5 &&
         pixel.y <= photo.size_px.y - 0.5;
}

// A mark that was moved, and a chosen point that was placed, are one edit.
void let_go(Workspace& workspace, const CanvasPhoto& photo) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  const HeldMark held = *canvas.held;
  canvas.held.reset();
  const PhotoRow* row = row_on_canvas(workspace);
  if (!row || held.point.empty() || !(held.moved || canvas.pressed_on_nothing)) return;
  if (!is_in_photo(photo, held.pixel)) return;
  edit_or_tell(workspace, sighting_edit(workspace.project(), row->name, held.point,
                                        HandSighting{true, held.pixel}));
}

}  // namespace

void hear_canvas(Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place,
                 const std::vector<PhotoMark>& marks) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  const ImGuiIO& io = ImGui::GetIO();
  const WindowInput& input = workspace.input;
  const bool began = place.hovered && io.MouseClicked[ImGuiMouseButton_Left] &&
                     !ImGui::IsKeyDown(kKeySpace) && !canvas.held;
  if (began) {
    press(canvas, photo, place, marks, place_of_button(input, input.pressed_at));
    workspace.calibrate.rename_to = canvas.point;
  }
  if (!canvas.held) return;
  const bool up = input.ends_stroke(began);
  drag(canvas, photo, place, up ? place_of_button(input, input.released_at) : io.MousePos);
  if (up) let_go(workspace, photo);
}

void hear_canvas_keys(Workspace& workspace) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl || io.WantTextInput) return;
  for (const int key : workspace.input.keys) {
    switch (key) {
      case kKeyPageDown:
      case kKeyPageUp:
        show_neighbour_on_canvas(workspace, key == kKeyPageDown ? 1 : -1);
        break;
      case kKeyDelete:
        remove_chosen_mark(workspace);
        break;
      case kKeyEscape:
        canvas.held.reset();
        canvas.leaving_out.reset();
        canvas.brush = false;
        canvas.point.clear();
        break;
      case 'B':
        canvas.brush = !canvas.brush;
        canvas.held.reset();
        canvas.leaving_out.reset();
        break;
      case kKeyLeftBracket:
      case kKeyRightBracket:
        resize_left_out_brush(canvas, key == kKeyRightBracket ? 1 : -1);
        break;
      case 'L':
        canvas.loupe = !canvas.loupe;
        break;
      default:
        break;
    }
  }
}

}  // namespace bosk
