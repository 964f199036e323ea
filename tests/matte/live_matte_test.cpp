#include "core/matte/live_matte.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/image/area_mean.h"
#include "leafy_scene.h"
#include "ring_of_cameras.h"

namespace bosk {
namespace {

using testing::HasSubstr;

const LeafyScene& large_scene() {
  static const LeafyScene scene = leafy_scene({.width = 900, .height = 700});
  return scene;
}

LiveMatte live(const LeafyScene& scene, const Image<std::uint8_t>& strokes,
               const Image<float>& hull_tilt = Image<float>(1, 1)) {
  Progress progress;
  return live_matte(ready_for_live(scene.photo, progress), strokes, hull_tilt, {}, progress);
}

Image<std::uint8_t> only(Image<std::uint8_t> strokes, std::uint8_t kind) {
  for (std::uint8_t& stroke : strokes.pixels()) {
    if (stroke != kind) stroke = kNoStroke;
  }
  return strokes;
}

// On rendered trees the two differ by 0.008 to 0.012 (README.md); leaves here are simpler.
constexpr double kSameLook = 0.012;

TEST(LiveMatte, LooksLikeTheFullMatte) {
  const LeafyScene& scene = large_scene();
  Progress progress;
  const Mattes full = matte_photos({scene.photo}, {{"tree", scene.strokes}}, {}, progress);
  const LiveMatte small = live(scene, scene.strokes);
  const int width = small.matte.rgba.width(), height = small.matte.rgba.height();
  EXPECT_NEAR(width * height, 1e6 * kLiveMegapixels, 2000);
  EXPECT_LT(mean_absolute_error(alpha_of(small.matte.rgba),
                                area_mean(alpha_of(full[0].rgba), width, height)),
            kSameLook);
}

TEST(LiveMatte, IsOfTheTree) {
  const LeafyScene& scene = large_scene();
  const Image<float> alpha = alpha_of(live(scene, scene.strokes).matte.rgba);
  EXPECT_LT(mean_absolute_error(alpha, area_mean(scene.alpha, alpha.width(), alpha.height())),
            0.03);  // as the full matte's (matte_test.cpp)
}

TEST(LiveMatte, SaysWhatToDrawUntilThereAreStrokesOfBothKinds) {
  const LeafyScene scene = leafy_scene();
  const LiveMatte none = live(scene, {}), tree = live(scene, only(scene.strokes, 255)),
                  background = live(scene, only(scene.strokes, 0));
  for (const LiveMatte* matte : {&none, &tree, &background}) EXPECT_TRUE(matte->matte.rgba.empty());
  EXPECT_THAT(none.what_is_missing, HasSubstr("over the tree and over the background"));
  EXPECT_THAT(tree.what_is_missing, HasSubstr("over the background"));
  EXPECT_THAT(background.what_is_missing, HasSubstr("over the tree"));
  EXPECT_EQ(live(scene, scene.strokes).what_is_missing, "");
}

TEST(LiveMatte, ListensToTheOtherPhotos) {
  const LeafyScene scene = leafy_scene();
  Image<float> tilt(2, 1);
  tilt(1, 0) = -60.0f;  // no tree in the right half
  const Image<float> alpha = alpha_of(live(scene, scene.strokes, tilt).matte.rgba);
  double left = 0.0, right = 0.0;
  for (int y = 0; y < alpha.height(); ++y) {
    for (int x = 0; x < alpha.width() / 4; ++x) {
      left += alpha(alpha.width() / 4 + x, y);
      right += alpha(alpha.width() * 3 / 4 + x, y);
    }
  }
  EXPECT_GT(left, 100.0);
  EXPECT_LT(right, 0.01 * left);
}

TEST(LiveMatte, CopesWithStrokesOfASinglePixel) {
  const LeafyScene scene = leafy_scene();
  Image<std::uint8_t> strokes(180, 140, kNoStroke);
  strokes(90, 100) = kForegroundStroke;
  strokes(5, 5) = kBackgroundStroke;
  const Matte matte = live(scene, strokes).matte;
  ASSERT_EQ(matte.rgba.size(), scene.alpha.size());
  for (const glm::vec4& pixel : matte.rgba.pixels()) {
    for (int c = 0; c < 4; ++c) ASSERT_TRUE(pixel[c] >= 0.0f && pixel[c] <= 1.0f);
  }
}

TEST(LiveMatte, SameWithOneThreadAndMany) {
  const LeafyScene scene = leafy_scene();
  const auto with_threads = [&](std::size_t count) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    return live(scene, scene.strokes).matte.rgba;
  };
  EXPECT_EQ(with_threads(1), with_threads(8));
}

TEST(LiveMatte, StopsWhenAsked) {
  const LeafyScene scene = leafy_scene();
  Progress quiet;
  const LivePhoto photo = ready_for_live(scene.photo, quiet);
  Progress* job = nullptr;
  Progress progress([&](const ProgressReport&) { job->cancel(); }, {});
  job = &progress;
  EXPECT_THROW(live_matte(photo, scene.strokes, Image<float>(1, 1), {}, progress), Cancelled);
}

TEST(ReadyForLive, ShrinksTheCameraWithThePhoto) {
  Photo photo = large_scene().photo;
  photo.camera = camera_around(0.3, 900, 700, 900.0);
  Progress progress;
  const LivePhoto live = ready_for_live(photo, progress);
  const glm::dvec3 point(1.0, -0.4, 0.7);
  const double ratio = double(live.small.srgb.width()) / 900.0;
  const glm::dvec2 full = *project(live.full.camera, point),
                   small = *project(live.small.camera, point);
  EXPECT_NEAR(small.x, (full.x + 0.5) * ratio - 0.5, 0.5);  // both sides are whole pixels
  EXPECT_NEAR(small.y, (full.y + 0.5) * ratio - 0.5, 0.5);
}

TEST(HullTiltsFrom, AreAZeroPerPhotoWhereTheCamerasDoNotTell) {
  const LeafyScene scene = leafy_scene();
  Progress progress;
  const Mattes mattes{{"a", Image<glm::vec4>(180, 140)}, {"b", Image<glm::vec4>(180, 140)}};
  const auto tilts = hull_tilts_from({scene.photo, scene.photo}, mattes, {}, progress);
  ASSERT_EQ(tilts.size(), 2u);
  EXPECT_EQ(tilts[0], Image<float>(1, 1));
}

}  // namespace
}  // namespace bosk
