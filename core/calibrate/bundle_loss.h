#pragma once

#include <Eigen/Core>

namespace bosk {

// What a residual costs and how much it still pulls, after Geman and McClure; see bundle.h.
struct RobustLoss {
  double cost = 0.0, weight = 1.0;
};

// Squared sigmas of a sighting behind its camera.
inline constexpr double kBehind = 1e12;

inline RobustLoss robust_loss(double squared_sigmas, double scale) {
  const double share = 1.0 / (1.0 + squared_sigmas / (scale * scale));
  return {squared_sigmas * share, share * share};
}

inline Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

}  // namespace bosk
