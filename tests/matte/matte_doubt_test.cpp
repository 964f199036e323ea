#include "core/matte/matte_doubt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "leafy_scene.h"
#include "ring_of_cameras.h"

namespace bosk {
namespace {

using testing::HasSubstr;

// Trees of one kind around which one walked, with their true mattes.
struct Walk {
  Photos photos;
  Mattes mattes;
};

Walk walk_of(int count) {
  Walk walk;
  for (int i = 0; i < count; ++i) {
    const LeafyScene scene = leafy_scene({.leaf_seed = std::uint32_t(i + 1)});
    walk.photos.push_back(scene.photo);
    walk.photos.back().name = std::to_string(i);
    walk.photos.back().camera = camera_around(6.283 * i / count, 180, 140, 180.0);
    Matte matte{std::to_string(i), Image<glm::vec4>(180, 140)};
    for (std::size_t k = 0; k < matte.rgba.size(); ++k) {
      matte.rgba.data()[k] = glm::vec4(scene.photo.srgb.data()[k], scene.alpha.data()[k]);
    }
    walk.mattes.push_back(std::move(matte));
  }
  return walk;
}

std::vector<MatteDoubt> doubts_of(const Walk& walk) {
  Progress progress;
  return doubt_mattes(walk.photos, walk.mattes, progress);
}

std::string most_doubted(const std::vector<MatteDoubt>& doubts) {
  return std::max_element(doubts.begin(), doubts.end(),
                          [](const auto& p, const auto& q) { return p.doubt < q.doubt; })
      ->photo;
}

void set_alpha(Matte& matte, int from_row, int to_row, float alpha) {
  for (int y = from_row; y < to_row; ++y) {
    for (int x = 0; x < matte.rgba.width(); ++x) matte.rgba(x, y).a = alpha;
  }
}

TEST(DoubtMattes, HaveLittleToSayOfTrueMattes) {
  for (const MatteDoubt& doubt : doubts_of(walk_of(6))) EXPECT_LT(doubt.doubt, 0.05) << doubt.photo;
}

TEST(DoubtMattes, PutAMatteThatKeepsTheMeadowFirst) {
  Walk walk = walk_of(6);
  set_alpha(walk.mattes[2], 115, 140, 1.0f);
  const auto doubts = doubts_of(walk);
  EXPECT_EQ(most_doubted(doubts), "2");
  EXPECT_NE(doubts[2].reason, "");
}

TEST(DoubtMattes, NameTheBackgroundsColoursWithoutCameras) {
  Walk walk = walk_of(6);
  for (Photo& photo : walk.photos) photo.camera.camera_from_world = {};
  set_alpha(walk.mattes[2], 115, 140, 1.0f);
  const auto doubts = doubts_of(walk);
  EXPECT_EQ(most_doubted(doubts), "2");
  EXPECT_THAT(doubts[2].reason, HasSubstr("background in other photos"));
}

TEST(DoubtMattes, MissAPartOfTheTree) {
  Walk walk = walk_of(6);
  set_alpha(walk.mattes[4], 0, 60, 0.0f);
  const auto doubts = doubts_of(walk);
  EXPECT_EQ(most_doubted(doubts), "4");
  EXPECT_THAT(doubts[4].reason, HasSubstr("smaller"));
}

TEST(DoubtMattes, JudgeATreeBesideItsDistanceAndLens) {
  Walk walk = walk_of(6);
  walk.photos[1].camera.lens.focal_px *= 2.0;  // then the tree would be half as large
  EXPECT_EQ(most_doubted(doubts_of(walk)), "1");
  walk.photos[1].camera.camera_from_world.translation.z *= 2.0;  // but it is twice as far
  for (const MatteDoubt& doubt : doubts_of(walk)) EXPECT_LT(doubt.doubt, 0.05) << doubt.photo;
}

TEST(DoubtMattes, PutMattesWithoutAnyTreeBeforeAllOthers) {
  Walk walk = walk_of(2);
  set_alpha(walk.mattes[0], 0, 140, 0.0f);
  set_alpha(walk.mattes[1], 0, 140, 1.0f);
  const auto doubts = doubts_of(walk);
  EXPECT_EQ(doubts[0].doubt, 1.0);
  EXPECT_THAT(doubts[0].reason, HasSubstr("clear everywhere"));
  EXPECT_THAT(doubts[1].reason, HasSubstr("opaque everywhere"));
}

TEST(DoubtMattes, SayNothingOfOneOrTwo) {
  const auto doubts = doubts_of(walk_of(2));
  ASSERT_EQ(doubts.size(), 2u);
  EXPECT_EQ(doubts[0].doubt, 0.0);
  EXPECT_EQ(doubts[0].reason, "");
}

TEST(DoubtMattes, TakePhotosWithoutPixels) {
  Walk walk = walk_of(4);
  walk.photos[3].srgb = {};
  EXPECT_EQ(doubts_of(walk).size(), 4u);
}

}  // namespace
}  // namespace bosk
