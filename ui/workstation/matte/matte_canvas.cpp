#include "ui/workstation/matte/matte_canvas.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/project/imported_mattes.h"
#include "ui/workstation/matte/matte_paint.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

const Photo* find_photo(const ImportedPhotos& imported, const std::string& name) {
  for (const Photo& photo : imported.photos) {
    if (photo.name == name) return &photo;
  }
  return nullptr;
}

struct Opened {
  std::shared_ptr<const LivePhoto> ready;
  Image<std::uint8_t> drawn;
  std::string trouble;
};

Opened opened(const Photo& photo, const std::vector<SourceFile>& drawings,
              const DecodeLimits& limits, Progress& progress) {
  Opened result;
  result.ready = std::make_shared<LivePhoto>(ready_for_live(photo, progress));
  try {
    if (!drawings.empty()) {
      result.drawn = import_drawing(drawings.front(), photo, limits, progress);
    }
  } catch (const Error& error) {
    result.trouble = error.what();
  }
  return result;
}

std::vector<SourceFile> drawings_of(const Workspace& workspace, const std::string& photo) {
  std::vector<SourceFile> drawings;
  if (!workspace.capture) return drawings;
  for (const SourceFile& file : workspace.capture->scribbles) {
    if (file.name == photo) drawings.push_back(file);
  }
  return drawings;
}

void install(Workspace& workspace, const std::string& photo, Opened result) {
  MatteCanvas& canvas = workspace.matte.canvas;
  if (canvas.photo != photo) return;
  canvas.ready = std::move(result.ready);
  canvas.drawn = std::move(result.drawn);
  canvas.trouble = std::move(result.trouble);
  canvas.seen_session.reset();
}

void open_canvas(Workspace& workspace, const std::shared_ptr<const ImportedPhotos>& imported,
                 const std::string& name) {
  MatteCanvas fresh;
  fresh.photo = name;
  fresh.imported = imported;
  fresh.strokes_revision = workspace.matte.canvas.strokes_revision + 1;  // they never come again
  fresh.live_revision = workspace.matte.canvas.live_revision + 1;
  fresh.picture_revision = workspace.matte.canvas.picture_revision + 1;
  workspace.matte.canvas = std::move(fresh);
  workspace.jobs.start(
      "Opening " + name,
      [imported, name, drawings = drawings_of(workspace, name),
       limits = decode_limits(workspace.project().recipe.photo)](Progress& progress) {
        progress.begin("Opening " + name, 1);
        return opened(*find_photo(*imported, name), drawings, limits, progress);
      },
      [&workspace, name](Opened result) { install(workspace, name, std::move(result)); },
      Lane::interactive, "matte/open");
}

PixelBox whole_of(const MatteCanvas& canvas) {
  return {{0, 0}, {canvas.ready->full.srgb.width(), canvas.ready->full.srgb.height()}};
}

void restore_drawn(MatteCanvas& canvas, const PixelBox& box) {
  for (int y = box.from.y; y < box.to.y; ++y) {
    for (int x = box.from.x; x < box.to.x; ++x) {
      canvas.strokes(x, y) = canvas.drawn.empty() ? kNoStroke : canvas.drawn(x, y);
    }
  }
}

// The box in which two lists of strokes paint differently.
PixelBox changed_box(const std::vector<Stroke>& before, const std::vector<Stroke>& after,
                     const Photo& photo) {
  const auto [a, b] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  PixelBox box;
  for (auto stroke = a; stroke != before.end(); ++stroke) box = around(box, box_of(*stroke, photo));
  for (auto stroke = b; stroke != after.end(); ++stroke) box = around(box, box_of(*stroke, photo));
  return box;
}

// Brings the painted strokes to those of the project; the stroke in hand stays on top.
void follow_project(Workspace& workspace) {
  MatteCanvas& canvas = workspace.matte.canvas;
  const std::uint64_t revision = workspace.session->revision();
  if (canvas.seen_session == revision) return;
  const bool first = !canvas.seen_session;
  canvas.seen_session = revision;
  const Photo& photo = canvas.ready->full;
  const std::vector<Stroke>& wanted = strokes_on(workspace, canvas.photo);
  PixelBox box = first ? whole_of(canvas) : changed_box(canvas.painted, wanted, photo);
  if (first) canvas.strokes = {photo.srgb.width(), photo.srgb.height(), kNoStroke};
  canvas.painted = wanted;
  if (box.empty()) return;
  restore_drawn(canvas, box);
  std::vector<Stroke> all = wanted;
  if (workspace.matte.in_hand) all.push_back(*workspace.matte.in_hand);
  paint_strokes(all, photo, box, canvas.strokes);
  canvas.dirty = around(canvas.dirty, box);
  ++canvas.strokes_revision;
}

void start_live(Workspace& workspace, const LiveSource& source) {
  MatteCanvas& canvas = workspace.matte.canvas;
  canvas.live_asked = source;
  canvas.live_job = workspace.jobs.start(
      "Live matte of " + canvas.photo,
      [ready = canvas.ready, strokes = canvas.strokes,
       tilt = what_others_say(workspace.matte.review, canvas.photo),
       options = workspace.project().recipe.matte](Progress& progress) {
        return live_matte(*ready, strokes, tilt, options, progress);
      },
      [&workspace, source, photo = canvas.photo](LiveMatte live) {
        MatteCanvas& now = workspace.matte.canvas;
        if (now.photo != photo) return;
        now.live = std::move(live);
        now.live_of = source;
        ++now.live_revision;
      },
      Lane::interactive, "matte/live");
}

// While a stroke is drawn, live mattes follow one after the other; its end replaces the last.
void follow_strokes(Workspace& workspace) {
  MatteCanvas& canvas = workspace.matte.canvas;
  MatteOptions options = workspace.project().recipe.matte;
  const LiveSource source{canvas.strokes_revision, workspace.matte.review.revision,
                          values_text(describe(options))};
  if (source == canvas.live_asked) return;
  if (workspace.matte.in_hand && workspace.jobs.is_open(canvas.live_job)) return;
  start_live(workspace, source);
}

// Strokes hide what the other views are for, but a hand that paints must see where.
CanvasLook look_of(const Workspace& workspace, const Image<glm::vec4>*& matte) {
  CanvasLook look;
  look.view = workspace.matte.view;
  look.shown = shown_matte(workspace, matte);
  if (look.shown == ShownMatte::live) {
    look.live = workspace.matte.canvas.live_revision;
  } else {
    look.mattes = workspace.results.mattes;
  }
  look.strokes = look.view == MatteView::photo || look.view == MatteView::overlay ||
                 workspace.matte.in_hand.has_value();
  return look;
}

}  // namespace

void follow_canvas(Workspace& workspace) {
  MatteStepState& step = workspace.matte;
  if (step.canvas.photo != step.photo) keep_stroke_in_hand(workspace);  // on the photo it is on
  const auto& imported = workspace.results.imported;
  if (!imported || imported->photos.empty()) return;
  if (!find_photo(*imported, step.photo)) step.photo = imported->photos.front().name;
  if (step.canvas.photo != step.photo || step.canvas.imported != imported) {
    open_canvas(workspace, imported, step.photo);
  }
  if (!step.canvas.ready) return;
  follow_project(workspace);
  follow_strokes(workspace);
}

const std::vector<Stroke>& strokes_on(const Workspace& workspace, const std::string& photo) {
  static const std::vector<Stroke> none;
  const Strokes& all = workspace.project().strokes;
  const auto found = all.find(photo);
  return found == all.end() ? none : found->second;
}

const Photo* photo_on_canvas(const Workspace& workspace) {
  const MatteCanvas& canvas = workspace.matte.canvas;
  return canvas.ready ? &canvas.ready->full : nullptr;
}

ShownMatte shown_matte(const Workspace& workspace, const Image<glm::vec4>*& matte) {
  static const Image<glm::vec4> none;
  const MatteCanvas& canvas = workspace.matte.canvas;
  const Image<glm::vec4>* full = nullptr;
  if (workspace.results.mattes) {
    for (const Matte& one : *workspace.results.mattes) {
      if (one.name == canvas.photo) full = &one.rgba;
    }
  }
  const bool current =
      state_of(workspace, "matte") == StageState::current && !workspace.matte.in_hand;
  matte = full ? full : &none;
  if (full && current) return ShownMatte::full;
  if (!canvas.live.matte.rgba.empty()) {
    matte = &canvas.live.matte.rgba;
    return ShownMatte::live;
  }
  return full ? ShownMatte::outdated : ShownMatte::none;
}

void paint_on_canvas(Workspace& workspace, const Stroke& part) {
  MatteCanvas& canvas = workspace.matte.canvas;
  const PixelBox box = box_of(part, canvas.ready->full);
  paint_strokes({part}, canvas.ready->full, box, canvas.strokes);
  canvas.dirty = around(canvas.dirty, box);
  ++canvas.strokes_revision;
}

Texture canvas_texture(Workspace& workspace) {
  static const Image<std::uint8_t> no_strokes;
  MatteCanvas& canvas = workspace.matte.canvas;
  if (!canvas.ready || canvas.strokes.empty()) return {};
  const Image<glm::vec4>* matte = nullptr;
  const CanvasLook look = look_of(workspace, matte);
  const bool anew = canvas.picture.empty() || !(canvas.look == look);
  const PixelBox box = anew ? whole_of(canvas) : canvas.dirty;
  if (!box.empty()) {
    if (canvas.picture.empty()) canvas.picture = {box.to.x, box.to.y};
    const Image<std::uint8_t>& strokes = look.strokes ? canvas.strokes : no_strokes;
    repaint(look.view, {canvas.ready->full.srgb, *matte, strokes}, box, canvas.picture);
    ++canvas.picture_revision;
  }
  canvas.look = look;
  canvas.dirty = {};
  return workspace.pictures.show("matte/" + canvas.photo, canvas.picture_revision,
                                 [&] { return canvas.picture; });
}

}  // namespace bosk
