#include "core/matte/first_guess.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace bosk {
namespace {

constexpr int kWidth = 120, kHeight = 160;
const glm::vec3 kSky{0.55f, 0.7f, 0.9f}, kGrass{0.35f, 0.5f, 0.2f}, kLeaf{0.12f, 0.3f, 0.08f};

bool is_in_crown(int x, int y) {
  const double dx = x - 60.0, dy = y - 75.0;
  return dx * dx + dy * dy < 40.0 * 40.0;
}

// A round crown of leaves, a share of it gaps, before sky over grass; without cameras.
Photo photo_of_crown(double gaps, std::uint64_t seed = 1) {
  Photo photo;
  photo.name = "oak";
  photo.srgb = Image<glm::vec3>(kWidth, kHeight);
  Random random(seed);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool leaf = is_in_crown(x, y) && random.uniform() >= gaps;
      const glm::vec3 colour = leaf ? kLeaf : y < 120 ? kSky : kGrass;
      photo.srgb(x, y) = colour + 0.02f * float(random.normal());
    }
  }
  return photo;
}

bool is_leaf(const Photo& photo, int x, int y) {
  return glm::distance(photo.srgb(x, y), kLeaf) < 0.2f;
}

struct Told {
  int tree = 0, background = 0, wrong = 0;
};

Told told_by(const Photo& photo, const Image<std::uint8_t>& strokes) {
  Told told;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (strokes(x, y) == kNoStroke) continue;
      const bool tree = strokes(x, y) == kForegroundStroke;
      ++(tree ? told.tree : told.background);
      told.wrong += tree != is_leaf(photo, x, y);
    }
  }
  return told;
}

// Noise of 0.02 moves a few colours into cells of their own, about which nothing is said.
TEST(GuessStrokes, TellTheCrownFromItsSurroundings) {
  for (const double gaps : {0.1, 0.6}) {
    const Photo photo = photo_of_crown(gaps);
    Progress quiet;
    const Told told = told_by(photo, guess_strokes({photo}, quiet).at("oak"));
    EXPECT_GT(told.tree, 200) << gaps;
    EXPECT_GT(told.background, 1000) << gaps;
    EXPECT_LT(told.wrong, 0.01 * (told.tree + told.background)) << gaps;
  }
}

TEST(GuessStrokes, AreNoneWhereTheMiddleShowsNothingOfItsOwn) {
  Photo photo = photo_of_crown(1.0);
  Progress quiet;
  EXPECT_TRUE(guess_strokes({photo}, quiet).empty());
  photo.srgb = Image<glm::vec3>(kWidth, kHeight, glm::vec3(0.0f));
  EXPECT_TRUE(guess_strokes({photo}, quiet).empty());
}

TEST(GuessStrokes, LookAtThePlaceThatAllCamerasSee) {
  Photos photos;
  for (const double angle : {0.0, 1.5, 3.0, 4.5}) {
    Photo photo = photo_of_crown(0.2, std::uint64_t(angle * 10.0));
    photo.name = std::to_string(photos.size());
    Lens lens;
    lens.width_px = kWidth;
    lens.height_px = kHeight;
    lens.focal_px = {150.0, 150.0};
    lens.principal_px = {59.5, 79.5};
    const glm::dvec3 forward(-std::cos(angle), -std::sin(angle), 0.0), down(0.0, 0.0, -1.0);
    const glm::dmat3 turn = glm::transpose(glm::dmat3(glm::cross(down, forward), down, forward));
    photo.camera = {photo.name, lens, {turn, turn * (6.0 * forward)}};
    photos.push_back(photo);
  }
  Progress quiet;
  const Scribbles guess = guess_strokes(photos, quiet);
  for (const Photo& photo : photos) {
    const Told told = told_by(photo, guess.at(photo.name));
    EXPECT_GT(told.tree, 200);
    EXPECT_LT(told.wrong, 0.01 * (told.tree + told.background));
  }
}

TEST(GuessWhereNone, LeavesStrokesOfBothKindsAlone) {
  const Photo photo = photo_of_crown(0.2);
  Image<std::uint8_t> strokes(kWidth, kHeight, kNoStroke);
  strokes(0, 0) = kBackgroundStroke;
  strokes(60, 75) = kForegroundStroke;
  int warnings = 0;
  Progress progress({}, [&](const std::string&) { ++warnings; });
  EXPECT_EQ(guess_where_none({{"oak", strokes}}, {photo}, progress), Scribbles({{"oak", strokes}}));
  EXPECT_EQ(warnings, 0);
}

TEST(GuessWhereNone, DrawsStrokesOfOneKindOverTheGuessAndSaysSo) {
  const Photo photo = photo_of_crown(0.2);
  Image<std::uint8_t> strokes(kWidth, kHeight, kNoStroke);
  for (int x = 50; x < 70; ++x) strokes(x, 75) = kBackgroundStroke;
  std::string said;
  Progress progress({}, [&](const std::string& sentence) { said += sentence; });
  const Image<std::uint8_t> both =
      guess_where_none({{"oak", strokes}}, {photo}, progress).at("oak");
  EXPECT_TRUE(has_both_kinds(both));
  for (int x = 50; x < 70; ++x) EXPECT_EQ(both(x, 75), kBackgroundStroke);
  EXPECT_NE(said.find("the tree was guessed"), std::string::npos);
}

}  // namespace
}  // namespace bosk
