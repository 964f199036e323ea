#pragma once

#include <cstdint>
#include <vector>

#include "core/calibrate/lens_solve.h"

namespace bosk {

// Corners of a board by projection: what a perfect finder with Gaussian noise would give.
struct SyntheticBoards {
  BoardShape shape{BoardKind::chessboard, 10, 7, 0.03};
  int boards = 20;
  double noise_px = 0.1;      // along each axis, standard deviation
  double largest_tilt = 0.7;  // radians, of the board about its own axes
  double spread = 0.38;       // of the frame: how far off its middle a board's middle may be seen
  double gross_share = 0.0;   // of corners that are 5 to 40 px off
  glm::dvec2 warp_m{0.0};     // as LensCalibration::board_warp_m
  std::uint64_t seed = 1;
};

// Each board's views of corners that fall into the frame; at least 12 of them, else another pose is
// drawn. `poses` gets the true camera_from_board where given.
std::vector<BoardView> synthetic_views(const Lens& lens, const SyntheticBoards& what,
                                       std::vector<RigidTransform>* poses = nullptr);

// The same views with Gaussian noise on every corner.
std::vector<BoardView> with_noise(std::vector<BoardView> views, double noise_px,
                                  std::uint64_t seed);

// Largest and rms distance, over the frame, between where the two lenses see what the first sees at
// a grid of pixels, once the second's camera is turned to agree best.
struct LensDifference {
  double rms_px = 0.0, max_px = 0.0;
};
LensDifference lens_difference(const Lens& truth, const Lens& other);

}  // namespace bosk
