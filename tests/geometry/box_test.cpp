#include "core/geometry/box.h"

#include <gtest/gtest.h>

namespace bosk {
namespace {

const Box kBox{{-1, -2, -3}, {1, 2, 3}};

TEST(IntersectBox, EntersAndLeavesThroughOppositeFaces) {
  const auto span = intersect({{-5, 0, 0}, {1, 0, 0}}, kBox);
  ASSERT_TRUE(span);
  EXPECT_EQ(span->enter, 4.0);
  EXPECT_EQ(span->leave, 6.0);
}

TEST(IntersectBox, ARayFromInsideEntersAtZero) {
  const auto span = intersect({{0, 0, 0}, {0, 0, -1}}, kBox);
  ASSERT_TRUE(span);
  EXPECT_EQ(span->enter, 0.0);
  EXPECT_EQ(span->leave, 3.0);
}

TEST(IntersectBox, MissesBehindBesideAndInAFace) {
  EXPECT_FALSE(intersect({{5, 0, 0}, {1, 0, 0}}, kBox));
  EXPECT_FALSE(intersect({{-5, 2.5, 0}, {1, 0, 0}}, kBox));
  EXPECT_FALSE(intersect({{-5, 2, 0}, {1, 0, 0}}, kBox));
}

}  // namespace
}  // namespace bosk
