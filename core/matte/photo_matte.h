#pragma once

#include "core/matte/matte.h"
#include "core/matte/study.h"

namespace bosk {

// Rounds in which the photos of a tree are held against each other (hull.h).
constexpr int kHullRounds = 2;

// Mean alpha of a photo that shows no tree (below), or nothing else (above).
constexpr double kNothing = 2e-4, kAll = 0.98;

// How often a photo's rows are counted while it is matted: CIELab, alpha, its refinement,
// foreground.
constexpr std::size_t kRowSteps = 4;

Image<glm::vec3> linear_light(const Image<glm::vec3>& srgb, const Progress& progress);

// The matte of a photo about which all is settled; `linear` is its linear light. Calls
// progress.advance() kRowSteps times for each row. The photo may be a smaller copy of the one
// studied.
Matte matte_from_study(const Photo& photo, const Image<glm::vec3>& linear, const Study& study,
                       const MatteOptions& options, Progress& progress);

}  // namespace bosk
