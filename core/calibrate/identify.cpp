#include "core/calibrate/identify.h"

namespace bosk {

BallNames name_balls(std::span<const std::vector<SightedBall>> photos) {
  BallNames names;
  for (const auto& balls : photos) names.names.emplace_back(balls.size());
  return names;
}

}  // namespace bosk
