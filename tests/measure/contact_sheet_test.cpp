#include "core/measure/contact_sheet.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace bosk {
namespace {

using Picture = Image<glm::u8vec4>;

TEST(DifferencePicture, IsBlackWhereEqualAndThreefoldElsewhere) {
  Picture truth(2, 1, {100, 100, 100, 255}), rendered = truth;
  rendered(1, 0) = {110, 100, 0, 255};
  const Image<glm::u8vec3> difference = difference_picture(rendered, truth);
  EXPECT_EQ(difference(0, 0), glm::u8vec3(0));
  EXPECT_EQ(difference(1, 0), glm::u8vec3(30, 0, 255));
}

TEST(ContactSheet, ShowsPhotoRenderAndDifferenceSideBySide) {
  const Picture photo(40, 60, {200, 0, 0, 255}), render(40, 60, {0, 200, 0, 255});
  const Image<glm::u8vec3> sheet = contact_sheet({{"one", photo, render}}, 400);
  // Columns are at least 120 px, gaps 10, headings 22; nothing is enlarged.
  EXPECT_EQ(sheet.width(), 10 + 3 * 130);
  EXPECT_EQ(sheet.height(), 32 + 60 + 32);
  EXPECT_EQ(sheet(10 + 20, 32 + 30), glm::u8vec3(200, 0, 0));
  EXPECT_EQ(sheet(140 + 20, 32 + 30), glm::u8vec3(0, 200, 0));
  EXPECT_EQ(sheet(270 + 20, 32 + 30), glm::u8vec3(255, 255, 0));
  EXPECT_EQ(sheet(10 + 60, 32 + 30), glm::u8vec3(255));
}

TEST(ContactSheet, ShrinksLargePicturesToTheCell) {
  const Picture photo(800, 400, {9, 9, 9, 255});
  const Image<glm::u8vec3> sheet = contact_sheet({{"", photo, photo}, {"", photo, photo}}, 200);
  EXPECT_EQ(sheet.width(), 10 + 3 * 210);
  EXPECT_EQ(sheet.height(), 32 + 2 * (100 + 32));
}

TEST(ContactSheet, CutsAwayWhatBothLeaveClear) {
  Picture photo(300, 200, {0, 0, 0, 0}), render = photo;
  photo(100, 50) = {200, 0, 0, 255};   // 8 px around both: x 92 to 118, y 42 to 98
  render(110, 90) = {0, 200, 0, 255};  // also what only the rendered view shows
  const Image<glm::u8vec3> sheet = contact_sheet({{"", photo, render}}, 400);
  EXPECT_EQ(sheet.height(), 32 + 57 + 32);
  EXPECT_EQ(sheet(10 + 8, 32 + 8), glm::u8vec3(200, 0, 0));
  EXPECT_EQ(sheet(140 + 18, 32 + 48), glm::u8vec3(0, 200, 0));
}

TEST(ContactSheet, ShowsClearPicturesWhole) {
  const Picture clear(30, 20, {0, 0, 0, 0});
  EXPECT_EQ(contact_sheet({{"", clear, clear}}, 400).height(), 32 + 20 + 32);
}

TEST(ContactSheet, RefusesARowOfTwoSizes) {
  EXPECT_THROW(contact_sheet({{"x", Picture(4, 4), Picture(4, 5)}}, 100), Error);
}

}  // namespace
}  // namespace bosk
