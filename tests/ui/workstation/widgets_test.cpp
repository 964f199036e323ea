#include <gtest/gtest.h>

#include <cmath>

#include "ui/widgets/image_view.h"
#include "ui/widgets/pictures.h"
#include "ui/widgets/plot.h"

namespace bosk {
namespace {

TEST(ImageView, MapsPixelsToTheScreenAndBack) {
  const ImageView view{4.0, {0.3, 0.6}};
  const ImagePlace place = place_of(view, {600, 400}, {100, 50}, {900, 650});
  const glm::dvec2 pixel(123.25, 87.5);
  const glm::dvec2 back = place.picture_from_screen(place.screen_from_picture(pixel));
  EXPECT_NEAR(back.x, pixel.x, 1e-9);
  EXPECT_NEAR(back.y, pixel.y, 1e-9);
}

TEST(ImageView, AtZoomOneShowsAllOfThePictureInTheMiddle) {
  const ImagePlace place = place_of({}, {600, 400}, {0, 0}, {600, 600});
  EXPECT_DOUBLE_EQ(place.scale, 1.0);
  EXPECT_DOUBLE_EQ(place.screen_from_picture({-0.5, -0.5}).y, 100.0);
  EXPECT_DOUBLE_EQ(place.screen_from_picture({599.5, 399.5}).x, 600.0);
}

TEST(ImageView, ZoomKeepsWhatIsUnderTheMouse) {
  ImageView view;
  for (int i = 0; i < 5; ++i) {
    const ImagePlace place = place_of(view, {600, 400}, {0, 0}, {600, 400});
    const glm::dvec2 pixel(310, 190), before = place.screen_from_picture(pixel);
    view = zoomed(view, place, pixel, 1.5);
    const glm::dvec2 after =
        place_of(view, {600, 400}, {0, 0}, {600, 400}).screen_from_picture(pixel);
    EXPECT_NEAR(after.x, before.x, 1e-9);
    EXPECT_NEAR(after.y, before.y, 1e-9);
  }
}

TEST(ImageView, NeverZoomsOutOfThePicture) {
  const ImagePlace place = place_of({}, {600, 400}, {0, 0}, {600, 400});
  EXPECT_EQ(zoomed({}, place, {0, 0}, 0.1), ImageView());
  EXPECT_DOUBLE_EQ(zoomed({}, place, {0, 0}, 1e9).zoom, kMostZoom);
}

struct CountingDevice {
  int made = 0, freed = 0;
  PictureDevice device() {
    return {[this](const Image<glm::u8vec4>&, ImTextureID old) {
              if (old) return old;
              ++made;
              return reinterpret_cast<ImTextureID>(std::intptr_t(made));
            },
            [this](ImTextureID) { ++freed; }};
  }
};

TEST(Pictures, MakeAPictureOncePerRevision) {
  CountingDevice counting;
  Pictures pictures(counting.device());
  int made = 0;
  const auto make = [&] { return ++made, Image<glm::u8vec4>(4, 3); };
  for (int i = 0; i < 3; ++i) pictures.show("a", 1, make);
  EXPECT_EQ(made, 1);
  const Texture texture = pictures.show("a", 2, make);
  EXPECT_EQ(made, 2);
  EXPECT_EQ(counting.made, 1) << "the same size goes into the same texture";
  EXPECT_EQ(texture.size_px, glm::ivec2(4, 3));
}

TEST(Pictures, FreeWhatIsOutOfSightAndAllAtTheEnd) {
  CountingDevice counting;
  {
    Pictures pictures(counting.device());
    pictures.show("a", 1, [] { return Image<glm::u8vec4>(4, 3); });
    for (int i = 0; i < 1000; ++i) {
      pictures.show("b", 1, [] { return Image<glm::u8vec4>(2, 2); });
      pictures.end_frame();
    }
    EXPECT_EQ(counting.freed, 1);
    EXPECT_EQ(pictures.size(), 1u);
  }
  EXPECT_EQ(counting.freed, counting.made);
}

TEST(Pictures, AnEmptyPictureIsNone) {
  CountingDevice counting;
  Pictures pictures(counting.device());
  EXPECT_FALSE(pictures.show("a", 1, [] { return Image<glm::u8vec4>(); }));
}

TEST(PlotTicks, AreRoundAndWithinTheAxis) {
  EXPECT_EQ(ticks({"", false, 0.0, 10.0}, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(ticks({"", true, 16, 128}, 5), (std::vector<double>{16, 32, 64, 128}));
  EXPECT_TRUE(ticks({"", true, 0, 128}, 5).empty()) << "log of zero";
  EXPECT_TRUE(ticks({"", false, 3, 3}, 5).empty());
  EXPECT_TRUE(ticks({"", false, 0, NAN}, 5).empty());
}

}  // namespace
}  // namespace bosk
