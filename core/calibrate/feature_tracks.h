#pragma once

#include <span>
#include <vector>

#include "core/calibrate/feature_match.h"

namespace bosk {

struct TrackSighting {
  std::size_t photo = 0;
  int feature = 0;
};

// One point as several photos show it, each at most once.
using FeatureTrack = std::vector<TrackSighting>;

// Chains matches into tracks, by photo and feature; the longest come first. Chains that reach two
// features of one photo hold a wrong match somewhere and are left out.
std::vector<FeatureTrack> feature_tracks(std::span<const PhotoFeatures> photos,
                                         std::span<const FeatureMatches> matches);

}  // namespace bosk
