#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/similarity.h"
#include "core/matte/matte.h"
#include "core/photo/photo.h"

namespace bosk {

struct PoseRefinementOptions {
  int longest_px = 240;      // edge of the pictures that are compared, 64 to 1000; first half of it
  int rounds = 2;            // at each of the two sizes, 1 to 10
  double least_gain = 0.01;  // of the held-out error, relative: with less the poses stay
};

// `camera_from_world` runs beside the photos: the poses given, unless `accepted`. Errors are the
// mean |alpha - matte| over pixels that took no part in the fit, of volumes made from other photos.
struct PoseRefinement {
  std::vector<RigidTransform> camera_from_world;
  bool accepted = false;
  double error_before = 0.0, error_after = 0.0;
  std::vector<double> moved_px;  // of each photo: how far the crown's corners move in it, RMS
};

// Small turns of the cameras about their own axes that make mattes and opacity agree across the
// photos: errors of a few pixels. Where a camera stands is left alone: its errors look like turns
// at the crown's distance, and freeing it fits leaves that aren't there (measured: README).
//
// A photo is compared with a volume of the photos outside its third; it turns by damped
// Gauss-Newton steps on the difference in alpha, over every second block of 8 x 8 pixels; the other
// blocks judge. Place, turn and size of the crown stay on average over the photos (`alignment`).
// Poses so wrong that the mattes carve no common volume can't be repaired.
//
// Throws Error for fewer than 6 photos, and as estimate_opacity does; Cancelled. The same to the
// bit at any number of threads.
PoseRefinement refine_poses(const Photos& photos, const Mattes& mattes,
                            const PoseRefinementOptions& options, Progress& progress);

// The move of the world, wanted_from_given, after which the given cameras see the points nearest to
// where the wanted ones do (least squares, pixels): what cameras may differ by and still agree.
// Starts from no move; at least 3 points not on a line. The lists of cameras are equally long.
Similarity alignment(std::span<const Camera> wanted, std::span<const Camera> given,
                     std::span<const glm::dvec3> points);

}  // namespace bosk
