#include "core/calibrate/lens_solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/geometry/rotation.h"
#include "tests/calibrate/painted_board.h"
#include "tests/calibrate/synthetic_boards.h"

namespace bosk {
namespace {

const Lens kPhone = phone_lens(1600, 1200);
const BoardShape kShape = SyntheticBoards{}.shape;

LensCalibration calibrated(const std::vector<BoardView>& views, const LensOptions& options = {}) {
  Progress quiet;
  return calibrate_lens(views, kShape, options, quiet);
}

std::string chosen_model(const LensCalibration& calibration) {
  for (const LensTrial& trial : calibration.trials)
    if (trial.chosen) return trial.model;
  return {};
}

bool says(const LensCalibration& calibration, const std::string& words) {
  return std::any_of(
      calibration.sentences.begin(), calibration.sentences.end(),
      [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

std::string left_out(const LensCalibration& calibration) {
  std::string names;
  for (const BoardFinding& board : calibration.boards)
    if (!board.used) names += board.photo + " ";
  return names;
}

TEST(CalibrateLens, RecoversALensFromCornersWithoutNoise) {
  const auto views = synthetic_views(kPhone, {.boards = 12, .noise_px = 0.0});
  const LensCalibration result = calibrated(views);
  // What is left is mrcal's regularisation, which pulls the lens a little towards a plain one.
  EXPECT_LT(lens_difference(kPhone, result.profile.lens).max_px, 0.02);
  EXPECT_LT(result.profile.rms_px, 1e-3);
  EXPECT_EQ(chosen_model(result), "opencv4");
  EXPECT_EQ(result.verdict, Verdict::good) << result.sentences.front();
}

TEST(CalibrateLens, NoiseCostsNoMoreThanItSays) {
  const auto views = synthetic_views(kPhone, {.boards = 20, .noise_px = 0.1});
  const LensCalibration result = calibrated(views);
  EXPECT_NEAR(result.profile.rms_px, 0.1, 0.01);
  EXPECT_NEAR(result.corner_sigma_px, 0.1, 0.01);
  const auto& sigma = result.profile.uncertainty_px.pixels();
  const double worst = double(*std::max_element(sigma.begin(), sigma.end()));
  EXPECT_LT(lens_difference(kPhone, result.profile.lens).max_px, 4.0 * worst);
  EXPECT_EQ(result.verdict, Verdict::good) << result.sentences.front();
}

TEST(CalibrateLens, TakesTheRicherModelWhereTheLensNeedsIt) {
  Lens rational = kPhone;
  rational.distortion = {0.9, -0.35, 8e-4, -6e-4, 0.06, 1.25, -0.25, -0.02};
  const auto views = synthetic_views(rational, {.boards = 20});
  const LensCalibration result = calibrated(views);
  EXPECT_EQ(chosen_model(result), "opencv8");
  ASSERT_EQ(result.trials.size(), 3u);
  EXPECT_GT(result.trials[0].held_out_rms_px, 1.5 * result.trials[2].held_out_rms_px);
  EXPECT_LT(lens_difference(rational, result.profile.lens).rms_px, 0.2);
}

TEST(CalibrateLens, GrossCornersAreOutliers) {
  const auto views = synthetic_views(kPhone, {.boards = 20, .gross_share = 0.05});
  const LensCalibration result = calibrated(views);
  int outliers = 0;
  for (const CornerResidual& corner : result.residuals) {
    outliers += corner.outlier ? 1 : 0;
    if (!corner.outlier) {
      EXPECT_LT(glm::length(corner.error_px), 1.0);
    }
  }
  EXPECT_NEAR(outliers, 0.05 * double(result.residuals.size()), 25);
  EXPECT_LT(lens_difference(kPhone, result.profile.lens).max_px, 0.5);
  EXPECT_TRUE(left_out(result).empty()) << left_out(result);
}

TEST(CalibrateLens, MeasuresHowTheBoardIsBent) {
  const auto views = synthetic_views(kPhone, {.boards = 20, .warp_m = {1e-3, -0.5e-3}});
  const LensCalibration result = calibrated(views);
  EXPECT_NEAR(result.board_warp_m.x, 1e-3, 5e-5);
  EXPECT_NEAR(result.board_warp_m.y, -0.5e-3, 5e-5);
  EXPECT_LT(lens_difference(kPhone, result.profile.lens).max_px, 0.5);
  const LensCalibration stiff = calibrated(synthetic_views(kPhone, {.boards = 20}));
  EXPECT_EQ(stiff.board_warp_m, glm::dvec2(0.0));
}

TEST(CalibrateLens, NamesTheBoardsThatDoNotFit) {
  auto views = synthetic_views(kPhone, {.boards = 14});
  const SyntheticBoards bent{.boards = 1, .warp_m = {8e-3, 4e-3}, .seed = 5};
  Lens zoomed = kPhone;
  zoomed.focal_px *= 1.4;
  const SyntheticBoards tilted{.boards = 8, .seed = 6};
  views[3] = synthetic_views(kPhone, bent)[0];
  views[3].photo = "bent";
  views[9] = synthetic_views(zoomed, tilted)[1];
  views[9].photo = "zoomed";
  views[12].width_px /= 2;
  views[12].photo = "small";
  const LensCalibration result = calibrated(views);
  EXPECT_EQ(left_out(result), "bent zoomed small ");
  EXPECT_NE(result.boards[12].reason.find("800 x 1200"), std::string::npos);
  EXPECT_GT(result.boards[3].rms_px, 5.0 * result.profile.rms_px);
  EXPECT_TRUE(says(result, "bent, zoomed and small"));
  EXPECT_LT(lens_difference(kPhone, result.profile.lens).max_px, 0.6);
}

TEST(CalibrateLens, PhotosOfAnotherCameraOrFocalLengthAreLeftOut) {
  auto views = synthetic_views(kPhone, {.boards = 8});
  for (BoardView& view : views) view.taken_with = {"Acme", "One", 24.0};
  views[2].taken_with.focal_mm = 35.0;
  views[4].taken_with = {};  // an editor dropped its EXIF
  const LensCalibration result = calibrated(views);
  EXPECT_EQ(left_out(result), "board2 ");
  EXPECT_NE(result.boards[2].reason.find("Acme One at 35 mm"), std::string::npos);
  EXPECT_EQ(result.profile.taken_with.focal_mm, 24.0);
}

TEST(CalibrateLens, BoardsFromTheFrontAreRefused) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const auto views = synthetic_views(kPhone, {.boards = 10, .largest_tilt = 0.03, .seed = seed});
    const LensCalibration result = calibrated(views);
    EXPECT_EQ(result.verdict, Verdict::refused);
    EXPECT_TRUE(says(result, "focal length"));
    EXPECT_TRUE(says(result, "tilt the board"));
  }
}

TEST(CalibrateLens, FewBoardsAreNamedAsTheReason) {
  const auto views = synthetic_views(kPhone, {.boards = 5});
  const LensCalibration five = calibrated(views);
  EXPECT_EQ(five.verdict, Verdict::usable);
  EXPECT_TRUE(says(five, "only 5 photos"));
  EXPECT_EQ(chosen_model(five), "opencv4");
  const LensCalibration two = calibrated({views.begin(), views.begin() + 2});
  EXPECT_EQ(two.verdict, Verdict::refused);
  EXPECT_TRUE(says(two, "only 2 photos"));
}

TEST(CalibrateLens, NamesThePartsOfThePictureWithoutABoard) {
  auto views = synthetic_views(kPhone, {.boards = 12});
  for (BoardView& view : views)
    std::erase_if(view.corners, [](const BoardCorner& corner) { return corner.pixel.x < 540.0; });
  const LensCalibration result = calibrated(views);
  EXPECT_EQ(result.verdict, Verdict::usable);
  EXPECT_TRUE(says(result, "top left, left and bottom left")) << result.sentences.front();
}

TEST(CalibrateLens, CornersThatNoLensExplainsAreRefused) {
  const LensCalibration result =
      calibrated(synthetic_views(kPhone, {.boards = 10, .noise_px = 3.0}));
  EXPECT_EQ(result.verdict, Verdict::refused);
  EXPECT_TRUE(says(result, "no lens explains"));
}

TEST(CalibrateLens, NoBoardInAnyPhotoIsAnError) {
  const std::vector<BoardView> views(4, {"empty", 1600, 1200, {}, {}});
  EXPECT_THROW(calibrated(views), Error);
  EXPECT_THROW(calibrated({}), Error);
}

TEST(CalibrateLens, StopsWhenAsked) {
  Progress progress;
  progress.cancel();
  const auto views = synthetic_views(kPhone, {.boards = 6});
  EXPECT_THROW(calibrate_lens(views, kShape, {}, progress), Cancelled);
}

TEST(CalibrateLens, TheSameBitsTwice) {
  const auto views = synthetic_views(kPhone, {.boards = 8, .gross_share = 0.02});
  const LensCalibration a = calibrated(views), b = calibrated(views);
  EXPECT_EQ(a.profile.lens, b.profile.lens);
  EXPECT_EQ(a.profile.uncertainty_px, b.profile.uncertainty_px);
}

// Where the solved lens sees what the true one sees at `pixel`, a point at infinity, once the mean
// turn of the boards is taken out: what the predicted uncertainty is about.
glm::dvec2 seen_by(const LensCalibration& result, const std::vector<RigidTransform>& poses,
                   const glm::dvec2& pixel) {
  glm::dvec3 mean_turn(0.0);
  for (std::size_t i = 0; i < poses.size(); ++i)
    mean_turn += rodrigues_from_rotation(result.boards[i].camera_from_board.rotation *
                                         glm::transpose(poses[i].rotation)) /
                 double(poses.size());
  const glm::dvec3 ray = camera_from_pixel(kPhone, pixel).value();
  return pixel_from_camera(result.profile.lens, rotation_from_rodrigues(mean_turn) * ray).value();
}

TEST(LensUncertainty, IsTheSpreadOverNoise) {
  constexpr int kSeeds = 60;
  const LensOptions plain{.model = "opencv4", .folds = 2, .board_warp = false};
  std::vector<RigidTransform> poses;
  const auto exact = synthetic_views(kPhone, {.boards = 8, .noise_px = 0.0}, &poses);
  double predicted_square = 0.0, spread_square = 0.0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const LensCalibration result = calibrated(with_noise(exact, 0.3, std::uint64_t(seed)), plain);
    const Image<float>& predicted = result.profile.uncertainty_px;
    for (int y = 0; y < predicted.height(); ++y)
      for (int x = 0; x < predicted.width(); ++x) {
        const glm::dvec2 pixel((x + 0.5) / predicted.width() * kPhone.width_px - 0.5,
                               (y + 0.5) / predicted.height() * kPhone.height_px - 0.5);
        const glm::dvec2 off = seen_by(result, poses, pixel) - pixel;
        predicted_square += double(predicted(x, y)) * predicted(x, y);
        spread_square += 0.5 * glm::dot(off, off);
      }
  }
  // 60 draws of about 8 parameters know the spread to 5 %.
  EXPECT_NEAR(std::sqrt(predicted_square / spread_square), 1.0, 0.25);
}

}  // namespace
}  // namespace bosk
