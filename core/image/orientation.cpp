#include "core/image/orientation.h"

namespace bosk {
namespace {

// Upright, x and y may be swapped and then each may run backwards.
struct Turn {
  bool swapped = false, x_back = false, y_back = false;
};

Turn turn_of(int orientation) {
  switch (orientation) {
    case 2:
      return {false, true, false};
    case 3:
      return {false, true, true};
    case 4:
      return {false, false, true};
    case 5:
      return {true, false, false};
    case 6:
      return {true, true, false};
    case 7:
      return {true, true, true};
    case 8:
      return {true, false, true};
    default:
      return {};
  }
}

glm::dvec2 swapped_if(bool swap, const glm::dvec2& place) {
  return swap ? glm::dvec2(place.y, place.x) : place;
}

// An involution: backwards twice is forwards.
glm::dvec2 run_back(const Turn& turn, const glm::dvec2& upright, const glm::ivec2& shown) {
  return {turn.x_back ? shown.x - 1 - upright.x : upright.x,
          turn.y_back ? shown.y - 1 - upright.y : upright.y};
}

}  // namespace

glm::ivec2 upright_size(const glm::ivec2& size, int orientation) {
  return turn_of(orientation).swapped ? glm::ivec2(size.y, size.x) : size;
}

glm::dvec2 upright_from_pixel(const glm::dvec2& pixel, const glm::ivec2& size, int orientation) {
  const Turn turn = turn_of(orientation);
  return run_back(turn, swapped_if(turn.swapped, pixel), upright_size(size, orientation));
}

glm::dvec2 pixel_from_upright(const glm::dvec2& upright, const glm::ivec2& size, int orientation) {
  const Turn turn = turn_of(orientation);
  return swapped_if(turn.swapped, run_back(turn, upright, upright_size(size, orientation)));
}

std::array<glm::vec2, 4> corner_textures(int orientation) {
  const glm::ivec2 unit(2, 2);  // its pixels' centres are the corners
  const auto at = [&](double x, double y) {
    return glm::vec2(pixel_from_upright({x, y}, unit, orientation));
  };
  return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
}

}  // namespace bosk
