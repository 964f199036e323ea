#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/image_view.h"
#include "ui/workstation/calibrate/photo_marks.h"
#include "ui/workstation/photos/large_photo.h"

namespace bosk {

struct Workspace;

// A mark under the hand, until the button is let go. Pixels of the photo as delivered.
struct HeldMark {
  std::string point;
  glm::dvec2 pixel{0.0};       // where it would be now
  glm::dvec2 from_mouse{0.0};  // from the mouse to it, in upright pixels
  ImVec2 pressed{0, 0};        // on the screen
  bool moved = false;
};

// What the canvas of step Calibrate remembers between frames.
struct PhotoCanvas {
  std::string photo;  // its name; empty: the first
  std::string point;  // the chosen one, which a click places; empty: none
  ImageView view;
  LargePhoto large;
  std::optional<HeldMark> held;
  bool pressed_on_nothing = false;  // the button went down beside all marks
  bool loupe = true;
  bool brush = false;                 // the hand leaves out instead of placing points
  double brush_share = 0.03;          // its radius, of the photo's longer side
  std::optional<Stroke> leaving_out;  // in hand
  std::vector<PhotoMark> marks;       // as of the revisions below
  std::string marks_photo;
  std::uint64_t marks_session = 0, marks_solved = 0;
};

// The photo with what is seen on it, and the hand that corrects it.
void draw_photo_canvas(Workspace& workspace);

// The photo on the canvas; null where the project has none of that name.
const PhotoRow* row_on_canvas(const Workspace& workspace);
void show_on_canvas(Workspace& workspace, const std::string& photo);
void show_neighbour_on_canvas(Workspace& workspace, int by);

// Its size as delivered and how it is turned for the screen; none until it was looked through.
struct CanvasPhoto {
  glm::ivec2 size_px{0};
  int orientation = 1;

  glm::dvec2 upright(const glm::dvec2& pixel) const;
  glm::dvec2 delivered(const glm::dvec2& upright) const;
};
std::optional<CanvasPhoto> photo_size(const Workspace& workspace, const PhotoRow& row);

// What is seen on the photo now; valid until the next change.
const std::vector<PhotoMark>& marks_on_canvas(Workspace& workspace);

// Parts of it, each in its own file.
void draw_marks(const Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place,
                const std::vector<PhotoMark>& marks);
void hear_canvas(Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place,
                 const std::vector<PhotoMark>& marks);
void hear_canvas_keys(Workspace& workspace);
void draw_loupe(const Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place);

// What calibration leaves out of the photo; null where that is nothing.
const std::vector<Stroke>* left_out_on_canvas(const Workspace& workspace);
void draw_left_out_tools(Workspace& workspace);
void draw_left_out(const Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place);
void hear_left_out(Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place);
void resize_left_out_brush(PhotoCanvas& canvas, int steps);

// So that the chosen point isn't seen on this photo; nothing where it isn't.
void remove_chosen_mark(Workspace& workspace);
// Applies the edit, or tells in the step's notices why it doesn't fit.
void edit_or_tell(Workspace& workspace, Edit change);

}  // namespace bosk
