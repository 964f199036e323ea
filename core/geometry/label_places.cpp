#include "core/geometry/label_places.h"

#include <algorithm>
#include <array>

namespace bosk {
namespace {

constexpr double kPointShare = 0.9;  // of the gap; the rest is for rounding

struct Rectangle {
  glm::dvec2 least, most;
};

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.least.x < b.most.x && b.least.x < a.most.x && a.least.y < b.most.y &&
         b.least.y < a.most.y;
}

// The best first: to the right, as words are read on from the point.
std::array<Rectangle, 8> places_beside(const PointLabel& label, double gap) {
  const glm::dvec2 half = 0.5 * label.size;
  const glm::dvec2 aside = half + gap;
  // Of the middle of the words from the point, in units of `aside`
  constexpr glm::dvec2 kDirections[] = {{1, 0},   {-1, 0}, {1, -1}, {1, 1},
                                        {-1, -1}, {-1, 1}, {0, -1}, {0, 1}};
  std::array<Rectangle, 8> places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec2 middle = label.point + kDirections[i] * aside;
    places[i] = {middle - half, middle + half};
  }
  return places;
}

}  // namespace

std::vector<std::optional<glm::dvec2>> label_places(std::span<const PointLabel> labels, double gap,
                                                    const glm::dvec2& least,
                                                    const glm::dvec2& most) {
  std::vector<Rectangle> taken;
  const auto is_free = [&](const Rectangle& place) {
    return place.least.x >= least.x && place.least.y >= least.y && place.most.x <= most.x &&
           place.most.y <= most.y && std::none_of(taken.begin(), taken.end(), [&](const auto& one) {
             return overlap(place, one);
           });
  };
  const auto hides_a_point = [&](const Rectangle& place) {
    return std::any_of(labels.begin(), labels.end(), [&](const PointLabel& one) {
      return overlap(place, {one.point - kPointShare * gap, one.point + kPointShare * gap});
    });
  };
  std::vector<std::optional<glm::dvec2>> chosen;
  for (const PointLabel& label : labels) {
    const auto places = places_beside(label, gap);
    auto place = std::find_if(places.begin(), places.end(), [&](const Rectangle& one) {
      return is_free(one) && !hides_a_point(one);
    });
    if (place == places.end() && label.needed) {
      place = std::find_if(places.begin(), places.end(), is_free);
    }
    chosen.push_back(place == places.end() ? std::nullopt : std::optional(place->least));
    if (place != places.end()) taken.push_back(*place);
  }
  return chosen;
}

}  // namespace bosk
