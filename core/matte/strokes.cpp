#include "core/matte/strokes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/matte/scribbles.h"

namespace bosk {
namespace {

using glm::dvec2;

constexpr int kTilePx = 16;  // edge of the squares of working pixels that are passed over whole
constexpr std::size_t kRunPoints = 16;  // points that share a box

// Never -0, which would be another stroke to a hash.
double rounded(double number) { return std::round(number / kStrokeStepPx) * kStrokeStepPx + 0.0; }

double checked(double number, double minimum, double maximum, const char* what) {
  if (number >= minimum && number <= maximum) return rounded(number);  // false for NaN
  throw Error(std::string("a stroke's ") + what + " is out of range; draw it again");
}

// Part of a stroke's line: a polyline of its own, in the photo as taken.
struct Run {
  std::span<const dvec2> points;
  double radius_px = 0.0;
  std::uint8_t value = kNoStroke;
  dvec2 low{0.0}, high{0.0};  // box around all that is within the radius
};

std::uint8_t value_of(StrokeKind kind) {
  if (kind == StrokeKind::erase) return kNoStroke;
  return kind == StrokeKind::foreground ? kForegroundStroke : kBackgroundStroke;
}

Run run_of(const Stroke& stroke, std::span<const dvec2> points) {
  Run run{points, stroke.radius_px, value_of(stroke.kind), points.front(), points.front()};
  for (const dvec2& point : points) {
    run.low = glm::min(run.low, point);
    run.high = glm::max(run.high, point);
  }
  run.low -= stroke.radius_px;
  run.high += stroke.radius_px;
  return run;
}

// Neighbours share a point, so that no segment is lost.
void add_runs(const Stroke& stroke, std::vector<Run>& runs) {
  const std::span<const dvec2> points(stroke.points_px);
  if (points.empty() || stroke.kind == StrokeKind::left_out) return;
  for (std::size_t first = 0; first == 0 || first + 1 < points.size(); first += kRunPoints - 1) {
    runs.push_back(
        run_of(stroke, points.subspan(first, std::min(kRunPoints, points.size() - first))));
  }
}

double squared_distance(const dvec2& place, const dvec2& from, const dvec2& to) {
  const dvec2 along = to - from, offset = place - from;
  const double length2 = glm::dot(along, along);
  const double share =
      length2 > 0.0 ? std::clamp(glm::dot(offset, along) / length2, 0.0, 1.0) : 0.0;
  const dvec2 rest = offset - share * along;
  return glm::dot(rest, rest);
}

bool is_within(double radius_px, std::span<const dvec2> line, const dvec2& place) {
  const double radius2 = radius_px * radius_px;
  if (line.size() == 1) return squared_distance(place, line[0], line[0]) <= radius2;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (squared_distance(place, line[i - 1], line[i]) <= radius2) return true;
  }
  return false;
}

bool covers(const Run& run, const dvec2& place) {
  if (place.x < run.low.x || place.y < run.low.y || place.x > run.high.x || place.y > run.high.y) {
    return false;
  }
  return is_within(run.radius_px, run.points, place);
}

// Where a working pixel lies in the photo as taken; none outside of it.
std::optional<dvec2> original_place(const Photo& photo, const dvec2& pixel) {
  const Lens& original = photo.original_camera.lens;
  const auto place = taken_place(photo, pixel);
  if (!place || place->x < -0.5 || place->y < -0.5 || place->x >= original.width_px - 0.5 ||
      place->y >= original.height_px - 0.5) {
    return std::nullopt;
  }
  return place;
}

struct Tile {
  int x = 0, y = 0, end_x = 0, end_y = 0;  // working pixels
  // Circle in the photo as taken that holds all of the tile.
  dvec2 centre{0.0};
  double radius_px = std::numeric_limits<double>::infinity();
};

// From nine places of the tile; where a lens gives one of them no answer, the tile counts as
// everywhere. Over so few pixels a lens is nearly linear: a quarter more than the furthest of the
// nine is plenty.
Tile tile_at(int x, int y, const PixelBox& box, const Photo& photo) {
  Tile tile;
  tile.x = x;
  tile.y = y;
  tile.end_x = std::min(x + kTilePx, box.to.x);
  tile.end_y = std::min(y + kTilePx, box.to.y);
  const auto place = [&](int i, int k) {
    const dvec2 pixel(tile.x + 0.5 * i * (tile.end_x - 1 - tile.x),
                      tile.y + 0.5 * k * (tile.end_y - 1 - tile.y));
    return taken_place(photo, pixel);
  };
  const auto centre = place(1, 1);
  if (!centre) return tile;
  double furthest = 0.0;
  for (int i = 0; i < 9; ++i) {
    const auto there = place(i % 3, i / 3);
    if (!there) return tile;
    furthest = std::max(furthest, glm::distance(*there, *centre));
  }
  tile.centre = *centre;
  tile.radius_px = 1.25 * furthest + 1.0;
  return tile;
}

bool may_touch(const Run& run, const Tile& tile) {
  const dvec2 nearest = glm::clamp(tile.centre, run.low, run.high);
  const dvec2 offset = nearest - tile.centre;
  return glm::dot(offset, offset) <= tile.radius_px * tile.radius_px;
}

// The tile's pixels that no later stroke has decided yet.
struct OpenPixel {
  int x = 0, y = 0;
  dvec2 place{0.0};
};

std::vector<OpenPixel> pixels_of(const Tile& tile, const Photo& photo) {
  std::vector<OpenPixel> pixels;
  pixels.reserve(kTilePx * kTilePx);
  for (int y = tile.y; y < tile.end_y; ++y) {
    for (int x = tile.x; x < tile.end_x; ++x) {
      if (const auto place = original_place(photo, {x, y})) pixels.push_back({x, y, *place});
    }
  }
  return pixels;
}

// The last stroke first: what it covers needs no look at those before it.
void paint_tile(const Tile& tile, const std::vector<Run>& runs, const Photo& photo,
                Image<std::uint8_t>& scribbles) {
  std::optional<std::vector<OpenPixel>> open;
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
    if (!may_touch(*run, tile)) continue;
    if (!open) open = pixels_of(tile, photo);
    if (open->empty()) return;
    std::erase_if(*open, [&](const OpenPixel& pixel) {
      if (!covers(*run, pixel.place)) return false;
      scribbles(pixel.x, pixel.y) = run->value;
      return true;
    });
  }
}

std::vector<Run> runs_of(const std::vector<Stroke>& strokes) {
  std::vector<Run> runs;
  for (const Stroke& stroke : strokes) add_runs(stroke, runs);
  return runs;
}

void fit(const Photo& photo, Image<std::uint8_t>& scribbles) {
  const Lens& working = photo.camera.lens;
  if (scribbles.empty()) scribbles = {working.width_px, working.height_px, kNoStroke};
  assert(scribbles.width() == working.width_px && scribbles.height() == working.height_px);
}

PixelBox whole_of(const Photo& photo) {
  return {{0, 0}, {photo.camera.lens.width_px, photo.camera.lens.height_px}};
}

// Calls work(tile) for the tiles of the box, from several threads.
template <class Work>
void for_each_tile(const Photo& photo, const PixelBox& box, Work&& work) {
  const PixelBox inside = overlap(box, whole_of(photo));
  if (inside.empty()) return;
  const int rows = (inside.to.y - inside.from.y + kTilePx - 1) / kTilePx;
  tbb::parallel_for(0, rows, [&](int row) {
    for (int x = inside.from.x; x < inside.to.x; x += kTilePx) {
      work(tile_at(x, inside.from.y + row * kTilePx, inside, photo));
    }
  });
}

// Working pixels about a disc in the photo as taken, some too many, since lenses bend its edge;
// none where a lens gives no answer.
std::optional<PixelBox> box_of_disc(const dvec2& centre, double radius_px, const Photo& photo) {
  constexpr double kEdge = 2.0, kFar = 1e8;  // the latter is what an int can hold
  const double r = 1.1 * radius_px;
  PixelBox box;
  for (const dvec2& offset : {dvec2(r, 0.0), dvec2(-r, 0.0), dvec2(0.0, r), dvec2(0.0, -r)}) {
    const auto place = working_place(photo, centre + offset);
    if (!place) return std::nullopt;
    const dvec2 kept = glm::clamp(*place, dvec2(-kFar), dvec2(kFar));
    box = around(box, {glm::ivec2(glm::floor(kept - kEdge)), glm::ivec2(glm::ceil(kept + kEdge))});
  }
  return box;
}

}  // namespace

Stroke rounded_stroke(Stroke stroke) {
  if (stroke.points_px.empty() || stroke.points_px.size() > kMaxStrokePoints) {
    throw Error("a stroke has " + std::to_string(stroke.points_px.size()) + " points; 1 to " +
                std::to_string(kMaxStrokePoints) + " are possible");
  }
  stroke.radius_px = checked(stroke.radius_px, kStrokeStepPx, kMaxStrokeRadiusPx, "radius");
  for (dvec2& point : stroke.points_px) {
    for (int i = 0; i < 2; ++i) {
      point[i] = checked(point[i], -kMaxStrokePlacePx, kMaxStrokePlacePx, "place");
    }
  }
  return stroke;
}

bool covers(const Stroke& stroke, const dvec2& place) {
  return is_within(stroke.radius_px, stroke.points_px, place);
}

std::optional<dvec2> taken_place(const Photo& photo, const dvec2& working_px) {
  const Lens& working = photo.camera.lens;
  return pixel_from_camera(photo.original_camera.lens,
                           {(working_px - working.principal_px) / working.focal_px, 1.0});
}

std::optional<dvec2> working_place(const Photo& photo, const dvec2& taken_px) {
  const auto direction = camera_from_pixel(photo.original_camera.lens, taken_px);
  return direction ? pixel_from_camera(photo.camera.lens, *direction) : std::nullopt;
}

double taken_px_per_working_px(const Photo& photo) {
  return photo.original_camera.lens.focal_px.x / photo.camera.lens.focal_px.x;
}

// Of discs along its line, close enough that what a lens bends between two of them is within the
// two pixels more that each is given.
PixelBox box_of(const Stroke& stroke, const Photo& photo) {
  const double piece_px = photo.original_camera.lens.width_px / 32.0;
  PixelBox box;
  for (std::size_t i = 0; i < stroke.points_px.size(); ++i) {
    const dvec2 from = stroke.points_px[i == 0 ? 0 : i - 1], to = stroke.points_px[i];
    const double pieces = std::clamp(std::ceil(glm::distance(from, to) / piece_px), 1.0, 64.0);
    for (double k = 1.0; k <= pieces; ++k) {
      const auto disc = box_of_disc(glm::mix(from, to, k / pieces), stroke.radius_px, photo);
      if (!disc) return whole_of(photo);
      box = around(box, *disc);
    }
  }
  return overlap(box, whole_of(photo));
}

void paint_strokes(const std::vector<Stroke>& strokes, const Photo& photo,
                   Image<std::uint8_t>& scribbles) {
  paint_strokes(strokes, photo, whole_of(photo), scribbles);
}

void paint_strokes(const std::vector<Stroke>& strokes, const Photo& photo, const PixelBox& box,
                   Image<std::uint8_t>& scribbles) {
  fit(photo, scribbles);
  const std::vector<Run> runs = runs_of(strokes);
  if (runs.empty()) return;
  for_each_tile(photo, box, [&](const Tile& tile) { paint_tile(tile, runs, photo, scribbles); });
}

}  // namespace bosk
