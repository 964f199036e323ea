#include "core/project/stored_images.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace bosk {
namespace {

constexpr float kHalfStep = 0.5f / 65535.0f + 1e-7f;  // of 16 bits, and of rounding in float

Photos some_photos() {
  Photo photo;
  photo.name = "a";
  photo.camera.name = "a";
  photo.camera.lens = {LensModel::pinhole, 3, 2, {100.5, 101.5}, {1.0, 0.5}, {}};
  photo.camera.camera_from_world.translation = {0.1, 0.2, 0.3};
  photo.original_camera = photo.camera;
  photo.original_camera.lens.model = LensModel::opencv;
  photo.original_camera.lens.distortion[1] = 0.01;
  photo.srgb = Image<glm::vec3>(3, 2);
  for (std::size_t i = 0; i < photo.srgb.size(); ++i) {
    photo.srgb.data()[i] = glm::vec3(0.1f, 0.5f, 0.9f) * (float(i) / 5.0f);
  }
  return {photo};
}

Photos read_back(const Photos& photos) {
  BinaryWriter writer;
  write_stored(writer, photos);
  BinaryReader reader(writer.bytes());
  Photos read = read_stored_photos(reader);
  EXPECT_TRUE(reader.at_end());
  return read;
}

TEST(StoredImages, KeepPhotosToSixteenBits) {
  const Photos photos = some_photos();
  const Photos read = read_back(photos);
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].name, "a");
  EXPECT_EQ(read[0].camera.lens, photos[0].camera.lens);
  EXPECT_EQ(read[0].original_camera.lens, photos[0].original_camera.lens);
  EXPECT_EQ(read[0].camera.camera_from_world.translation, glm::dvec3(0.1, 0.2, 0.3));
  for (std::size_t i = 0; i < photos[0].srgb.size(); ++i) {
    const glm::vec3 difference = read[0].srgb.data()[i] - photos[0].srgb.data()[i];
    EXPECT_LE(glm::length(difference), 2.0f * kHalfStep);
  }
}

TEST(StoredImages, ChangeNothingTheSecondTime) {
  const Photos once = read_back(some_photos());
  EXPECT_EQ(read_back(once)[0].srgb, once[0].srgb);
}

TEST(StoredImages, MakeMattesColourlessWhereTheyAreClear) {
  Image<glm::vec4> rgba(2, 1, {0.25f, 0.5f, 0.75f, 1.0f});
  rgba(1, 0).a = 0.0f;
  BinaryWriter writer;
  write_stored(writer, Mattes{{"a", rgba}});
  BinaryReader reader(writer.bytes());
  const Mattes read = read_stored_mattes(reader);
  EXPECT_NEAR(read[0].rgba(0, 0).g, 0.5f, kHalfStep);
  EXPECT_EQ(read[0].rgba(0, 0).a, 1.0f);
  EXPECT_EQ(read[0].rgba(1, 0), glm::vec4(0.0f));
}

TEST(StoredImages, ClampWhatIsOutOfRangeOrNoNumber) {
  Photos photos = some_photos();
  photos[0].srgb(0, 0) = {-1.0f, 2.0f, std::numeric_limits<float>::quiet_NaN()};
  EXPECT_EQ(read_back(photos)[0].srgb(0, 0), glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST(StoredImages, RefuseACutRecord) {
  BinaryWriter writer;
  write_stored(writer, some_photos());
  for (std::size_t size = 0; size < writer.bytes().size(); ++size) {
    BinaryReader reader(std::span(writer.bytes()).first(size));
    EXPECT_THROW(read_stored_photos(reader), Error) << size;
  }
}

}  // namespace
}  // namespace bosk
