#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "core/matte/matte.h"
#include "core/photo/photo.h"

namespace bosk {

// How much of the mattes' pixels the tree covers, and how much more is half covered; 0 to 1.
struct Coverage {
  double tree = 0.0;   // alpha above 0
  double edges = 0.0;  // of that, alpha below 1
};
// Of every fourth pixel of every fourth row: for estimates.
Coverage coverage_of(const Mattes& mattes);

// Estimates of what files will take, in bytes, before they are made; right to a factor of three
// for trees in leaf. The first is of mattes or pictures in the photos' own pixels.
std::size_t estimated_rgba_bytes(const Photos& views, const Coverage& coverage);
std::size_t estimated_turntable_bytes(int frames, const glm::ivec2& size_px);
std::size_t estimated_report_bytes(const Photos& views, std::size_t scored);
std::size_t estimated_camera_bytes(std::size_t cameras);

}  // namespace bosk
