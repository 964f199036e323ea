#include "core/project/stroke_text.h"

#include <array>
#include <charconv>
#include <string>

#include "core/base/error.h"

namespace bosk {
namespace {

constexpr std::array<const char*, 4> kKinds{"background", "foreground", "erase", "left_out"};

void add_number(double number, std::string& text) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

// Takes a number and what has to follow it off the text.
double take_number(std::string_view& text, char follower) {
  double number = 0.0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(std::size_t(end - text.data()));
  const bool followed = text.empty() ? follower == ' ' : text.front() == follower;
  if (failure != std::errc() || !followed) throw Error("the places of a stroke are damaged");
  if (!text.empty()) text.remove_prefix(1);
  return number;
}

}  // namespace

std::string points_text(const std::vector<glm::dvec2>& points_px) {
  std::string text;
  for (const glm::dvec2& point : points_px) {
    if (!text.empty()) text += ' ';
    add_number(point.x, text);
    text += ',';
    add_number(point.y, text);
  }
  return text;
}

std::vector<glm::dvec2> points_of_text(std::string_view text) {
  std::vector<glm::dvec2> points_px;
  while (!text.empty()) {
    const double x = take_number(text, ',');
    points_px.emplace_back(x, take_number(text, ' '));
  }
  return points_px;
}

std::string kind_text(StrokeKind kind) { return kKinds[std::size_t(kind)]; }

StrokeKind kind_of_text(std::string_view text) {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (text == kKinds[i]) return StrokeKind(i);
  }
  throw Error("there is no such kind of stroke");
}

}  // namespace bosk
