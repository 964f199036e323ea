#include "core/calibrate/boards.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/random.h"
#include "tests/calibrate/painted_board.h"

namespace bosk {
namespace {

const Progress quiet;
const BoardShape kNineBySix{};
const BoardShape kCharuco{BoardKind::charuco, 6, 4, 0.03};

// Distances of found corners from the truth: rms over both axes.
struct Misses {
  double rms_px = 0.0, max_px = 0.0;
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
  }
  result.rms_px = std::sqrt(sum / (2.0 * double(found.size())));
  return result;
}

TEST(FindBoard, FindsEachCornerInItsPlaceHoweverTheBoardIsTurned) {
  const Lens lens = phone_lens(640, 480);
  for (const glm::dvec3& turn : {glm::dvec3(0.0), glm::dvec3(0.5, -0.3, 0.2),
                                 glm::dvec3(-0.2, 0.6, 1.5), glm::dvec3(0.1, 0.1, 3.1)}) {
    const RigidTransform pose = board_pose(kNineBySix, lens, turn, {330, 235}, 0.42);
    const auto found = find_board(paint_board(kNineBySix, lens, pose), kNineBySix, quiet);
    ASSERT_EQ(found.size(), 54u);
    const Misses miss = misses(found, true_corners(kNineBySix, lens, pose));
    EXPECT_LT(miss.rms_px, 0.08);  // cornerSubPix: 0.02 tilted, 0.05 where edges follow the pixels
    EXPECT_LT(miss.max_px, 0.25);
  }
}

TEST(FindBoard, UnevenLightBlurAndNoiseCostATenthOfAPixel) {
  const Lens lens = phone_lens(640, 480);
  const RigidTransform pose = board_pose(kNineBySix, lens, {0.4, -0.3, 0.2}, {330, 235}, 0.42);
  const BoardPaint hard{.blur_px = 1.5, .noise = 6.0, .lit_unevenly = 0.6};
  const auto found = find_board(paint_board(kNineBySix, lens, pose, hard), kNineBySix, quiet);
  ASSERT_EQ(found.size(), 54u);
  EXPECT_LT(misses(found, true_corners(kNineBySix, lens, pose)).rms_px, 0.2);
  const auto easy = find_board(paint_board(kNineBySix, lens, pose), kNineBySix, quiet);
  ASSERT_EQ(easy.size(), 54u);
  EXPECT_GT(found[20].sigma_px, easy[20].sigma_px);
}

TEST(FindBoard, ASquareBoardStartsAtTheTopLeft) {
  const BoardShape square{BoardKind::chessboard, 8, 8, 0.03};
  const Lens lens = phone_lens(640, 480);
  const RigidTransform pose = board_pose(square, lens, {0.3, -0.2, 0.1}, {320, 240}, 0.5);
  const auto found = find_board(paint_board(square, lens, pose), square, quiet);
  ASSERT_EQ(found.size(), 64u);
  EXPECT_LT(misses(found, true_corners(square, lens, pose)).max_px, 0.3);
}

// The search works on 1.5 megapixels: the corners must be as good as in a small picture.
TEST(FindBoard, LargePicturesAreRefinedAtTheirOwnSize) {
  const Lens lens = phone_lens(2400, 1800);
  const RigidTransform pose = board_pose(kNineBySix, lens, {0.4, 0.3, 0.2}, {1200, 900}, 0.6);
  const auto found = find_board(paint_board(kNineBySix, lens, pose), kNineBySix, quiet);
  ASSERT_EQ(found.size(), 54u);
  EXPECT_LT(misses(found, true_corners(kNineBySix, lens, pose)).rms_px, 0.05);
}

TEST(FindBoard, CharucosOfBothLayoutsAreFound) {
  const Lens lens = phone_lens(640, 480);
  const RigidTransform pose = board_pose(kCharuco, lens, {0.3, -0.4, 0.8}, {320, 240}, 0.35);
  for (const bool dark_first : {true, false}) {
    const auto picture = paint_board(kCharuco, lens, pose, {.dark_first = dark_first});
    const auto found = find_board(picture, kCharuco, quiet);
    ASSERT_EQ(found.size(), 24u) << dark_first;
    EXPECT_LT(misses(found, true_corners(kCharuco, lens, pose)).rms_px, 0.1);
  }
}

TEST(FindBoard, ACharucoThatIsCutGivesTheCornersThatShow) {
  const Lens lens = phone_lens(640, 480);
  const RigidTransform pose = board_pose(kCharuco, lens, {0.2, -0.3, 0.1}, {60, 240}, 0.3);
  const auto truth = true_corners(kCharuco, lens, pose);
  ASSERT_LT(truth.size(), 24u);
  const auto found = find_board(paint_board(kCharuco, lens, pose), kCharuco, quiet);
  EXPECT_GE(found.size(), 6u);
  EXPECT_LE(found.size(), truth.size());
  EXPECT_LT(misses(found, truth).rms_px, 0.15);
}

TEST(FindBoard, APictureWithoutABoardGivesNone) {
  Image<std::uint8_t> picture(320, 240);
  Random random(1);
  for (std::uint8_t& pixel : picture.pixels()) pixel = std::uint8_t(random.below(256));
  EXPECT_TRUE(find_board(picture, kNineBySix, quiet).empty());
  EXPECT_TRUE(find_board(picture, kCharuco, quiet).empty());
  EXPECT_TRUE(find_board(Image<std::uint8_t>(8, 8), kNineBySix, quiet).empty());
  EXPECT_TRUE(find_board({}, kNineBySix, quiet).empty());
}

TEST(FindBoard, StopsWhenAsked) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(find_board(Image<std::uint8_t>(64, 64), kNineBySix, progress), Cancelled);
}

TEST(BoardShape, NonsenseIsRefusedInWords) {
  EXPECT_THROW(check_board_shape({BoardKind::chessboard, 2, 6, 0.03}), Error);
  EXPECT_THROW(check_board_shape({BoardKind::chessboard, 9, 6, 0.0}), Error);
  EXPECT_THROW(check_board_shape({BoardKind::charuco, 9, 6, 0.03, "DICT_9X9"}), Error);
  EXPECT_THROW(check_board_shape({BoardKind::charuco, 9, 6, 0.03, "DICT_4X4_50", 1.2}), Error);
  EXPECT_NO_THROW(check_board_shape(kCharuco));
}

TEST(BoardSightings, NameTheCornersAsTheBodyDoes) {
  const RigidBody body = board_body(kNineBySix);
  ASSERT_EQ(body.points.size(), 54u);
  EXPECT_EQ(body.points[9 + 4], "board 4,1");
  EXPECT_EQ(body.in_body[9 + 4], glm::dvec3(0.12, 0.03, 0.0));
  const auto sightings = board_sightings({{4, 1, {12.5, 7.25}, 0.2}});
  ASSERT_EQ(sightings.size(), 1u);
  EXPECT_EQ(sightings[0].point, "board 4,1");
  EXPECT_EQ(sightings[0].by, SightedBy::board);
  EXPECT_EQ(sightings[0].sigma_px, 0.2);
}

}  // namespace
}  // namespace bosk
