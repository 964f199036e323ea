#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "core/calibrate/bundle.h"

namespace bosk {

// Normal equations of a bundle, for the files of this folder that solve or invert them. The state
// is changed by a vector: [free intrinsics][camera 6 each][body 6 each][kept point 3 each], then 3
// of each eliminated point. Poses change as exp(rotation) * pose + translation, in the target's
// frame; so a camera's centre moves by minus its rotation's transpose times the translation alone.

using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 12>;  // of a residual
using Coupling = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 12, 3>;

struct BundleLayout {
  std::vector<int> lens;         // the intrinsics that are free
  std::vector<int> kept_offset;  // of each point; -1: it is eliminated
  int camera_offset = 0, body_offset = 0, kept_begin = 0, dense_size = 0;

  int camera(int index) const { return camera_offset + 6 * index; }
  int body(int index) const { return body_offset + 6 * index; }
};
// Points that are tied to each other by a row are kept, the others eliminated.
BundleLayout layout_of(const BundleProblem& problem, const BundleState& state);

struct EliminatedPoint {
  struct Couple {
    int offset = 0;
    Coupling value;
  };
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  std::vector<Couple> couples;  // with the dense part
};

struct NormalEquations {
  BundleLayout layout;
  Eigen::MatrixXd dense;  // the lower triangle only
  Eigen::VectorXd gradient;
  std::vector<EliminatedPoint> points;  // of every point; unused for kept ones
  double cost = 0.0;
};

// Weight of a pinned change, large beside what data say of others.
inline constexpr double kPinned = 1e12;

// Throws Cancelled.
NormalEquations normal_equations(const BundleProblem& problem, const BundleState& state,
                                 double loss_scale, const Progress& progress);

// The dense part less what the eliminated points explain. `damping` is added to each diagonal,
// relative to it.
struct ReducedSystem {
  Eigen::MatrixXd matrix;  // the lower triangle only
  Eigen::VectorXd gradient;
  std::vector<Eigen::Matrix3d> own_inverse;  // of each point
};
ReducedSystem reduced(const NormalEquations& equations, double damping, const Progress& progress);

struct ProjectedSightings;
// Derivatives of the i-th projected pixel by the free intrinsics, then its camera.
Eigen::MatrixXd pixel_by_lens_and_camera(const BundleProblem& problem, const BundleState& state,
                                         const ProjectedSightings& projected, std::size_t i);

// The change of the cameras' parameters, of dense_size, that a gauge move makes about `centre`.
Eigen::VectorXd gauge_direction(const BundleLayout& layout, const BundleState& state,
                                const GaugeMove& move, const glm::dvec3& centre);
glm::dvec3 mean_centre(const BundleState& state);

BundleState changed(const BundleState& state, const BundleLayout& layout,
                    const Eigen::VectorXd& dense, std::span<const Eigen::Vector3d> points);

}  // namespace bosk
