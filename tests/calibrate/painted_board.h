#pragma once

#include <cstdint>

#include "core/calibrate/boards.h"
#include "core/calibrate/lens_solve.h"
#include "core/geometry/rigid_transform.h"
#include "core/image/image.h"
#include "core/photo/camera.h"

namespace bosk {

struct BoardPaint {
  double blur_px = 0.6;       // Gaussian, on top of the pixels' own area
  double noise = 1.0;         // grey levels, standard deviation
  double lit_unevenly = 0.0;  // 0 to 1: how much darker the right edge of the picture is
  std::uint64_t seed = 1;
  bool dark_first = true;  // ChArUco: the top left square is dark, else holds a marker
};

// A picture of the board with a white rim one square wide, in front of grey. Exact but for the
// supersampling (8 x 8 a pixel).
Image<std::uint8_t> paint_board(const BoardShape& shape, const Lens& lens,
                                const RigidTransform& camera_from_board,
                                const BoardPaint& paint = {});

// A phone's lens, for pictures of any size.
Lens phone_lens(int width_px, int height_px);

// Where a board of the shape must lie to be turned by the Rodrigues vector and to show its middle
// at `middle_px`, `distance_m` away.
RigidTransform board_pose(const BoardShape& shape, const Lens& lens, const glm::dvec3& rodrigues,
                          const glm::dvec2& middle_px, double distance_m);

// The true corners, in find_board's order; those outside the picture are left out.
std::vector<BoardCorner> true_corners(const BoardShape& shape, const Lens& lens,
                                      const RigidTransform& camera_from_board);

}  // namespace bosk
