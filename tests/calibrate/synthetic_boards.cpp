#include "tests/calibrate/synthetic_boards.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/random.h"
#include "core/geometry/rotation.h"
#include "tests/calibrate/painted_board.h"

namespace bosk {
namespace {

using glm::dvec2;
using glm::dvec3;

RigidTransform random_pose(const Lens& lens, const SyntheticBoards& what, Random& random) {
  const dvec2 frame(lens.width_px, lens.height_px);
  const dvec2 off(random.uniform(-what.spread, what.spread),
                  random.uniform(-what.spread, what.spread));
  const dvec3 turn(random.uniform(-what.largest_tilt, what.largest_tilt),
                   random.uniform(-what.largest_tilt, what.largest_tilt),
                   random.uniform(-0.4, 0.4));
  const double width_m = what.shape.square_m * what.shape.columns;
  const double distance_m = lens.focal_px.x * width_m / lens.width_px * random.uniform(1.0, 2.2);
  return board_pose(what.shape, lens, turn, frame * (0.5 + off), distance_m);
}

dvec3 warped_corner(const SyntheticBoards& what, int column, int row) {
  const double u = 2.0 * column / (what.shape.columns - 1) - 1.0;
  const double v = 2.0 * row / (what.shape.rows - 1) - 1.0;
  const double z = what.warp_m.x * (1.0 - u * u) + what.warp_m.y * (1.0 - v * v);
  return corner_in_board(what.shape, column, row) + dvec3(0.0, 0.0, z);
}

bool in_frame(const Lens& lens, const dvec2& pixel) {
  return pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x <= lens.width_px - 1 &&
         pixel.y <= lens.height_px - 1;
}

BoardCorner seen(int column, int row, dvec2 pixel, const SyntheticBoards& what, Random& random) {
  pixel += what.noise_px * dvec2(random.normal(), random.normal());
  if (random.uniform() < what.gross_share) {
    const double angle = random.uniform(0.0, 6.283185307179586);
    pixel += random.uniform(5.0, 40.0) * dvec2(std::cos(angle), std::sin(angle));
  }
  return {column, row, pixel, 0.1};
}

std::vector<BoardCorner> seen_corners(const Lens& lens, const RigidTransform& pose,
                                      const SyntheticBoards& what, Random& random) {
  std::vector<BoardCorner> corners;
  for (int row = 0; row < what.shape.rows; ++row)
    for (int column = 0; column < what.shape.columns; ++column) {
      const auto pixel = pixel_from_camera(lens, pose * warped_corner(what, column, row));
      if (pixel && in_frame(lens, *pixel))
        corners.push_back(seen(column, row, *pixel, what, random));
    }
  return corners;
}

}  // namespace

std::vector<BoardView> synthetic_views(const Lens& lens, const SyntheticBoards& what,
                                       std::vector<RigidTransform>* poses) {
  Random poses_random(what.seed, 1), noise_random(what.seed, 2);
  std::vector<BoardView> views;
  while (int(views.size()) < what.boards) {
    const RigidTransform pose = random_pose(lens, what, poses_random);
    std::vector<BoardCorner> corners = seen_corners(lens, pose, what, noise_random);
    if (corners.size() < 12) continue;
    views.push_back({"board" + std::to_string(views.size()),
                     lens.width_px,
                     lens.height_px,
                     {},
                     std::move(corners)});
    if (poses) poses->push_back(pose);
  }
  return views;
}

std::vector<BoardView> with_noise(std::vector<BoardView> views, double noise_px,
                                  std::uint64_t seed) {
  Random random(seed, 3);
  for (BoardView& view : views)
    for (BoardCorner& corner : view.corners)
      corner.pixel += noise_px * dvec2(random.normal(), random.normal());
  return views;
}

LensDifference lens_difference(const Lens& truth, const Lens& other) {
  constexpr int kSteps = 16;
  std::vector<dvec3> in_truth, in_other;
  std::vector<dvec2> pixels;
  glm::dmat3 outer(0.0);
  for (int j = 0; j <= kSteps; ++j)
    for (int i = 0; i <= kSteps; ++i) {
      const dvec2 pixel(i * (truth.width_px - 1.0) / kSteps, j * (truth.height_px - 1.0) / kSteps);
      const auto a = camera_from_pixel(truth, pixel), b = camera_from_pixel(other, pixel);
      if (!a || !b) return {1e9, 1e9};
      in_truth.push_back(*a);
      pixels.push_back(pixel);
      outer += glm::outerProduct(*b, *a);
    }
  const glm::dmat3 other_from_truth = fit_rotation(outer).rotation;
  LensDifference result;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto pixel = pixel_from_camera(other, other_from_truth * in_truth[i]);
    if (!pixel) return {1e9, 1e9};
    const double off = glm::distance(*pixel, pixels[i]);
    result.rms_px += off * off / double(pixels.size());
    result.max_px = std::max(result.max_px, off);
  }
  result.rms_px = std::sqrt(result.rms_px);
  return result;
}

}  // namespace bosk
