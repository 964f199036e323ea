#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/image_view.h"
#include "ui/workstation/matte/matte_brush.h"
#include "ui/workstation/matte/matte_canvas.h"
#include "ui/workstation/matte/matte_review.h"
#include "ui/workstation/notice.h"
#include "ui/workstation/watched_job.h"

namespace bosk {

struct Workspace;

// A right drag that changes the brush's size.
struct BrushResize {
  glm::dvec2 from_screen{0.0};
  double radius_px = 0.0;  // when it began
};

// What the step remembers between frames.
struct MatteStepState {
  std::string photo;  // shown; empty: the first
  MatteView view = MatteView::photo;
  MatteBrush brush;
  ImageView image_view;
  bool sheet = false;             // all photos, in place of one
  bool doubt_first = false;       // the order of the list and the sheet
  bool keep_up = false;           // matte all photos whenever the hand rests
  std::optional<Stroke> in_hand;  // in pixels of the photo as taken
  std::optional<BrushResize> resizing;
  MatteCanvas canvas;
  MatteReview review;
  Notices said;                               // of finished mattes
  WatchedJob taking;                          // looks whether files are mattes
  std::optional<std::uint64_t> asked_import;  // session's revision when photos were last asked for
  std::optional<std::uint64_t> kept_up_at;    // the same, when "keep up" last started the mattes
  int kept_up_job = 0;                        // that it started
};

void draw_matte_step(Workspace& workspace);

// Makes the folder of these files the project's mattes, in one edit, once a job saw that the first
// is a matte. What came of it is told in the step.
void take_mattes(Workspace& workspace, const std::vector<std::filesystem::path>& files);

// Parts of it, each in its own file.
void draw_matte_tools(Workspace& workspace);
void draw_matte_photos(Workspace& workspace);  // the list
void draw_matte_sheet(Workspace& workspace);   // all photos in the present view
void hear_matte_keys(Workspace& workspace);

// Why strokes can't be drawn; empty when they can.
std::string strokes_obstacle(const Workspace& workspace);
// Of the photo on the canvas, as EXIF has it: how it is turned for the screen.
int orientation_on_canvas(const Workspace& workspace);

}  // namespace bosk
