#include "core/image/image_io.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

std::vector<std::uint8_t> read_png(const std::filesystem::path& path, int& channels) {
  OIIO::ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path.string(), &hints);
  if (!input) return {};
  channels = input->spec().nchannels;
  std::vector<std::uint8_t> values(input->spec().image_bytes());
  input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, values.data());
  return values;
}

TEST(WritePng, KeepsEveryByteOfStraightAlpha) {
  const ScratchFolder folder;
  Image<glm::u8vec4> image(16, 16);
  for (int i = 0; i < 256; ++i) {
    image(i % 16, i / 16) = {std::uint8_t(i), std::uint8_t(255 - i), 77, std::uint8_t(i * 3)};
  }
  write_png(folder / "rgba.png", image);
  int channels = 0;
  const auto values = read_png(folder / "rgba.png", channels);
  ASSERT_EQ(channels, 4);
  for (std::size_t i = 0; i < 256; ++i) {
    for (int c = 0; c < 4; ++c) {
      EXPECT_EQ(values[4 * i + std::size_t(c)], image.pixels()[i][c]);
    }
  }
}

TEST(WritePng, WritesRgbAndGrey) {
  const ScratchFolder folder;
  write_png(folder / "rgb.png", Image<glm::u8vec3>(5, 3, glm::u8vec3(1, 2, 3)));
  write_png(folder / "grey.png", Image<std::uint8_t>(5, 3, 9));
  int channels = 0;
  EXPECT_EQ(read_png(folder / "rgb.png", channels)[14], 3);
  EXPECT_EQ(channels, 3);
  EXPECT_EQ(read_png(folder / "grey.png", channels)[14], 9);
  EXPECT_EQ(channels, 1);
}

TEST(WritePng, WritesTheSameBytesTwice) {
  const ScratchFolder folder;
  const Image<glm::u8vec3> image(33, 21, glm::u8vec3(10, 200, 30));
  write_png(folder / "a.png", image);
  write_png(folder / "b.png", image);
  EXPECT_EQ(read_file(folder / "a.png", 1 << 20), read_file(folder / "b.png", 1 << 20));
}

TEST(WritePng, RefusesAnEmptyImageAndAMissingFolder) {
  const ScratchFolder folder;
  EXPECT_THROW(write_png(folder / "a.png", Image<std::uint8_t>()), Error);
  EXPECT_THROW(write_png(folder / "no/a.png", Image<std::uint8_t>(2, 2)), Error);
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(ByteFromUnit, RoundsAndClamps) {
  for (int byte = 0; byte < 256; ++byte) EXPECT_EQ(byte_from_unit(float(byte) / 255.0f), byte);
  EXPECT_EQ(byte_from_unit(0.499f / 255.0f), 0);
  EXPECT_EQ(byte_from_unit(0.501f / 255.0f), 1);
  EXPECT_EQ(byte_from_unit(-3.0f), 0);
  EXPECT_EQ(byte_from_unit(7.0f), 255);
  EXPECT_EQ(byte_from_unit(std::nanf("")), 0);
}

TEST(OverColour, BlendsEncodedValues) {
  const Image<glm::vec4> half(1, 1, glm::vec4(0.2f, 0.4f, 0.6f, 0.5f));
  EXPECT_FLOAT_EQ(over_colour(half, glm::vec3(1.0f))(0, 0).g, 0.7f);
}

}  // namespace
}  // namespace bosk
