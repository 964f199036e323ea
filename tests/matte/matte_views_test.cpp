#include "core/matte/matte_views.h"

#include <gtest/gtest.h>

#include <set>

#include "core/matte/scribbles.h"

namespace bosk {
namespace {

struct Scene {
  Image<glm::vec3> srgb{6, 4, glm::vec3(0.2f, 0.4f, 0.6f)};
  Image<glm::vec4> matte{6, 4, glm::vec4(0.8f, 0.6f, 0.4f, 0.5f)};
  Image<std::uint8_t> strokes;
  MattedPhoto parts() const { return {srgb, matte, strokes}; }
};

glm::ivec3 first_pixel(const Scene& scene, MatteView view) {
  return glm::ivec3(picture_of(view, scene.parts())(0, 0));
}

TEST(MatteViews, ShowThePhotoAsItIs) {
  EXPECT_EQ(first_pixel({}, MatteView::photo), glm::ivec3(51, 102, 153));
}

TEST(MatteViews, PutTheTreesOwnColourOverBlackAndWhite) {
  EXPECT_EQ(first_pixel({}, MatteView::on_black), glm::ivec3(102, 77, 51));
  EXPECT_EQ(first_pixel({}, MatteView::on_white), glm::ivec3(230, 204, 179));
}

TEST(MatteViews, ShowOpacityAsGrey) {
  EXPECT_EQ(first_pixel({}, MatteView::matte), glm::ivec3(128));
}

TEST(MatteViews, ShowThePureForegroundWhereThereIsAny) {
  Scene scene;
  EXPECT_EQ(first_pixel(scene, MatteView::foreground), glm::ivec3(204, 153, 102));
  scene.matte(0, 0).a = 0.0f;
  EXPECT_EQ(first_pixel(scene, MatteView::foreground), glm::ivec3(128));
}

TEST(MatteViews, DimTheBackgroundAloneInTheOverlay) {
  Scene scene;
  scene.matte(0, 0).a = 1.0f;
  EXPECT_EQ(first_pixel(scene, MatteView::overlay), glm::ivec3(51, 102, 153));
  scene.matte(0, 0).a = 0.0f;
  EXPECT_LT(first_pixel(scene, MatteView::overlay).g, 60);
}

TEST(MatteViews, ShowThePhotoWhereThereIsNoMatteYet) {
  Scene scene;
  scene.matte = {};
  for (int view = 0; view < kMatteViews; ++view) {
    EXPECT_EQ(first_pixel(scene, MatteView(view)), glm::ivec3(51, 102, 153)) << view;
  }
}

TEST(MatteViews, StretchASmallMatteOverThePhoto) {
  Scene scene;
  scene.matte = Image<glm::vec4>(3, 2, glm::vec4(1.0f, 1.0f, 1.0f, 0.0f));
  for (int y = 0; y < 2; ++y) scene.matte(2, y).a = 1.0f;
  const Image<glm::u8vec4> picture = picture_of(MatteView::matte, scene.parts());
  EXPECT_EQ(picture(0, 0).r, 0);
  EXPECT_EQ(picture(3, 1).r, 64);  // a quarter of the way between two of its pixels' centres
  EXPECT_EQ(picture(5, 3).r, 255);
}

TEST(MatteViews, TintStrokesInTwoColoursInEveryView) {
  Scene scene;
  scene.strokes = Image<std::uint8_t>(6, 4, kNoStroke);
  scene.strokes(1, 0) = kForegroundStroke;
  scene.strokes(2, 0) = kBackgroundStroke;
  for (int view = 0; view < kMatteViews; ++view) {
    const Image<glm::u8vec4> picture = picture_of(MatteView(view), scene.parts());
    EXPECT_GT(picture(1, 0).r, picture(1, 0).b) << view;  // amber
    EXPECT_GT(picture(2, 0).b, picture(2, 0).g) << view;  // indigo
    EXPECT_EQ(picture(0, 0), picture(3, 0)) << view;
  }
}

TEST(Repaint, MakesThePartAsPictureOfMakesTheWhole) {
  Scene scene;
  scene.matte = Image<glm::vec4>(3, 3);
  for (std::size_t i = 0; i < scene.matte.size(); ++i) {
    scene.matte.data()[i] = glm::vec4(0.1f * float(i), 0.5f, 0.3f, 0.12f * float(i));
  }
  const glm::u8vec4 untouched(1, 2, 3, 4);
  for (int view = 0; view < kMatteViews; ++view) {
    const Image<glm::u8vec4> whole = picture_of(MatteView(view), scene.parts());
    Image<glm::u8vec4> part(6, 4, untouched);
    repaint(MatteView(view), scene.parts(), {{2, 1}, {5, 9}}, part);
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 6; ++x) {
        const bool inside = x >= 2 && x < 5 && y >= 1;
        EXPECT_EQ(part(x, y), inside ? whole(x, y) : untouched) << view << ": " << x << ", " << y;
      }
    }
  }
}

TEST(Repaint, LeavesThePictureForABoxOutsideIt) {
  Scene scene;
  Image<glm::u8vec4> picture(6, 4);
  const Image<glm::u8vec4> before = picture;
  repaint(MatteView::photo, scene.parts(), {{-9, -9}, {-2, 3}}, picture);
  repaint(MatteView::photo, scene.parts(), {{6, 0}, {9, 3}}, picture);
  EXPECT_EQ(picture, before);
}

TEST(ViewAfter, GoesThroughAllSixAndComesBack) {
  std::set<MatteView> seen;
  MatteView view = MatteView::photo;
  for (int i = 0; i < kMatteViews; ++i) {
    EXPECT_TRUE(seen.insert(view).second);
    EXPECT_STRNE(name_of(view), "");
    view = view_after(view);
  }
  EXPECT_EQ(view, MatteView::photo);
}

}  // namespace
}  // namespace bosk
