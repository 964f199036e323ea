#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>

namespace bosk {

// The name of a point in a drawing.
struct SvgLabel {
  glm::dvec2 point{0.0};
  std::string words;
  std::string colour;
  bool needed = false;  // as of PointLabel
};

// SVG text for each label that has room, those that come first before others; words are `gap`
// beside their point and lie between `least` and `most`. In the drawing's units.
std::string svg_labels(std::span<const SvgLabel> labels, double text_height, double gap,
                       const glm::dvec2& least, const glm::dvec2& most);

}  // namespace bosk
