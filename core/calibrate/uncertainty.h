#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/calibrate/bundle_normal.h"

namespace bosk {

// How far the truth may lie from a solved bundle: the inverse of its normal equations (Triggs et
// al. 2000, section 9), in the frame of what was measured; along `problem.pinned` the cameras' mean
// place, orientation and size count as exact. Sightings that aren't used don't count.
class BundleCovariance {
 public:
  // `noise` multiplies every sighting's sigma: what residuals say of it. `pins` are columns of
  // changes of the dense part (see BundleLayout) that count as impossible, besides
  // problem.pinned. Throws Cancelled.
  BundleCovariance(const BundleProblem& problem, const BundleState& state, double noise,
                   const Eigen::MatrixXd& pins, const Progress& progress);

  Eigen::MatrixXd lens_and_camera(int camera) const;  // free intrinsics, then rotation, translation
  Eigen::Matrix3d centre(int camera) const;           // of a camera, in the world
  Eigen::Matrix3d points(int first, int second) const;  // covariance of one with the other
  double distance_sigma(int first, int second) const;   // between two points
  double scale_sigma() const;                           // of the cameras' mean distance, relative

 private:
  std::vector<EliminatedPoint::Couple> change_by_dense(int point) const;
  Eigen::Matrix3d own(int point) const;

  BundleState state_;
  NormalEquations equations_;
  Eigen::MatrixXd dense_;  // covariance of the dense part
  std::vector<Eigen::Matrix3d> own_inverse_;
};

// The crown and its surroundings as every camera sees them: the crown point and a ring of eight
// round it, `ring_px` from it.
struct CrownView {
  glm::dvec3 crown{0.0};
  double ring_px = 0.0;
};
std::vector<glm::dvec3> crown_ring(const BundleState& state, int camera, const CrownView& view);

// The covariance of the cameras' shape: whatever was measured of size, place and orientation, the
// moves of the world count as made so that the cameras see the crown as nearly as they can where
// they should.
BundleCovariance crown_covariance(const BundleProblem& problem, const BundleState& state,
                                  double noise, const CrownView& view, const Progress& progress);
// One sigma, radial, of where the camera sees the crown: the root mean square over the ring.
double crown_sigma_px(const BundleCovariance& covariance, const BundleProblem& problem,
                      const BundleState& state, int camera, const CrownView& view);

// How much larger than they say the sightings' errors are: the root of the residuals' chi square
// over the degrees of freedom, drawn towards 1 where these are few.
double noise_factor(const BundleProblem& problem, const BundleState& state);

// Equations less unknowns; below zero the sightings can't determine the scene.
int redundancy(const BundleProblem& problem, const BundleState& state);

}  // namespace bosk
