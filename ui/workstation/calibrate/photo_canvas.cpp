#include "ui/workstation/calibrate/photo_canvas.h"

#include <algorithm>

#include "core/image/orientation.h"
#include "ui/widgets/landmarks.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

// What a click would do, and how this photo stands.
void draw_caption(Workspace& workspace, const PhotoRow& row) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  if (button("calibrate/previous", "<", "Page Up: the photo before")) {
    show_neighbour_on_canvas(workspace, -1);
  }
  ImGui::SameLine();
  if (button("calibrate/next", ">", "Page Down: the next photo")) {
    show_neighbour_on_canvas(workspace, 1);
  }
  ImGui::SameLine();
  ImGui::Checkbox("loupe", &canvas.loupe);
  mark("calibrate/loupe");
  tooltip("L: the pixels under the mouse, enlarged");
  ImGui::SameLine();
  draw_left_out_tools(workspace);
  ImGui::SameLine();
  const std::string hint = canvas.brush ? "paint over sky and what moves"
                           : canvas.point.empty()
                               ? "choose a point in the list, or type a new name, to place it here"
                               : "a click places " + canvas.point + "; Delete removes it here";
  ImGui::TextUnformatted((row.name + ": " + hint).c_str());
}

}  // namespace

glm::dvec2 CanvasPhoto::upright(const glm::dvec2& pixel) const {
  return upright_from_pixel(pixel, size_px, orientation);
}

glm::dvec2 CanvasPhoto::delivered(const glm::dvec2& upright) const {
  return pixel_from_upright(upright, size_px, orientation);
}

const PhotoRow* row_on_canvas(const Workspace& workspace) {
  const auto& rows = workspace.photos.shelf.rows;
  const PhotoRow* row = row_of(workspace, workspace.calibrate.canvas.photo);
  if (row || rows.empty()) return row;
  return &rows.front();
}

void show_on_canvas(Workspace& workspace, const std::string& photo) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  if (canvas.photo == photo) return;
  canvas.photo = photo;
  canvas.held.reset();
  canvas.leaving_out.reset();
  canvas.view = {};
  ask_again(canvas.large);
}

void show_neighbour_on_canvas(Workspace& workspace, int by) {
  const auto& rows = workspace.photos.shelf.rows;
  const PhotoRow* row = row_on_canvas(workspace);
  if (!row) return;
  const auto at = row - rows.data() + by;
  if (at >= 0 && at < std::ssize(rows)) show_on_canvas(workspace, rows[std::size_t(at)].name);
}

std::optional<CanvasPhoto> photo_size(const Workspace& workspace, const PhotoRow& row) {
  const ShelvedPhoto* photo = shelved(workspace, row.file);
  if (!photo || !photo->facts.trouble.empty()) return std::nullopt;
  const DecodedPhoto& decoded = photo->facts.decoded;
  return CanvasPhoto{{decoded.width_px, decoded.height_px}, decoded.metadata.orientation};
}

const std::vector<PhotoMark>& marks_on_canvas(Workspace& workspace) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  const SolvedCameras& solved = workspace.calibrate.solved;
  const PhotoRow* row = row_on_canvas(workspace);
  const std::string photo = row ? row->name : std::string();
  const std::uint64_t session = workspace.session->revision() + 1;
  if (canvas.marks_photo == photo && canvas.marks_session == session &&
      canvas.marks_solved == solved.revision) {
    return canvas.marks;
  }
  canvas.marks_photo = photo;
  canvas.marks_session = session;
  canvas.marks_solved = solved.revision;
  canvas.marks = marks_of(photo, solved.finds.get(), workspace.project().calibration.sightings,
                          solved.calibration.get());
  return canvas.marks;
}

void remove_chosen_mark(Workspace& workspace) {
  const std::string point = workspace.calibrate.canvas.point;
  const PhotoRow* row = row_on_canvas(workspace);
  const auto& marks = marks_on_canvas(workspace);
  const bool seen = std::any_of(marks.begin(), marks.end(), [&](const PhotoMark& each) {
    return each.point == point &&
           (each.kind == PhotoMark::Kind::found || each.kind == PhotoMark::Kind::by_hand);
  });
  if (!row || !seen) return;
  edit_or_tell(workspace, removal_edit(workspace.project(), workspace.calibrate.solved.finds.get(),
                                       row->name, point));
}

void edit_or_tell(Workspace& workspace, Edit change) {
  CalibrateStepState& state = workspace.calibrate;
  state.said.clear();
  done_or_told(state.said, [&] { edit(workspace, std::move(change)); });
}

void draw_photo_canvas(Workspace& workspace) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  const PhotoRow* shown = row_on_canvas(workspace);
  if (!shown) return ImGui::TextDisabled("The project has no photos.");
  const PhotoRow row = *shown;
  draw_caption(workspace, row);
  const auto photo = photo_size(workspace, row);
  if (!photo) return paragraph(row.tone, row.name + ": " + row.reason + ".");
  follow_large(workspace, canvas.large, row, "calibrate/photo");
  const glm::dvec2 size = upright_size(photo->size_px, photo->orientation);
  const ImagePlace place =
      draw_image_view("calibrate/canvas", canvas.view,
                      best_picture(workspace, canvas.large, row, "calibrate/photo"), size);
  if (canvas.brush) {
    hear_left_out(workspace, *photo, place);
  } else {
    hear_canvas(workspace, *photo, place, marks_on_canvas(workspace));
  }
  draw_left_out(workspace, *photo, place);
  draw_marks(workspace, *photo, place, marks_on_canvas(workspace));
  draw_loupe(workspace, *photo, place);
}

}  // namespace bosk
