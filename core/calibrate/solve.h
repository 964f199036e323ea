#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/calibration.h"
#include "core/calibrate/sightings.h"
#include "core/calibrate/survey.h"
#include "core/photo/camera.h"

namespace bosk {

// One lens took all photos. A known one (from a board or a profile) is kept as it is; another is a
// first guess, of which the focal length may be wrong by a third.
struct LensKnowledge {
  Lens lens;
  bool known = false;
};

// Where a camera stood, in a frame and scale of its own that all first poses share.
struct FirstPose {
  std::string photo;
  RigidTransform camera_from_scene;
};

struct SolveOptions {
  int fewest_sightings = 4;     // of points seen in other photos too; photos with less are refused
  int few_sightings = 5;        // photos with less are placed with a warning
  double outlier_sigmas = 5.0;  // sightings further off, in standard deviations, are left out
  double uncertain_crown_px = 1.5;     // one sigma at the crown above which a photo is uncertain
  double refused_crown_px = 6.0;       // above which its camera isn't given
  std::vector<FirstPose> first_poses;  // from features or an earlier solve; of any of the photos
};

// Cameras, points, lens, scale and up from what was seen and measured. Photos stand in the order of
// the walk, which helps but isn't needed. A solve that can't be trusted comes back as
// Verdict::refused, with sentences that say why. Throws Error for input that contradicts itself: a
// photo named twice, a point sighted twice in one photo, sigmas or sizes that aren't above 0,
// numbers that aren't finite; Cancelled within 100 ms.
Calibration solve_cameras(std::span<const PhotoSightings> photos, const Survey& survey,
                          const LensKnowledge& lens, const SolveOptions& options,
                          Progress& progress);

}  // namespace bosk
