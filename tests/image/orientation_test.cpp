#include "core/image/orientation.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace bosk {
namespace {

// The letter F, 3 wide and 5 tall, as EXIF's own picture of the eight orientations shows it.
Image<std::uint8_t> picture(int width, const std::string& rows) {
  Image<std::uint8_t> image(width, int(rows.size()) / width);
  for (std::size_t i = 0; i < rows.size(); ++i) image.data()[i] = rows[i] == '#';
  return image;
}
const Image<std::uint8_t> kUpright = picture(3, "####..##.#..#..");
const std::array<Image<std::uint8_t>, 8> kDelivered{
    picture(3, "####..##.#..#.."), picture(3, "###..#.##..#..#"), picture(3, "..#..#.##..####"),
    picture(3, "#..#..##.#..###"), picture(5, "######.#..#...."), picture(5, "#....#.#..#####"),
    picture(5, "....#..#.######"), picture(5, "#####..#.#....#")};

TEST(Upright, TurnsAllEightOrientations) {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    EXPECT_EQ(upright(kDelivered[std::size_t(orientation - 1)], orientation), kUpright)
        << orientation;
  }
}

TEST(Upright, GoesThereAndBack) {
  const glm::ivec2 size(30, 20);
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const glm::dvec2 pixel(7.25, 13.5);
    EXPECT_EQ(pixel_from_upright(upright_from_pixel(pixel, size, orientation), size, orientation),
              pixel);
  }
}

TEST(Upright, TakesAnUnknownOrientationForUpright) {
  EXPECT_EQ(upright_from_pixel({3.0, 4.0}, {30, 20}, 0), glm::dvec2(3.0, 4.0));
  EXPECT_EQ(upright_size({30, 20}, 9), glm::ivec2(30, 20));
}

TEST(CornerTextures, NameThePixelsThatStandInTheCorners) {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const Image<std::uint8_t>& delivered = kDelivered[std::size_t(orientation - 1)];
    const auto corners = corner_textures(orientation);
    const auto at = [&](std::size_t corner) {
      return delivered(int(corners[corner].x) * (delivered.width() - 1),
                       int(corners[corner].y) * (delivered.height() - 1));
    };
    EXPECT_EQ(at(0), 1) << orientation;  // of the F
    EXPECT_EQ(at(1), 1) << orientation;
    EXPECT_EQ(at(2), 0) << orientation;
    EXPECT_EQ(at(3), 1) << orientation;
  }
}

}  // namespace
}  // namespace bosk
