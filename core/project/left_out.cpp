#include "core/project/left_out.h"

#include <algorithm>

namespace bosk {
namespace {

// Blackens the pixels within the stroke, segment by segment.
void paint(const Stroke& stroke, const glm::dvec2& photo_from_mask, Image<std::uint8_t>& mask) {
  const auto& points = stroke.points_px;
  const glm::dvec2 last(mask.width() - 1, mask.height() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Stroke segment{stroke.kind, stroke.radius_px, {points[i == 0 ? 0 : i - 1], points[i]}};
    const auto [a, b] = std::pair(segment.points_px[0], segment.points_px[1]);
    const auto in_mask = [&](const glm::dvec2& place) {
      return glm::clamp((place + 0.5) / photo_from_mask - 0.5, glm::dvec2(0.0), last);
    };
    const glm::ivec2 from(glm::floor(in_mask(glm::min(a, b) - stroke.radius_px)));
    const glm::ivec2 to(glm::ceil(in_mask(glm::max(a, b) + stroke.radius_px)));
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) {
        if (covers(segment, (glm::dvec2(x, y) + 0.5) * photo_from_mask - 0.5)) mask(x, y) = 0;
      }
    }
  }
}

}  // namespace

Image<std::uint8_t> mask_of(const std::vector<Stroke>& left_out, const glm::ivec2& photo_px,
                            const glm::ivec2& mask_px) {
  Image<std::uint8_t> mask(mask_px.x, mask_px.y, 255);
  for (const Stroke& stroke : left_out) {
    paint(stroke, glm::dvec2(photo_px) / glm::dvec2(mask_px), mask);
  }
  return mask;
}

void leave_out(const std::vector<Stroke>& left_out, PhotoSightings& photo) {
  std::erase_if(photo.sightings, [&](const Sighting& sighting) {
    return sighting.by != SightedBy::click &&
           std::any_of(left_out.begin(), left_out.end(),
                       [&](const Stroke& stroke) { return covers(stroke, sighting.pixel); });
  });
}

void hash_left_out(ContentHasher& hasher, const Strokes& left_out) {
  hasher.value(std::uint64_t(left_out.size()));
  for (const auto& [photo, strokes] : left_out) {
    hasher.text(photo).value(std::uint64_t(strokes.size()));
    for (const Stroke& stroke : strokes) {
      hasher.value(stroke.radius_px).value(std::uint64_t(stroke.points_px.size()));
      for (const glm::dvec2& point : stroke.points_px) hasher.value(point.x).value(point.y);
    }
  }
}

}  // namespace bosk
