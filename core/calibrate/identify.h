#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/calibrate/balls.h"
#include "core/calibrate/sightings.h"

namespace bosk {

// A ball as the photos together tell of it.
struct BallIdentity {
  std::string name;          // its colour's: "red", "light blue"; empty for one that is left out
  bool foot_counts = false;  // its stick is as long, in radii, as in the other photos
};

// `balls` runs beside the photos and their balls; `sentences` say what was left out and what to do.
struct BallNames {
  std::vector<std::vector<BallIdentity>> balls;
  std::vector<std::string> sentences;
};

// Groups the balls of all photos by colour, whatever the exposure of each photo, and names the
// groups. A colour that only one photo shows is left out, and so are balls that no colour tells
// apart, in every photo and with a sentence. `photos` and `photo_names` are equally many.
BallNames name_balls(std::span<const std::vector<SightedBall>> photos,
                     std::span<const std::string> photo_names);

// The name of the second sighting of a ball, its stick's foot: "red foot".
std::string foot_name(const std::string& ball);

// The sightings of one photo's balls and feet; `identities` beside the balls.
std::vector<Sighting> ball_sightings(std::span<const SightedBall> balls,
                                     std::span<const BallIdentity> identities);

}  // namespace bosk
