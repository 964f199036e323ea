#include "core/calibrate/tags.h"

#include <gtest/gtest.h>

#include <opencv2/aruco.hpp>

#include "core/base/error.h"

namespace bosk {
namespace {

const Progress kQuiet;

// A white sheet with tags of 60 px, whose top left pixels are given.
Image<glm::vec3> sheet(int dictionary, const std::vector<std::pair<int, glm::ivec2>>& tags) {
  Image<glm::vec3> image(320, 240, glm::vec3(0.9f));
  for (const auto& [id, at] : tags) {
    cv::Mat tag;
    cv::aruco::drawMarker(cv::aruco::getPredefinedDictionary(dictionary), id, 60, tag);
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x)
        image(at.x + x, at.y + y) = glm::vec3(tag.at<std::uint8_t>(y, x) > 0 ? 0.9f : 0.05f);
  }
  return image;
}

TEST(FindTags, FindsCornersClockwiseFromTheTopLeft) {
  const auto image = sheet(cv::aruco::DICT_APRILTAG_36h11, {{7, {40, 50}}, {3, {180, 90}}});
  const auto tags = find_tags(image, "DICT_APRILTAG_36h11", kQuiet);
  ASSERT_EQ(tags.size(), 2u);
  EXPECT_EQ(tags[0].id, 3);
  EXPECT_EQ(tags[1].id, 7);
  const glm::dvec2 expected[4] = {{39.5, 49.5}, {99.5, 49.5}, {99.5, 109.5}, {39.5, 109.5}};
  for (std::size_t i = 0; i < 4; ++i)  // OpenCV follows the dark pixels' centres: half a pixel in
    EXPECT_LT(glm::distance(tags[1].corner_px[i], expected[i]), 0.8);
}

TEST(FindTags, LeavesOutAnIdThatShowsTwice) {
  const auto image =
      sheet(cv::aruco::DICT_ARUCO_ORIGINAL, {{5, {20, 20}}, {5, {120, 20}}, {9, {20, 120}}});
  const auto tags = find_tags(image, "DICT_ARUCO_ORIGINAL", kQuiet);
  ASSERT_EQ(tags.size(), 1u);
  EXPECT_EQ(tags[0].id, 9);
}

TEST(FindTags, ListsTheDictionariesWhenAskedForAnother) {
  try {
    find_tags(Image<glm::vec3>(32, 32), "DICT_9X9", kQuiet);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("DICT_APRILTAG_36h11"), std::string::npos);
  }
}

TEST(TagBodies, CarryTheNamesOfSightings) {
  const auto image = sheet(cv::aruco::DICT_4X4_50, {{2, {60, 60}}});
  const auto sightings = tag_sightings(find_tags(image, "DICT_4X4_50", kQuiet));
  const RigidBody body = tag_body(2, 0.1);
  ASSERT_EQ(sightings.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(sightings[i].point, body.points[i]);
  EXPECT_EQ(body.points[3], "tag 2/3");
  EXPECT_EQ(body.in_body[0], glm::dvec3(-0.05, 0.05, 0.0));
  EXPECT_EQ(body.in_body[2], glm::dvec3(0.05, -0.05, 0.0));
}

TEST(TagBodies, OfABoardRunAlongItsRows) {
  const TagBoard board{2, 3, 10, 0.04, 0.01};
  const RigidBody body = tag_board_body(board);
  ASSERT_EQ(body.points.size(), 24u);
  EXPECT_EQ(body.points[0], "tag 10/0");
  EXPECT_EQ(body.in_body[0], glm::dvec3(0.0, 0.14, 0.0));
  EXPECT_EQ(body.points[4], "tag 11/0");
  EXPECT_EQ(body.in_body[4], glm::dvec3(0.05, 0.14, 0.0));
  EXPECT_EQ(body.points[20 + 3], "tag 15/3");
  EXPECT_EQ(body.in_body[20 + 3], glm::dvec3(0.05, 0.0, 0.0));
}

}  // namespace
}  // namespace bosk
