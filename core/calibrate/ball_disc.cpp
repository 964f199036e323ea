#include "core/calibrate/ball_disc.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/calibrate/ball_circle.h"
#include "core/calibrate/ball_colour.h"

namespace bosk {
namespace {

using glm::dvec2;
using glm::vec2;
using glm::vec3;

constexpr double kLeastContrast = 22.0;    // of saturation, ball against surroundings
constexpr double kLeastSaturation = 28.0;  // of the ball
constexpr double kLeastEdge = 0.45;        // share of the edge that lies on the circle
constexpr double kMostSpill = 0.30;        // share of the ball's colour right around it
constexpr double kMostCommon = 12.0;       // pixels of the ball's colour in the photo, in discs
constexpr double kHiddenSigma = 0.5;       // in radii, where the whole edge is hidden
constexpr int kRays = 40;
constexpr double kLeastEdgeSigma = 0.12;  // of an edge point, pixels

struct Colours {
  vec2 ball{0.0f}, around{0.0f};
  float lightness = 0.0f;  // median L* inside
};

float median(std::vector<float> values) {
  if (values.empty()) return 0.0f;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

vec2 median(const std::vector<vec2>& values) {
  std::vector<float> x, y;
  for (const vec2& value : values) {
    x.push_back(value.x);
    y.push_back(value.y);
  }
  return {median(std::move(x)), median(std::move(y))};
}

// Calls body(pixel, distance from the centre) for the pixels within `reach`.
template <class Body>
void for_pixels_around(const Image<vec3>& image, const dvec2& centre, double reach, Body&& body) {
  const int top = std::max(0, int(std::ceil(centre.y - reach)));
  const int bottom = std::min(image.height() - 1, int(std::floor(centre.y + reach)));
  const int left = std::max(0, int(std::ceil(centre.x - reach)));
  const int right = std::min(image.width() - 1, int(std::floor(centre.x + reach)));
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const double distance = glm::length(dvec2(x, y) - centre);
      if (distance <= reach) body(image(x, y), distance);
    }
}

// The surroundings' median; then the ball's, over the half of the inner pixels that stands off most
// from it: leaves may hide the rest.
Colours colours_at(const Image<vec3>& image, const dvec2& centre, double radius) {
  std::vector<vec2> inside, around;
  std::vector<float> lightness;
  for_pixels_around(image, centre, 2.4 * radius, [&](const vec3& value, double distance) {
    if (distance <= 0.75 * radius) {
      inside.emplace_back(value);
      lightness.push_back(value.z);
    }
    if (distance >= 1.5 * radius) around.emplace_back(value);
  });
  Colours colours;
  colours.around = median(around);
  colours.lightness = median(std::move(lightness));
  std::sort(inside.begin(), inside.end(), [&](const vec2& a, const vec2& b) {
    return glm::distance(a, colours.around) > glm::distance(b, colours.around);
  });
  inside.resize((inside.size() + 1) / 2);
  colours.ball = median(inside);
  return colours;
}

// Share of the ball in a colour, 0 to 1 and beyond; what lies far off the line between the ball's
// colour and the surroundings' is neither.
float share_of_ball(const vec3& value, const Colours& colours) {
  const vec2 step = colours.ball - colours.around;
  const vec2 off = vec2(value) - colours.around;
  const float along = glm::dot(off, step) / glm::dot(step, step);
  const float aside = std::abs(off.x * step.y - off.y * step.x) / glm::dot(step, step);
  return along - std::max(0.0f, aside - 0.25f);
}

// Where a ray from the centre leaves the ball for the last time; none when it never met it.
std::optional<double> last_edge(const Image<vec3>& image, const Colours& colours,
                                const dvec2& centre, const dvec2& direction, double reach) {
  constexpr double kStep = 0.25;
  std::optional<double> edge;
  float before = share_of_ball(sample_bilinear(image, centre), colours);
  for (double distance = kStep; distance <= reach; distance += kStep) {
    const float here =
        share_of_ball(sample_bilinear(image, centre + distance * direction), colours);
    if (before >= 0.5f && here < 0.5f)
      edge = distance - kStep * double((0.5f - here) / (before - here));
    before = here;
  }
  return edge;
}

dvec2 direction_of(int ray) {
  const double angle = 2.0 * std::numbers::pi * ray / kRays;
  return {std::cos(angle), std::sin(angle)};
}

std::vector<dvec2> edge_points(const Image<vec3>& image, const Colours& colours,
                               const dvec2& centre, double radius) {
  std::vector<dvec2> points;
  for (int ray = 0; ray < kRays; ++ray) {
    const dvec2 direction = direction_of(ray);
    if (const auto edge = last_edge(image, colours, centre, direction, 2.0 * radius))
      points.push_back(centre + *edge * direction);
  }
  return points;
}

// Share of the background in light that is p ball + q background, by least squares. A ball's own
// light falls off towards its dark limb, so p isn't 1 - q; that it roughly is decides only where
// the two are of nearly one colour.
double share_of_background(const vec3& light, const vec3& ball, const vec3& background) {
  constexpr float kNoise = 0.02f, kShading = 0.4f;
  constexpr float kWeight = kNoise * kNoise / (kShading * kShading);
  const float bb = glm::dot(ball, ball) + kWeight;
  const float bg = glm::dot(ball, background) + kWeight;
  const float gg = glm::dot(background, background) + kWeight;
  const float b = glm::dot(ball, light) + kWeight, g = glm::dot(background, light) + kWeight;
  return double((bb * g - bg * b) / std::max(bb * gg - bg * bg, 1e-9f));
}

// Where the ball ends along a ray, near a first guess: the length that isn't background, between
// the light just inside and that just outside. In saturation, dark ball and bright ground don't mix
// evenly. None where the ray doesn't go from the ball out into something else there.
std::optional<double> exact_edge(const BallImage& image, const Colours& colours,
                                 const dvec2& centre, const dvec2& direction, double guess) {
  const double reach = std::max(2.25, 0.15 * guess);
  constexpr int kSteps = 18;
  const auto share_at = [&](double distance) {
    return share_of_ball(sample_bilinear(image.saturation, centre + distance * direction), colours);
  };
  if (share_at(guess - reach) < 0.5f || share_at(guess + reach) > 0.4f) return {};
  const auto light = [&](double distance) {
    return sample_bilinear(image.linear, centre + distance * direction);
  };
  const vec3 inside = 0.5f * (light(guess - reach) + light(guess - reach + 0.5));
  const vec3 outside = 0.5f * (light(guess + reach) + light(guess + reach - 0.5));
  const double step = 2.0 * reach / kSteps;
  double covered = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const vec3 here = light(guess - reach + (i + 0.5) * step);
    covered += step * (1.0 - std::clamp(share_of_background(here, inside, outside), -0.2, 1.2));
  }
  return guess - reach + covered;
}

std::vector<dvec2> exact_edges(const BallImage& image, const Colours& colours,
                               const CircleFit& circle) {
  std::vector<dvec2> points;
  for (int ray = 0; ray < kRays; ++ray) {
    const dvec2 direction = direction_of(ray);
    if (const auto edge = exact_edge(image, colours, circle.centre, direction, circle.radius))
      points.push_back(circle.centre + *edge * direction);
  }
  return points;
}

// The circle through exact edges; the first of two rounds brings them within reach.
std::optional<CircleFit> exact_circle(const BallImage& image, const Colours& colours,
                                      CircleFit circle) {
  for (int round = 0; round < 2; ++round) {
    const auto fit = fit_circle(exact_edges(image, colours, circle), 0.7 * circle.radius,
                                1.4 * circle.radius, std::max(0.35, 0.06 * circle.radius));
    if (!fit) return {};
    circle = *fit;
  }
  return circle;
}

struct Cover {
  double inside = 0.0, around = 0.0;  // share of the ball's colour within and right around the disc
};

Cover cover_of(const Image<vec3>& image, const Colours& colours, const CircleFit& circle) {
  int inside = 0, inside_ball = 0, around = 0, around_ball = 0;
  const double rim = std::max(1.0, 0.15 * circle.radius);
  for_pixels_around(image, circle.centre, 1.35 * circle.radius + 1.5,
                    [&](const vec3& value, double distance) {
                      const bool is_ball = share_of_ball(value, colours) >= 0.5f;
                      if (distance <= circle.radius - 0.3) {
                        ++inside;
                        inside_ball += is_ball;
                      } else if (distance >= circle.radius + rim) {
                        ++around;
                        around_ball += is_ball;
                      }
                    });
  return {inside > 0 ? double(inside_ball) / inside : 0.0,
          around > 0 ? double(around_ball) / around : 1.0};
}

bool stands_off(const Colours& colours) {
  return glm::distance(colours.ball, colours.around) >= kLeastContrast &&
         glm::length(colours.ball) >= kLeastSaturation;
}

// Balls are few: their colour is hardly seen elsewhere, unlike that of leaves and flowers.
bool is_rare(const BallImage& image, const Colours& colours, double radius) {
  return common_pixels(image, colours.ball) <= kMostCommon * std::numbers::pi * radius * radius;
}

SightedBall ball_of(const CircleFit& circle, const Colours& colours, const Cover& cover) {
  SightedBall ball;
  ball.centre_px = circle.centre;
  ball.radius_px = circle.radius;
  ball.visible = cover.inside;
  ball.saturation = colours.ball;
  ball.lightness = colours.lightness;
  ball.contrast = double(glm::distance(colours.ball, colours.around));
  // Neighbouring edge points share pixels: about one in two is news where rays are a pixel apart.
  const double edge_px = 2.0 * std::numbers::pi * circle.radius;
  const double news = std::min(1.0, 0.5 * edge_px / kRays);
  const double fit_sigma =
      std::max(circle.rms, kLeastEdgeSigma) * circle.centre_sigma / std::sqrt(news);
  const double hidden = 1.0 - double(circle.inliers) / kRays;
  ball.sigma_px = std::hypot(1.5 * fit_sigma, kHiddenSigma * circle.radius * hidden * hidden);
  return ball;
}

}  // namespace

std::optional<SightedBall> measure_disc(const BallImage& image, const BallCandidate& candidate,
                                        double least_visible) {
  CircleFit circle;
  circle.centre = candidate.centre_px;
  circle.radius = candidate.radius_px;
  Colours colours;
  for (int round = 0; round < 3; ++round) {
    colours = colours_at(image.saturation, circle.centre, circle.radius);
    if (!stands_off(colours) || !is_rare(image, colours, circle.radius)) return {};
    const std::vector<dvec2> edge =
        edge_points(image.saturation, colours, circle.centre, circle.radius);
    const auto fit = fit_circle(edge, 0.5 * circle.radius, 1.7 * circle.radius,
                                std::max(0.6, 0.09 * circle.radius));
    if (!fit) return {};
    circle = *fit;
  }
  const auto exact = exact_circle(image, colours, circle);
  if (!exact || exact->inliers < kLeastEdge * kRays) return {};
  const Cover cover = cover_of(image.saturation, colours, *exact);
  if (cover.inside < least_visible || cover.around > kMostSpill) return {};
  return ball_of(*exact, colours, cover);
}

}  // namespace bosk
