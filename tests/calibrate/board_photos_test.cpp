#include <gtest/gtest.h>

#include <algorithm>

#include "core/calibrate/boards.h"
#include "core/calibrate/lens_solve.h"
#include "tests/calibrate/board_phantom.h"
#include "tests/calibrate/synthetic_boards.h"

namespace bosk {
namespace {

Image<glm::vec3> srgb_of(const Image<glm::u8vec3>& photograph) {
  Image<glm::vec3> srgb(photograph.width(), photograph.height());
  std::transform(photograph.pixels().begin(), photograph.pixels().end(), srgb.pixels().begin(),
                 [](const glm::u8vec3& pixel) { return glm::vec3(pixel) / 255.0f; });
  return srgb;
}

// From rendered photos of a chessboard in the sun to the lens that rendered them.
TEST(BoardPhotos, GiveTheLensThatTookThem) {
  Progress quiet;
  const Phantom phantom = make_phantom(small_board_photos(1), quiet);
  const BoardShape shape{BoardKind::chessboard, phantom.board.columns - 1, phantom.board.rows - 1,
                         phantom.board.square};
  std::vector<BoardView> views;
  for (const PhantomView& photo : phantom.board_photos) {
    BoardView& view = views.emplace_back();
    view.photo = photo.camera.name;
    view.width_px = photo.photograph.width();
    view.height_px = photo.photograph.height();
    view.corners = find_board(grey_of(srgb_of(photo.photograph)), shape, quiet);
  }
  const auto found = std::count_if(views.begin(), views.end(),
                                   [](const BoardView& view) { return !view.corners.empty(); });
  EXPECT_GE(found, 7);  // some boards stand half outside the picture
  const LensCalibration result = calibrate_lens(views, shape, {}, quiet);
  EXPECT_NE(result.verdict, Verdict::refused) << result.sentences.front();
  EXPECT_LT(result.profile.rms_px, 0.15);
  const Lens& truth = phantom.board_photos.front().camera.lens;
  EXPECT_LT(lens_difference(truth, result.profile.lens).rms_px, 0.3);
  EXPECT_NEAR(result.profile.lens.focal_px.x / truth.focal_px.x, 1.0, 0.003);
}

}  // namespace
}  // namespace bosk
