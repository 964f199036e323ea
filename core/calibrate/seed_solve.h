#pragma once

#include <string>
#include <vector>

#include "core/calibrate/seed.h"

namespace bosk {

// A seed after a short robust solve.
struct SolvedSeed {
  std::string from;
  BundleState state;
  double cost = 0.0;
};

// The loss that solves end with, in sigmas, where sightings are as accurate as they say.
inline constexpr double kFinalLoss = 5.0;

// Solves each seed with a loss that tightens from 120 to `final_loss` sigmas and a lens that is
// freed bit by bit: none of it, focal length, all that `problem` frees. Cameras and points that a
// seed put wrong are placed anew on the way. Hopeless seeds are dropped half way. Lowest cost
// first.
std::vector<SolvedSeed> solve_seeds(const BundleProblem& problem, const SeedScene& scene,
                                    std::vector<Seed> seeds, double final_loss, Progress& progress);

// Places anew what fits badly at `loss_scale` (P3P for cameras, rays for points) where that costs
// less. Throws Cancelled.
void repair(const BundleProblem& problem, const Lens& lens, double loss_scale, BundleState& state,
            const Progress& progress);

// The problem with only the first `count` kinds of intrinsics free: 0 none, 1 focal length, 2 all
// that were.
BundleProblem with_lens_stage(const BundleProblem& problem, int count);

}  // namespace bosk
