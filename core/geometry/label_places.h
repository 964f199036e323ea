#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace bosk {

// Words beside a point of a picture, y down.
struct PointLabel {
  glm::dvec2 point{0.0};
  glm::dvec2 size{0.0};  // of the words
  bool needed = false;   // rather over another point than not at all
};

// For each label the corner of its words with the least x and y, `gap` beside its point, so that
// all words lie between `least` and `most` and none covers others or a point. Those that come first
// choose first; none: there is no room.
std::vector<std::optional<glm::dvec2>> label_places(std::span<const PointLabel> labels, double gap,
                                                    const glm::dvec2& least,
                                                    const glm::dvec2& most);

}  // namespace bosk
