#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/image/pixel_box.h"
#include "core/photo/photo.h"

namespace bosk {

// What is left out counts in no matte: calibration passes over it (sky, people, cars).
enum class StrokeKind : std::uint8_t { background, foreground, erase, left_out };

// One sweep of a brush over a photo as it was taken: pixels of original_camera's lens and size,
// (0, 0) the centre of the first. A stroke of one point is a disc. Erasing makes unknown again what
// lies under it, whether strokes or a drawing told it.
struct Stroke {
  StrokeKind kind = StrokeKind::foreground;
  double radius_px = 10.0;  // 1/16 to kMaxStrokeRadiusPx
  std::vector<glm::dvec2> points_px;

  bool operator==(const Stroke&) const = default;
};

// In the order drawn, by the photo's name; photos without strokes are left out.
using Strokes = std::map<std::string, std::vector<Stroke>>;

inline constexpr std::size_t kMaxStrokePoints = 100'000;
inline constexpr double kMaxStrokeRadiusPx = 100'000;
inline constexpr double kMaxStrokePlacePx = 1e6;   // of a point, either side of zero
inline constexpr double kStrokeStepPx = 1.0 / 16;  // of what is kept: places and radii

// The stroke as it is kept: places and radius rounded to 1/16 px. Throws Error when it has no
// points, more than kMaxStrokePoints, or a number that is out of range or none.
Stroke rounded_stroke(Stroke stroke);

// Paints the strokes of a matte, later ones over earlier, into working pixels (values of
// scribbles.h): each pixel whose place in the photo as taken is no further than the radius from the
// stroke's line. A stroke thinner than a working pixel may pass between their centres. `scribbles`
// has the working photo's size, or is empty and is made so, unknown everywhere.
void paint_strokes(const std::vector<Stroke>& strokes, const Photo& photo,
                   Image<std::uint8_t>& scribbles);
// The same within a box of working pixels; the others stay.
void paint_strokes(const std::vector<Stroke>& strokes, const Photo& photo, const PixelBox& box,
                   Image<std::uint8_t>& scribbles);

// A box of working pixels that holds all that the stroke paints, within the photo.
PixelBox box_of(const Stroke& stroke, const Photo& photo);

// Whether the place, in the same pixels as the stroke, is no further than the radius from its line.
bool covers(const Stroke& stroke, const glm::dvec2& place);

// Where a place in the photo as taken is in its working pixels, and back; none where a lens gives
// no answer.
std::optional<glm::dvec2> working_place(const Photo& photo, const glm::dvec2& taken_px);
std::optional<glm::dvec2> taken_place(const Photo& photo, const glm::dvec2& working_px);
// How many pixels of the photo as taken a working pixel is wide, in the middle.
double taken_px_per_working_px(const Photo& photo);

}  // namespace bosk
