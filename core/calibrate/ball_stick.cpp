#include "core/calibrate/ball_stick.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace bosk {
namespace {

using glm::dvec2;
using glm::vec3;

constexpr double kMostLean = 0.21;      // tangent of the angle to the vertical
constexpr double kLongest = 16.0;       // in radii of the ball
constexpr double kShortest = 1.2;       // below the ball's edge
constexpr float kLeastContrast = 4.0f;  // of saturation
constexpr float kLeastLight = 0.02f;    // of linear light, for the exact end
constexpr float kLightnessWeight = 0.7f;

// A line down from a ball: x = top.x + lean (y - top.y).
struct Line {
  dvec2 top{0.0};
  double lean = 0.0;

  double x_at(double y) const { return top.x + lean * (y - top.y); }
};

// How a stick's colour differs from that on both sides, row by row below the ball.
struct Ridge {
  Line line;
  double half_width = 1.0;
  std::vector<vec3> difference;  // one a row, from line.top.y on
};

// Saturation counts fully: it is one in sun and in shade. Lightness counts little, since the ground
// behind a sunlit stick may be lit or not.
vec3 colour_across(const BallImage& image, double x, double y, double half_width) {
  const vec3 sum = sample_bilinear(image.saturation, {x - 0.5 * half_width, y}) +
                   sample_bilinear(image.saturation, {x + 0.5 * half_width, y});
  return 0.5f * sum * vec3(1.0f, 1.0f, kLightnessWeight);
}

vec3 light_across(const BallImage& image, double x, double y, double half_width) {
  return 0.5f * (sample_bilinear(image.linear, {x - 0.5 * half_width, y}) +
                 sample_bilinear(image.linear, {x + 0.5 * half_width, y}));
}

using Across = vec3 (*)(const BallImage&, double x, double y, double half_width);

Ridge ridge_along(const BallImage& image, const Line& line, double half_width, int rows,
                  Across across) {
  Ridge ridge{line, half_width, {}};
  const double aside = 2.0 * half_width + 1.5;
  for (int row = 0; row < rows; ++row) {
    const double y = line.top.y + row, x = line.x_at(y);
    const vec3 sides =
        0.5f * (across(image, x - aside, y, half_width) + across(image, x + aside, y, half_width));
    ridge.difference.push_back(across(image, x, y, half_width) - sides);
  }
  return ridge;
}

vec3 mean_of(std::span<const vec3> values) {
  vec3 sum(0.0f);
  for (const vec3& value : values) sum += value;
  return sum / float(values.size());
}

// Each row's difference as a share of the stick's own, which the first rows show.
std::vector<double> shares(const Ridge& ridge, const vec3& stick) {
  std::vector<double> result;
  for (const vec3& difference : ridge.difference)
    result.push_back(
        std::clamp(double(glm::dot(difference, stick) / glm::dot(stick, stick)), -1.0, 2.0));
  return result;
}

struct End {
  int row = 0;
  double score = 0.0;  // rows of stick seen, less rows missing
};

// The row up to which "is stick" explains the rows best.
End end_of(const std::vector<double>& share) {
  End best;
  double sum = 0.0;
  for (std::size_t row = 0; row < share.size(); ++row) {
    sum += share[row] - 0.5;
    if (sum > best.score) best = {int(row) + 1, sum};
  }
  return best;
}

struct Stick {
  Ridge ridge;
  vec3 difference{0.0f};
  End end;
};

// The stick's colour is not known: it is that of the first rows, then that of all of its rows.
std::optional<Stick> follow(const BallImage& image, const Line& line, double half_width, int rows,
                            std::size_t first_rows) {
  Stick stick{ridge_along(image, line, half_width, rows, colour_across), {}, {}};
  std::size_t count = first_rows;
  for (int round = 0; round < 2; ++round) {
    stick.difference = mean_of(std::span(stick.ridge.difference).first(count));
    if (glm::length(stick.difference) < kLeastContrast) return {};
    stick.end = end_of(shares(stick.ridge, stick.difference));
    if (stick.end.row < int(first_rows)) return {};
    count = std::size_t(stick.end.row);
  }
  return stick;
}

std::optional<Stick> best_stick(const BallImage& image, const SightedBall& ball) {
  const double top = std::ceil(ball.centre_px.y + 1.15 * ball.radius_px + 1.0);
  const int rows = int(std::min(kLongest * ball.radius_px, image.linear.height() - 3.0 - top));
  const std::size_t first_rows = std::size_t(std::max(4.0, kShortest * ball.radius_px));
  if (rows < int(first_rows) + 3) return {};
  std::optional<Stick> best;
  for (double half_width : {0.06, 0.11}) {
    const double half = std::max(0.6, half_width * ball.radius_px);
    for (double lean = -kMostLean; lean <= kMostLean; lean += 0.015)
      for (double off = -0.15; off <= 0.151; off += 0.05) {
        const Line line{
            {ball.centre_px.x + off * ball.radius_px + lean * (top - ball.centre_px.y), top}, lean};
        const auto stick = follow(image, line, half, rows, first_rows);
        if (!stick) continue;
        const double strength = stick->end.score * glm::length(stick->difference);
        if (!best || strength > best->end.score * double(glm::length(best->difference)))
          best = stick;
      }
  }
  return best;
}

// The end to a part of a row: rows of stick around it, counted by their shares. In linear light
// where that tells stick from ground, since a JPEG's colours are blurred.
double exact_end(const BallImage& image, const Stick& stick) {
  const int rows = int(stick.ridge.difference.size()), end = stick.end.row;
  Ridge ridge = ridge_along(image, stick.ridge.line, stick.ridge.half_width, rows, light_across);
  const int last = std::max(1, end - 1), first = std::max(0, last - 6);
  vec3 difference =
      mean_of(std::span(ridge.difference).subspan(std::size_t(first), std::size_t(last - first)));
  if (glm::length(difference) < kLeastLight) {
    ridge = stick.ridge;
    difference = stick.difference;
  }
  const std::vector<double> share = shares(ridge, difference);
  const int from = std::max(0, end - 3), to = std::min(rows, end + 3);
  double sum = 0.0;
  for (int row = from; row < to; ++row) sum += std::clamp(share[std::size_t(row)], 0.0, 1.0);
  return from + sum - 0.5;
}

// A stick is seen over nearly all of its length, and nothing like it goes on below.
bool is_clear(const std::vector<double>& share, int end) {
  int seen = 0;
  for (int row = 0; row < end; ++row) seen += share[std::size_t(row)] > 0.5;
  return seen >= 0.8 * end && end + 3 <= int(share.size());
}

}  // namespace

std::optional<StickFoot> find_stick_foot(const BallImage& image, const SightedBall& ball) {
  const auto stick = best_stick(image, ball);
  if (!stick) return {};
  const std::vector<double> share = shares(stick->ridge, stick->difference);
  if (!is_clear(share, stick->end.row)) return {};
  StickFoot foot;
  const Line& line = stick->ridge.line;
  foot.pixel.y = line.top.y + exact_end(image, *stick);
  foot.pixel.x = line.x_at(foot.pixel.y);
  foot.sigma_px = 0.7;
  return foot;
}

}  // namespace bosk
