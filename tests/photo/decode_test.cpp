#include "core/photo/decode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/colour.h"
#include "core/photo/decode_protocol.h"
#include "tests/base/scratch_folder.h"
#include "tests/photo/photo_writer.h"

namespace bosk {
namespace {

using testing::Contains;
using testing::HasSubstr;

// One child for all tests of this file.
PhotoDecoder& decoder() {
  static PhotoDecoder one;
  return one;
}

DecodedPhoto decode(const std::filesystem::path& path) {
  const Progress quiet;
  return decoder().decode(path, quiet);
}

std::string refusal(const std::filesystem::path& path, const DecodeLimits& limits = {}) {
  const Progress quiet;
  try {
    decode_photo(path, limits, quiet);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// Greatest difference, in all channels that the file has, from what was written.
float worst_error(const DecodedPhoto& photo, const PhotoFile& written) {
  const Image<glm::vec4> straight = straight_of(photo);
  float worst = 0.0f;
  for (int y = 0; y < written.height; ++y) {
    for (int x = 0; x < written.width; ++x) {
      for (int c = 0; c < written.channels; ++c) {
        worst = std::max(worst, std::abs(straight(x, y)[c] - written.value(x, y, c)));
      }
    }
  }
  return worst;
}

float slope_of_16_bits(int x, int y, int channel) {
  return float(1000 * channel + 41 * x + 40 * 41 * y) / 65535.0f;
}

float half_clear(int x, int y, int channel) {
  return channel == 3 ? 128.0f / 255.0f : float(x + y + 10 * channel) / 255.0f;
}

TEST(DecodePhoto, ReadsEightBitsExactly) {
  const ScratchFolder folder;
  for (const char* name : {"a.png", "a.tif"}) {
    const PhotoFile file;
    ASSERT_TRUE(write_photo(folder / name, file));
    const DecodedPhoto photo = decode(folder / name);
    EXPECT_EQ(photo.kind, PixelKind::u8_srgb);
    EXPECT_LT(worst_error(photo, file), 1e-6f) << name;
  }
}

TEST(DecodePhoto, KeepsSixteenBits) {
  const ScratchFolder folder;
  for (const char* name : {"a.png", "a.tif"}) {
    const PhotoFile file{.type = OIIO::TypeDesc::UINT16, .value = slope_of_16_bits};
    ASSERT_TRUE(write_photo(folder / name, file));
    const DecodedPhoto photo = decode(folder / name);
    EXPECT_EQ(photo.kind, PixelKind::u16_srgb);
    EXPECT_LT(worst_error(photo, file), 0.1f / 65535.0f) << name;
  }
}

TEST(DecodePhoto, ReadsJpegWithinItsLoss) {
  const ScratchFolder folder;
  PhotoFile file;
  file.attributes.attribute("Compression", "jpeg:95");
  ASSERT_TRUE(write_photo(folder / "a.jpg", file));
  // Quality 95 on a gentle slope: a few steps of 1/255
  EXPECT_LT(worst_error(decode(folder / "a.jpg"), file), 6.0f / 255.0f);
}

TEST(DecodePhoto, ReadsHeif) {
  const ScratchFolder folder;
  const PhotoFile file{.width = 64, .height = 64};
  if (!write_photo(folder / "a.heic", file)) GTEST_SKIP() << "no HEIF encoder here";
  const DecodedPhoto photo = decode(folder / "a.heic");
  EXPECT_EQ(photo.format, PhotoFormat::heif);
  EXPECT_LT(worst_error(photo, file), 20.0f / 255.0f);
}

TEST(DecodePhoto, TurnsLinearLightOfOpenExrIntoSrgb) {
  const ScratchFolder folder;
  const PhotoFile file{.type = OIIO::TypeDesc::FLOAT};
  ASSERT_TRUE(write_photo(folder / "a.exr", file));
  const Image<glm::vec3> srgb = srgb_of(decode(folder / "a.exr"));
  EXPECT_NEAR(srgb(20, 10).r, srgb_from_linear(file.value(20, 10, 0)), 1e-5f);
}

TEST(DecodePhoto, CleansWhatIsNoNumber) {
  const ScratchFolder folder;
  const PhotoFile file{.type = OIIO::TypeDesc::FLOAT, .value = [](int x, int, int channel) {
                         if (x > 1 || channel > 0) return x == 2 ? -1.0f : 5.0f;
                         return x == 0 ? std::numeric_limits<float>::quiet_NaN()
                                       : std::numeric_limits<float>::infinity();
                       }};
  ASSERT_TRUE(write_photo(folder / "a.exr", file));
  const DecodedPhoto photo = decode(folder / "a.exr");
  EXPECT_THAT(photo.notes, Contains(HasSubstr("60 values were no numbers")));
  const Image<glm::vec3> srgb = srgb_of(photo);
  EXPECT_EQ(srgb(0, 0).r, 0.0f);
  EXPECT_EQ(srgb(1, 0).r, 0.0f);
  EXPECT_EQ(srgb(2, 0).r, 0.0f);
  EXPECT_EQ(srgb(3, 0).r, 1.0f);
}

TEST(DecodePhoto, KeepsAlphaStraight) {
  const ScratchFolder folder;
  for (const char* name : {"a.png", "a.tif"}) {
    const PhotoFile file{.channels = 4, .straight_alpha = true, .value = half_clear};
    ASSERT_TRUE(write_photo(folder / name, file));
    EXPECT_LT(worst_error(decode(folder / name), file), 1e-6f) << name;
  }
}

TEST(DecodePhoto, MakesPremultipliedAlphaStraight) {
  const ScratchFolder folder;
  const PhotoFile premultiplied{.channels = 4, .value = half_clear};
  ASSERT_TRUE(write_photo(folder / "a.tif", premultiplied));
  const Image<glm::vec4> straight = straight_of(decode(folder / "a.tif"));
  const float alpha = 128.0f / 255.0f;
  // Half a step of rounding, in the stored value, is divided by alpha
  EXPECT_NEAR(straight(20, 10).g, half_clear(20, 10, 1) / alpha, 1.1f / 255.0f);
  EXPECT_NEAR(straight(20, 10).a, alpha, 1e-6f);
}

TEST(DecodePhoto, SpreadsGreyOverRgb) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_photo(folder / "grey.png", {.channels = 1}));
  const Image<glm::vec4> straight = straight_of(decode(folder / "grey.png"));
  EXPECT_NEAR(straight(7, 0).b, 7.0f / 255.0f, 1e-6f);
  EXPECT_EQ(straight(7, 0).a, 1.0f);
}

TEST(DecodePhoto, ReadsExifAndLeavesThePixelsUnturned) {
  const ScratchFolder folder;
  PhotoFile file;
  file.attributes.attribute("Orientation", 6);
  file.attributes.attribute("Exif:FocalLength", 4.25f);
  file.attributes.attribute("Exif:FocalLengthIn35mmFilm", 26);
  file.attributes.attribute("ExposureTime", 0.01f);
  file.attributes.attribute("FNumber", 1.8f);
  file.attributes.attribute("Exif:PhotographicSensitivity", 100);
  file.attributes.attribute("Make", "Maker");
  file.attributes.attribute("Model", "Model 7");
  ASSERT_TRUE(write_photo(folder / "a.jpg", file));
  const DecodedPhoto photo = decode(folder / "a.jpg");
  EXPECT_EQ(photo.width_px, 40);
  EXPECT_EQ(photo.height_px, 30);
  EXPECT_EQ(photo.metadata.orientation, 6);
  EXPECT_NEAR(photo.metadata.focal_mm.value_or(0), 4.25, 1e-4);
  EXPECT_NEAR(photo.metadata.focal_35mm_equivalent_mm.value_or(0), 26.0, 1e-4);
  EXPECT_NEAR(photo.metadata.exposure_s.value_or(0), 0.01, 2e-6);  // a fraction of integers
  EXPECT_NEAR(photo.metadata.f_number.value_or(0), 1.8, 1e-4);
  EXPECT_NEAR(photo.metadata.iso.value_or(0), 100.0, 1e-4);
  EXPECT_EQ(photo.metadata.make, "Maker");
  EXPECT_EQ(photo.metadata.model, "Model 7");
}

TEST(DecodePhoto, GoesByContentNotByEnding) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_photo(folder / "a.jpg", {.plugin = "png"}));
  const DecodedPhoto photo = decode(folder / "a.jpg");
  EXPECT_EQ(photo.format, PhotoFormat::png);
  EXPECT_THAT(photo.notes, Contains(HasSubstr("PNG")));
}

TEST(DecodePhoto, RefusesMorePixelsThanAllowed) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_photo(folder / "a.png", {}));
  EXPECT_THAT(refusal(folder / "a.png", {.max_megapixels = 0.001, .child = {}}),
              HasSubstr("40 x 30"));
}

TEST(DecodePhoto, NamesTheFileWhenItIsMissing) {
  EXPECT_THAT(refusal("no/such/photo.jpg"), HasSubstr("no/such/photo.jpg"));
}

TEST(DecodePhoto, StopsWhenCancelled) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_photo(folder / "a.png", {}));
  Progress progress;
  progress.cancel();
  EXPECT_THROW(decode_photo(folder / "a.png", {}, progress), Cancelled);
}

TEST(PhotoSize, IsThatOfTheFileOrNone) {
  const ScratchFolder folder;
  const Progress quiet;
  ASSERT_TRUE(write_photo(folder / "a.png", {}));
  EXPECT_EQ(decoder().size(folder / "a.png", quiet), glm::ivec2(40, 30));
  EXPECT_EQ(decoder().size(folder / "b.png", quiet), std::nullopt);
}

TEST(DecodeMatte, TakesAlphaFromOneChannelOrFromRgba) {
  const ScratchFolder folder;
  const Progress quiet;
  ASSERT_TRUE(write_photo(folder / "grey.png", {.channels = 1, .type = OIIO::TypeDesc::UINT16}));
  ASSERT_TRUE(write_photo(folder / "grey.exr", {.channels = 1, .type = OIIO::TypeDesc::FLOAT}));
  ASSERT_TRUE(write_photo(folder / "rgba.png",
                          {.channels = 4, .straight_alpha = true, .value = half_clear}));
  for (const char* name : {"grey.png", "grey.exr"}) {
    const DecodedMatte matte = decoder().decode_matte(folder / name, quiet);
    EXPECT_FALSE(matte.has_colour);
    // Half a step of 16 bits, and single precision through the sRGB curve and back
    EXPECT_NEAR(matte.rgba(9, 3).a, 15.0f / 255.0f, 1e-5f) << name;
    EXPECT_EQ(matte.rgba(9, 3).r, 0.0f);
  }
  const DecodedMatte rgba = decoder().decode_matte(folder / "rgba.png", quiet);
  EXPECT_TRUE(rgba.has_colour);
  EXPECT_NEAR(rgba.rgba(9, 3).a, 128.0f / 255.0f, 1e-6f);
  EXPECT_NEAR(rgba.rgba(9, 3).g, 22.0f / 255.0f, 1e-6f);
}

TEST(DecodeMatte, RefusesColourWithoutAlphaButTakesGreyRgb) {
  const ScratchFolder folder;
  const Progress quiet;
  const auto grey = [](int x, int, int) { return float(x) / 255.0f; };
  ASSERT_TRUE(write_photo(folder / "grey.png", {.value = grey}));
  ASSERT_TRUE(write_photo(folder / "colour.png", {}));
  EXPECT_NEAR(decoder().decode_matte(folder / "grey.png", quiet).rgba(5, 5).a, 5.0f / 255.0f,
              1e-6f);
  EXPECT_THROW(decoder().decode_matte(folder / "colour.png", quiet), Error);
}

// The child has read a stranger's file: the parent believes nothing that doesn't add up.
TEST(DecodeProtocol, RefusesAnswersThatMakeNoSense) {
  DecodedPhoto photo;
  photo.width_px = 4;
  photo.height_px = 2;
  std::vector<std::byte> good(24);
  append_header(photo, good);
  EXPECT_EQ(decoded_photo(good, {}).width_px, 4);

  std::vector<std::byte> short_of_pixels(good.begin() + 1, good.end());
  EXPECT_THROW(decoded_photo(short_of_pixels, {}), Error);
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_THROW(decoded_photo({good.begin(), good.begin() + std::ptrdiff_t(size)}, {}), Error);
  }
  photo.width_px = -4;
  std::vector<std::byte> negative(24);
  append_header(photo, negative);
  EXPECT_THROW(decoded_photo(negative, {}), Error);
}

}  // namespace
}  // namespace bosk
