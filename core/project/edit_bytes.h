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
//
//   stroke: [StrokeKind u8][radius i32][list of places: x i32, y i32], all in 1/16 px
std::vector<std::byte> bytes_of_edit(const Edit& edit);
// Throws Error when the bytes are no such edit, to the last one.
Edit edit_of_bytes(std::span<const std::byte> bytes);

}  // namespace bosk
