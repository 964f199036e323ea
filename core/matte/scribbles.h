#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/image/image.h"
#include "core/photo/photo.h"

namespace bosk {

constexpr std::uint8_t kForegroundStroke = 255;
constexpr std::uint8_t kBackgroundStroke = 0;
constexpr std::uint8_t kNoStroke = 128;

// Strokes by photo name, at the photo's working size and pinhole geometry; the three values above.
using Scribbles = std::map<std::string, Image<std::uint8_t>>;

// Strokes as they were drawn over the original (distorted) photo, moved into the working photo,
// each pixel from its nearest. `drawn` may be a scaled copy of the original. Values far from white,
// black and middle grey (edges that a paint program softened) and what lies outside become unknown.
// Throws Error naming `file` when the shape does not fit the photo.
Image<std::uint8_t> drawing_in_photo(const Image<std::uint8_t>& drawn, const Photo& photo,
                                     const std::string& file);

bool has_kind(const Image<std::uint8_t>& strokes, std::uint8_t kind);
bool has_both_kinds(const Image<std::uint8_t>& strokes);

// Throws Error naming `file` unless there are strokes of both kinds.
void require_both_kinds(const Image<std::uint8_t>& strokes, const std::string& file);

}  // namespace bosk
