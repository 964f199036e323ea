#include "ui/workstation/photos/photo_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/workstation/photos/photo_pictures.h"

namespace bosk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

PhotoFacts photo(int width, int height, int orientation = 1, double focal_mm = 35.0) {
  PhotoFacts facts;
  facts.decoded.width_px = width;
  facts.decoded.height_px = height;
  facts.decoded.metadata.orientation = orientation;
  facts.decoded.metadata.focal_mm = focal_mm;
  facts.decoded.metadata.make = "Acme";
  facts.decoded.metadata.model = "Acme One";
  return facts;
}

std::vector<std::string> remarks_on(const std::vector<PhotoFacts>& photos) {
  std::vector<const PhotoFacts*> pointers;
  for (const PhotoFacts& facts : photos) pointers.push_back(&facts);
  return set_remarks(pointers);
}

TEST(SetRemarks, AreNoneForPhotosOfOneKind) {
  EXPECT_THAT(remarks_on({photo(60, 40), photo(60, 40)}), IsEmpty());
  EXPECT_THAT(remarks_on({}), IsEmpty());
}

TEST(SetRemarks, CountSizesAndLenses) {
  EXPECT_THAT(remarks_on({photo(60, 40), photo(60, 40), photo(50, 40)}),
              ElementsAre(HasSubstr("1 of 50 x 40, 2 of 60 x 40")));
  EXPECT_THAT(remarks_on({photo(60, 40), photo(60, 40, 1, 50.0)}),
              ElementsAre(HasSubstr("1 of Acme One at 35 mm, 1 of Acme One at 50 mm")));
}

TEST(SetRemarks, TellUprightFromLyingAsTheyWereHeld) {
  EXPECT_THAT(remarks_on({photo(60, 40, 6), photo(60, 40, 8)}), IsEmpty());
  EXPECT_THAT(remarks_on({photo(60, 40, 6), photo(60, 40)}),
              ElementsAre(HasSubstr("1 photo upright beside 1 across")));
}

TEST(DetailsOf, SayWhatIsThereAndWhatIsnt) {
  PhotoFacts facts = photo(6000, 4000, 6);
  facts.decoded.metadata.exposure_s = 0.004;
  const Details details = details_of(facts, 8'200'000);
  const auto value = [&](const std::string& wanted) {
    for (const auto& [name, text] : details) {
      if (name == wanted) return text;
    }
    return std::string("no such detail");
  };
  EXPECT_EQ(value("Camera"), "Acme One");
  EXPECT_EQ(value("Focal length"), "35 mm");
  EXPECT_EQ(value("Exposure"), "1/250 s");
  EXPECT_EQ(value("ISO"), "not in the file");
  EXPECT_EQ(value("Size"), "6000 x 4000, 24.0 megapixels");
  EXPECT_THAT(value("Orientation"), HasSubstr("a quarter to the right"));
  EXPECT_EQ(value("File"), "JPEG, 8.2 MB");
}

// Left half black, right half white.
DecodedPhoto halves(int width, int height) {
  DecodedPhoto decoded;
  decoded.width_px = width;
  decoded.height_px = height;
  decoded.pixels.resize(std::size_t(3 * width * height));
  for (std::size_t i = 0; i < decoded.pixels.size(); ++i) {
    decoded.pixels[i] = std::byte(int(i / 3) % width < width / 2 ? 0 : 255);
  }
  return decoded;
}

TEST(ShownPhoto, IsSmallAndNeverEnlarged) {
  const Image<glm::u8vec4> small = shown_photo(halves(100, 50), 20);
  EXPECT_EQ(small.width(), 20);
  EXPECT_EQ(small.height(), 10);
  EXPECT_EQ(small(9, 5), glm::u8vec4(0, 0, 0, 255));
  EXPECT_EQ(small(10, 5), glm::u8vec4(255, 255, 255, 255));
  EXPECT_EQ(shown_photo(halves(10, 4), 20).width(), 10);
}

TEST(ShownPhoto, AveragesLightAndNotItsEncoding) {
  const Image<glm::u8vec4> one = shown_photo(halves(2, 2), 1);
  EXPECT_EQ(one(0, 0).r, 188);  // sRGB of half the light: 0.7354 x 255 = 187.5
}

TEST(ShownPhoto, StandsUpright) {
  DecodedPhoto lying = halves(40, 20);
  lying.metadata.orientation = 6;  // to be turned to the right: the left side comes up
  const Image<glm::u8vec4> upright = shown_photo(lying, 40);
  ASSERT_EQ(upright.width(), 20);
  ASSERT_EQ(upright.height(), 40);
  EXPECT_EQ(upright(10, 5).r, 0);
  EXPECT_EQ(upright(10, 35).r, 255);
}

}  // namespace
}  // namespace bosk
