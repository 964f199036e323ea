#include "core/calibrate/identify.h"

#include <gtest/gtest.h>

#include <set>

#include "core/calibrate/ball_colour.h"
#include "core/calibrate/colour_words.h"
#include "core/image/colour.h"

namespace bosk {
namespace {

const glm::vec3 kRed(0.84f, 0.1f, 0.1f), kYellow(0.95f, 0.84f, 0.04f), kBlue(0.1f, 0.25f, 0.84f);

// A ball in a photo of `exposure` times as much light.
SightedBall ball(const glm::vec3& srgb, float exposure = 1.0f, double stick = 6.0) {
  const glm::vec3 seen = saturation_from_lab(lab_from_linear(linear_from_srgb(srgb) * exposure));
  SightedBall sighted;
  sighted.centre_px = {100.0, 100.0};
  sighted.radius_px = 8.0;
  sighted.sigma_px = 0.1;
  sighted.saturation = glm::vec2(seen);
  sighted.lightness = seen.z;
  sighted.foot = StickFoot{{100.0, 100.0 + stick * sighted.radius_px}, 0.7};
  return sighted;
}

std::vector<std::string> photo_names(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back("p" + std::to_string(i));
  return names;
}

TEST(NameBalls, TellsColoursApartAtAnyExposure) {
  std::vector<std::vector<SightedBall>> photos;
  for (const float exposure : {1.0f, 0.4f, 0.7f, 0.25f})
    photos.push_back({ball(kYellow, exposure), ball(kRed, exposure), ball(kBlue, exposure)});
  const BallNames names = name_balls(photos, photo_names(4));
  EXPECT_TRUE(names.sentences.empty());
  for (const auto& photo : names.balls) {
    EXPECT_EQ(photo[0].name, "yellow");
    EXPECT_EQ(photo[1].name, "red");
    EXPECT_EQ(photo[2].name, "blue");
  }
}

TEST(NameBalls, LeavesOutTwoBallsOfOneColourAndSaysSo) {
  const std::vector<std::vector<SightedBall>> photos(
      5, std::vector<SightedBall>{ball(kRed), ball(kBlue), ball(kRed)});
  const BallNames names = name_balls(photos, photo_names(5));
  for (const auto& photo : names.balls) {
    EXPECT_EQ(photo[0].name, "");
    EXPECT_EQ(photo[1].name, "blue");
    EXPECT_EQ(photo[2].name, "");
  }
  ASSERT_EQ(names.sentences.size(), 1u);
  EXPECT_NE(names.sentences[0].find("more than one red ball"), std::string::npos);
}

TEST(NameBalls, LeavesOutAColourThatOnePhotoShows) {
  const std::vector<std::vector<SightedBall>> photos{{ball(kRed)}, {ball(kRed), ball(kBlue)}};
  const BallNames names = name_balls(photos, photo_names(2));
  EXPECT_EQ(names.balls[1][0].name, "red");
  EXPECT_EQ(names.balls[1][1].name, "");
}

TEST(NameBalls, DoubtsAFootThatEndsTheStickEarly) {
  std::vector<std::vector<SightedBall>> photos(6, std::vector<SightedBall>{ball(kRed)});
  photos[2] = {ball(kRed, 1.0f, 4.0)};
  const BallNames names = name_balls(photos, photo_names(6));
  EXPECT_TRUE(names.balls[1][0].foot_counts);
  EXPECT_FALSE(names.balls[2][0].foot_counts);
  EXPECT_EQ(ball_sightings(photos[1], names.balls[1]).size(), 2u);
  const auto sightings = ball_sightings(photos[2], names.balls[2]);
  ASSERT_EQ(sightings.size(), 1u);
  EXPECT_EQ(sightings[0].point, "red");
  EXPECT_EQ(sightings[0].by, SightedBy::ball);
}

TEST(ColourWords, AreAllDifferentWhateverTheOrder) {
  std::vector<glm::vec3> colours;
  for (const glm::vec3& srgb : {kRed, glm::vec3(0.6f, 0.06f, 0.06f), kBlue, kYellow})
    colours.push_back(saturation_from_lab(lab_from_srgb(srgb)));
  const auto words = colour_words(colours);
  EXPECT_EQ(std::set<std::string>(words.begin(), words.end()).size(), 4u);
  EXPECT_EQ(words[0], "red");
  EXPECT_EQ(words[1], "dark red");
  std::swap(colours[0], colours[1]);
  EXPECT_EQ(colour_words(colours)[0], "dark red");
}

}  // namespace
}  // namespace bosk
