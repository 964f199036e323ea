#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/matte/live_matte.h"
#include "core/matte/matte_views.h"
#include "core/matte/strokes.h"
#include "core/project/stages.h"
#include "ui/widgets/pictures.h"

namespace bosk {

struct Workspace;

// What a live matte was, or is to be, made from.
struct LiveSource {
  std::uint64_t strokes = 0;  // revision
  std::uint64_t others = 0;   // what the other photos say, revision
  std::string options;
  bool operator==(const LiveSource&) const = default;
};

// Where the matte that is shown comes from.
enum class ShownMatte { none, live, full, outdated };

// What a picture of the canvas was made from, but for the strokes' pixels.
struct CanvasLook {
  MatteView view = MatteView::photo;
  ShownMatte shown = ShownMatte::none;
  std::shared_ptr<const Mattes> mattes;
  std::uint64_t live = 0;  // revision of the live matte, where it is shown
  bool strokes = true;
  bool operator==(const CanvasLook&) const = default;
};

// One photo made ready to be painted on, and what it shows. Pixels are those of the working photo,
// as delivered.
struct MatteCanvas {
  std::string photo;                               // empty: none
  std::shared_ptr<const ImportedPhotos> imported;  // that it is from
  std::shared_ptr<const LivePhoto> ready;          // null while it is made ready
  std::string trouble;                             // with the files of its strokes
  Image<std::uint8_t> drawn;                       // what files say; may be empty
  std::vector<Stroke> painted;                     // those in `strokes`, but for the one in hand
  Image<std::uint8_t> strokes;                     // values of scribbles.h
  std::uint64_t strokes_revision = 0;              // raised by every change
  std::optional<std::uint64_t> seen_session;       // revision that `painted` was compared at

  LiveMatte live;  // the newest; of `live_of`
  LiveSource live_of, live_asked;
  std::uint64_t live_revision = 0;
  int live_job = 0;

  Image<glm::u8vec4> picture;
  std::uint64_t picture_revision = 0;
  CanvasLook look;  // of the picture
  PixelBox dirty;   // painted on since
};

// Opens the photo that the step shows, brings its strokes up to date with the project and starts a
// live matte where one is due. Once a frame.
void follow_canvas(Workspace& workspace);

// What the project has drawn on a photo.
const std::vector<Stroke>& strokes_on(const Workspace& workspace, const std::string& photo);
// The photo's working pixels; null where nothing is imported.
const Photo* photo_on_canvas(const Workspace& workspace);
// The matte in view and what it is.
ShownMatte shown_matte(const Workspace& workspace, const Image<glm::vec4>*& matte);

// Paints a part of a stroke that is under way.
void paint_on_canvas(Workspace& workspace, const Stroke& part);

// The canvas as the screen sees it, not turned upright. Nothing while it is not ready.
Texture canvas_texture(Workspace& workspace);

}  // namespace bosk
