#include "core/calibrate/balls.h"

#include <algorithm>

#include "core/calibrate/ball_candidates.h"
#include "core/calibrate/ball_colour.h"
#include "core/calibrate/ball_disc.h"
#include "core/calibrate/ball_stick.h"
#include "core/image/pyramid.h"

namespace bosk {
namespace {

constexpr std::size_t kMostBlobs = 400;  // a level

// The same ball in an image twice as large, `levels` times.
SightedBall enlarged(SightedBall ball, int levels) {
  const double scale = double(1 << levels);
  ball.centre_px = (ball.centre_px + 0.5) * scale - 0.5;
  ball.radius_px *= scale;
  ball.sigma_px *= scale;
  if (ball.foot) {
    ball.foot->pixel = (ball.foot->pixel + 0.5) * scale - 0.5;
    ball.foot->sigma_px *= scale;
  }
  return ball;
}

bool overlap(const SightedBall& a, const SightedBall& b) {
  return glm::distance(a.centre_px, b.centre_px) < 0.7 * std::max(a.radius_px, b.radius_px);
}

// Of balls that lie on each other the one whose centre is surest.
std::vector<SightedBall> without_doubles(std::vector<SightedBall> balls) {
  std::stable_sort(balls.begin(), balls.end(), [](const SightedBall& a, const SightedBall& b) {
    return a.sigma_px / a.radius_px < b.sigma_px / b.radius_px;
  });
  std::vector<SightedBall> kept;
  for (const SightedBall& ball : balls)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const SightedBall& other) { return overlap(ball, other); }))
      kept.push_back(ball);
  return kept;
}

void find_in_level(const Image<glm::vec3>& srgb, int level, const BallOptions& options,
                   const Progress& progress, std::vector<SightedBall>& found) {
  const BallImage image = ball_image(srgb);
  for (const BallCandidate& blob : find_blobs(image.saturation, kMostBlobs)) {
    progress.check();
    const auto disc = measure_disc(image, blob, options.least_visible);
    if (!disc) continue;
    SightedBall whole = *disc;
    whole.foot = find_stick_foot(image, *disc);
    const SightedBall ball = enlarged(whole, level);
    const double diameter = 2.0 * ball.radius_px;
    if (diameter >= options.smallest_diameter_px && diameter <= options.largest_diameter_px)
      found.push_back(ball);
  }
}

}  // namespace

std::vector<SightedBall> find_balls(const Image<glm::vec3>& srgb, const BallOptions& options,
                                    const Progress& progress) {
  std::vector<SightedBall> found;
  Image<glm::vec3> image = srgb;
  for (int level = 0; options.largest_diameter_px >= 4.0 * (1 << level); ++level) {
    progress.check();
    find_in_level(image, level, options, progress, found);
    if (std::min(image.width(), image.height()) < 64) break;
    image = half_size_srgb(image);
  }
  std::vector<SightedBall> balls = without_doubles(std::move(found));
  std::stable_sort(balls.begin(), balls.end(), [](const SightedBall& a, const SightedBall& b) {
    return a.centre_px.x < b.centre_px.x;
  });
  return balls;
}

}  // namespace bosk
