#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "core/matte/strokes.h"

namespace bosk {

// Strokes in project.json. The places of a stroke are one text, as in SVG: "12.5,7 13,8.0625".
std::string points_text(const std::vector<glm::dvec2>& points_px);
// Throws Error when the text is none of these.
std::vector<glm::dvec2> points_of_text(std::string_view text);

// "background", "foreground", "erase", "left_out".
std::string kind_text(StrokeKind kind);
// Throws Error when there is no such kind.
StrokeKind kind_of_text(std::string_view text);

}  // namespace bosk
