#include "core/calibrate/boards.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "tests/calibrate/painted_board.h"

namespace bosk {
namespace {

const Progress quiet;

// Greatest and rms distance of found corners from the truth, over both axes; sigmas beside them.
struct Misses {
  int corners = 0;
  double rms_px = 0.0, max_px = 0.0, mean_sigma_px = 0.0;
};

Misses misses(const std::vector<BoardCorner>& found, const std::vector<BoardCorner>& truth) {
  std::map<std::pair<int, int>, glm::dvec2> true_pixel;
  for (const BoardCorner& corner : truth) true_pixel[{corner.column, corner.row}] = corner.pixel;
  Misses result;
  double sum = 0.0;
  for (const BoardCorner& corner : found) {
    const double miss = glm::distance(corner.pixel, true_pixel.at({corner.column, corner.row}));
    sum += miss * miss;
    result.max_px = std::max(result.max_px, miss);
    result.mean_sigma_px += corner.sigma_px / double(found.size());
  }
  result.corners = int(found.size());
  result.rms_px = std::sqrt(sum / (2.0 * double(found.size())));
  return result;
}

const BoardShape kNineBySix{};

TEST(FindBoard, FindsEachCornerWithinATenthOfAPixel) {
  const Lens lens = phone_lens(640, 480);
  for (const glm::dvec3& turn :
       {glm::dvec3(0.0), glm::dvec3(0.5, -0.3, 0.2), glm::dvec3(-0.2, 0.6, 1.5)}) {
    const RigidTransform pose = board_pose(kNineBySix, lens, turn, {330, 235}, 0.42);
    const auto found = find_board(paint_board(kNineBySix, lens, pose), kNineBySix, quiet);
    ASSERT_EQ(found.size(), 54u);
    const Misses miss = misses(found, true_corners(kNineBySix, lens, pose));
    EXPECT_LT(miss.rms_px, 0.1);
    EXPECT_LT(miss.max_px, 0.3);
  }
}

}  // namespace
}  // namespace bosk
