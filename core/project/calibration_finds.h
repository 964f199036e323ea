#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/lens_solve.h"
#include "core/calibrate/solve.h"
#include "core/project/cache.h"
#include "core/project/calibration_sources.h"

namespace bosk {

// What could not be taken from a photo, and why.
struct UnreadPhoto {
  std::string photo, reason;
};

// All that the photos show by themselves, whatever a person told: what a solve starts from.
struct CalibrationFinds {
  std::vector<PhotoSightings> photos;  // of those that could be read, by name; balls are named
  std::vector<UnreadPhoto> unread;
  std::vector<RigidBody> bodies;               // printed markers of known size, a board at the tree
  LensKnowledge lens;                          // at the size that most photos have
  std::optional<LensCalibration> boards;       // where there are photos of a board
  std::vector<FirstPose> first_poses;          // from features
  std::vector<std::string> sentences;          // what went wrong, with the remedy
  std::vector<std::string> feature_sentences;  // the same of features, where markers didn't do
};

// Looks through photos, board photos and profile. Slow at first; each photo, the boards' lens and
// the features are kept in the cache, so that a second time takes milliseconds. Throws Error where
// no photo can be read, no board photo shows the board, or the profile is another lens's;
// Cancelled.
CalibrationFinds find_for_calibration(const CalibrationSources& sources, const Cache& cache,
                                      Progress& progress);

// Whether these sources were looked through to the end before, so that the cache has it all.
bool was_found(const CalibrationSources& sources, const Cache& cache);

}  // namespace bosk
