#pragma once

#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/mrcal_lens.h"
#include "core/geometry/rigid_transform.h"

namespace bosk {

// Bundle adjustment of one lens that took photos of points from many places, together with what was
// measured at the tree. All is by index: cameras, points and bodies of a BundleState.

struct BundleSighting {
  int camera = 0, point = 0;
  glm::dvec2 pixel{0.0};
  double sigma_px = 0.5;
  bool used = true;
};

// What is measured, each a residual over its sigma. The world has +z up.
struct LengthRow {  // |to - from| = length
  int from = 0, to = 0;
  double length = 0.0, sigma = 1.0;
  bool used = true;
};
struct CoordinateRow {  // point[axis] = value
  int point = 0, axis = 2;
  double value = 0.0, sigma = 1.0;
  bool used = true;
};
struct PlumbRow {  // top straight above foot; a lean costs
  int top = 0, foot = 0;
  double sigma = 0.02;  // radians
};
struct BodyRow {  // point = world_from_body * in_body; never doubted
  int body = 0, point = 0;
  glm::dvec3 in_body{0.0};
  double sigma = 1.0;
};
struct UpRow {  // the world's z, turned into the camera, is up_in_camera
  int camera = 0;
  glm::dvec3 up_in_camera{0.0};
  double sigma = 1.0;
};

// What is known of the lens before; in mrcal's order fx fy cx cy distortion.
struct LensPrior {
  std::vector<double> mean, sigma;
  double aspect_sigma = 1e-3;  // of fx / fy
};

// A move of the world and all in it that no sighting sees: translation, rotation about `centre`
// (x, y, z, radians), growth about it (relative).
using GaugeMove = std::array<double, 7>;

struct BundleProblem {
  LensFamily family = LensFamily::pinhole;
  std::vector<bool> lens_free;  // of each intrinsic; those that aren't stay as they are
  LensPrior lens;
  std::vector<BundleSighting> sightings;  // sorted by camera
  std::vector<LengthRow> lengths;
  std::vector<CoordinateRow> coordinates;
  std::vector<PlumbRow> plumbs;
  std::vector<BodyRow> bodies;
  std::vector<UpRow> ups;
  // Moves that nothing measured determines; a solve leaves the cameras as a whole where they are
  // along them.
  std::vector<GaugeMove> pinned;

  bool has_rows() const {
    return !lengths.empty() || !coordinates.empty() || !plumbs.empty() || !bodies.empty() ||
           !ups.empty();
  }
};

struct BundleState {
  std::vector<double> intrinsics;
  std::vector<RigidTransform> camera_from_world, world_from_body;
  std::vector<glm::dvec3> points;
};

// A residual of r sigmas costs r^2 / (1 + (r / scale)^2), after Geman and McClure 1987: at most
// scale^2, so that gross mistakes stop pulling. The same weights as mrcal's w = 1 / (1 + (r/c)^2).
constexpr double kLeastSquares = std::numeric_limits<double>::infinity();

struct BundleRound {
  double loss_scale = kLeastSquares;  // in sigmas
  int most_iterations = 20;
};

// Levenberg and Marquardt's iteration with points eliminated (Schur complement; Triggs et al. 2000,
// "Bundle adjustment: a modern synthesis", section 6). Projection and its derivatives are mrcal's.
// Returns the cost reached. A point behind a camera costs as much as any gross mistake and pulls
// nothing. Throws Cancelled.
double solve_bundle(const BundleProblem& problem, BundleState& state, const BundleRound& round,
                    const Progress& progress);

double bundle_cost(const BundleProblem& problem, const BundleState& state, double loss_scale);

// Predicted minus seen, in pixels, in the sightings' order; infinite behind the camera.
std::vector<glm::dvec2> sighting_errors(const BundleProblem& problem, const BundleState& state);

}  // namespace bosk
