#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/photo/camera.h"

namespace bosk {

// The outline of the ellipsoid of `factor` sigma around a place, as a pinhole sees it, to first
// order: the ellipse of J C J', with J the projection's derivative at the place (exact where the
// ellipsoid is small beside its distance). Pixels, in order round it; none behind the camera.
std::optional<std::vector<glm::dvec2>> seen_ellipse(const Camera& pinhole,
                                                    const glm::dvec3& in_world,
                                                    const glm::dmat3& covariance_m2, double factor);

// How often sigma a view has to draw so that the median error bar gets about `wanted_m` large: 1, 2
// or 5 times a power of ten, at least 1. 1 without error bars.
double exaggeration_for(std::span<const glm::dmat3> covariances_m2, double wanted_m);

}  // namespace bosk
