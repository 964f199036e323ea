#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "core/calibrate/bundle_normal.h"

namespace bosk {

// A residual in sigmas, with its derivatives by each part of the state that it looks at.
struct Row {
  struct Part {
    int offset = -1;  // in the dense part
    int point = -1;   // or an eliminated point
    Jacobian by;
  };
  std::vector<Part> parts;
  Eigen::VectorXd residual;  // 1 to 3
  bool doubted = true;       // a gross mistake in it stops pulling
};

// All rows but those of the sightings: survey, bodies, and what is known of the lens.
void for_each_row(const BundleProblem& problem, const BundleState& state,
                  const BundleLayout& layout, const std::function<void(const Row&)>& visit);

double row_cost(const Row& row, double loss_scale);

}  // namespace bosk
