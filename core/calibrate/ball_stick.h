#pragma once

#include <optional>

#include "core/calibrate/ball_colour.h"
#include "core/calibrate/balls.h"

namespace bosk {

// The foot of the stick below a ball: the ridge of one colour that goes down from it, at most 12
// degrees off the vertical, is followed to where it ends. None where no stick stands off from both
// sides, or its end lies outside the photo. A leaf that hides the foot may end it early: compare
// the photos (name_balls does).
std::optional<StickFoot> find_stick_foot(const BallImage& image, const SightedBall& ball);

}  // namespace bosk
