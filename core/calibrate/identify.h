#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/calibrate/balls.h"
#include "core/calibrate/sightings.h"

namespace bosk {

// A ball's name is its colour's: "red", "light blue". `names` runs beside the photos and their
// balls; empty for a ball that was left out. `sentences` say what was left out and what to do.
struct BallNames {
  std::vector<std::vector<std::string>> names;
  std::vector<std::string> sentences;
};

// Groups the balls of all photos by colour, whatever the exposure of each photo, and names the
// groups. Balls that no colour tells apart are left out in every photo, with a sentence.
BallNames name_balls(std::span<const std::vector<SightedBall>> photos);

// The name of the second sighting of a ball, its stick's foot: "red foot".
std::string foot_name(const std::string& ball);

// The sightings of one photo's balls and feet; `names` beside the balls.
std::vector<Sighting> ball_sightings(std::span<const SightedBall> balls,
                                     std::span<const std::string> names);

}  // namespace bosk
