#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "core/calibrate/ball_candidates.h"
#include "core/calibrate/ball_colour.h"
#include "core/calibrate/balls.h"

namespace bosk {

// The disc at a candidate, by its own colour against that around it: the edge is where half of a
// pixel's light is the ball's, and a circle fitted to it. None for what is no disc: too few of its
// edge on one circle, holes, its colour right around it, or all over the photo.
std::optional<SightedBall> measure_disc(const BallImage& image, const BallCandidate& candidate,
                                        double least_visible);

}  // namespace bosk
