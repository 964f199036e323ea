#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/project/edit.h"

namespace bosk {

// An edit in a journal, little-endian; texts are [bytes u64][bytes], lists [count u64][items]:
//
//   [0 u8] option:  name, before, after
//   [1 u8] photos:  list of texts before, list after
//   [2 u8] files:   [FileKind u8] before, after
//   [3 u8] stroke:  photo, stroke
//   [4 u8] clear:   photo, list of strokes before
//   [5 u8] options: what, list of options as above
//   [6 u8] sighting:     photo, point, place before, place after
//   [7 u8] sightings:    what, list of sightings as above
//   [8 u8] measurements: before, after
//
//   stroke: [StrokeKind u8][radius i32][list of places: x i32, y i32], all in 1/16 px
//   place: [0 u8] nothing said, [1 u8] not there, or [2 u8][x f64][y f64] px
//   measurements: list of tapes: from, to, [length f64][sigma f64]; list of heights: point,
//     [height f64][sigma f64]; list of points: point, [x f64][y f64][z f64][sigma f64]; metres
std::vector<std::byte> bytes_of_edit(const Edit& edit);
// Throws Error when the bytes are no such edit, to the last one.
Edit edit_of_bytes(std::span<const std::byte> bytes);

}  // namespace bosk
