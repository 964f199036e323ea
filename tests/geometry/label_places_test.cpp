#include "core/geometry/label_places.h"

#include <gtest/gtest.h>

namespace bosk {
namespace {

constexpr glm::dvec2 kLeast{0, 0}, kMost{200, 100};
constexpr double kGap = 5.0;
constexpr glm::dvec2 kWords{40, 10};

TEST(LabelPlaces, StandToTheRightOfALonePoint) {
  const PointLabel label[] = {{{100, 50}, kWords}};
  const auto places = label_places(label, kGap, kLeast, kMost);
  ASSERT_TRUE(places[0]);
  EXPECT_EQ(*places[0], glm::dvec2(105, 45));
}

TEST(LabelPlaces, StayWithinThePicture) {
  const PointLabel label[] = {{{180, 50}, kWords}};
  const auto places = label_places(label, kGap, kLeast, kMost);
  ASSERT_TRUE(places[0]);
  EXPECT_EQ(*places[0], glm::dvec2(135, 45));  // to the left
}

TEST(LabelPlaces, DoNotCoverEachOther) {
  const PointLabel labels[] = {{{100, 50}, kWords}, {{102, 54}, kWords}, {{98, 46}, kWords}};
  const auto places = label_places(labels, kGap, kLeast, kMost);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(places[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec2 apart = glm::abs(*places[i] - *places[j]);
      EXPECT_TRUE(apart.x >= kWords.x || apart.y >= kWords.y) << i << " over " << j;
    }
  }
}

TEST(LabelPlaces, LeavePointsFree) {
  const PointLabel labels[] = {{{100, 50}, kWords}, {{130, 50}, kWords}};
  const auto places = label_places(labels, kGap, kLeast, kMost);
  ASSERT_TRUE(places[0]);
  EXPECT_EQ(*places[0], glm::dvec2(55, 45));  // to the left: the other point is on the right
}

TEST(LabelPlaces, CoverPointsOnlyWhereTheyAreNeeded) {
  // Words too high for above and below, a point to either side
  PointLabel labels[] = {{{100, 50}, {40, 80}}, {{130, 50}, {}}, {{70, 50}, {}}};
  EXPECT_FALSE(label_places(labels, kGap, kLeast, kMost)[0]);
  labels[0].needed = true;
  EXPECT_TRUE(label_places(labels, kGap, kLeast, kMost)[0]);
}

TEST(LabelPlaces, LeaveOutTheLastWhereThereIsNoRoom) {
  const PointLabel labels[] = {
      {{100, 50}, {100, 90}, true}, {{100, 50}, {100, 90}, true}, {{100, 50}, {100, 90}, true}};
  const auto places = label_places(labels, 0.0, kLeast, kMost);
  EXPECT_TRUE(places[0]);
  EXPECT_TRUE(places[1]);
  EXPECT_FALSE(places[2]);
}

}  // namespace
}  // namespace bosk
