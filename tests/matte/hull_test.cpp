#include "core/matte/hull.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ring_of_cameras.h"

namespace bosk {
namespace {

Image<float> disc_in_the_middle() {
  Image<float> mean(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) mean(x, y) = std::hypot(x - 31.5, y - 31.5) < 12.0 ? 0.9f : 0.0f;
  }
  return mean;
}

struct Ring {
  Photos photos;
  std::vector<Image<float>> means;
};

Ring ring_of(int count, double arc) {
  Ring ring;
  for (int i = 0; i < count; ++i) {
    ring.photos.emplace_back();
    ring.photos.back().camera = camera_around(arc * i / count, 128, 128, 128.0);
    ring.means.push_back(disc_in_the_middle());
  }
  return ring;
}

AgreedVolume agreed(const Ring& ring) {
  Progress progress;
  return agreed_volume(ring.photos, ring.means, progress).value();
}

TEST(HullTilts, DoubtWhatOnePhotoAloneHoldsForTree) {
  Ring ring = ring_of(12, 6.283);
  for (int y = 28; y < 36; ++y) {
    for (int x = 2; x < 8; ++x) ring.means[5](x, y) = 0.9f;  // a distant tree beside ours
  }
  Progress progress;
  const auto tilts = hull_tilts(ring.photos, agreed(ring), 1.0f, progress);
  ASSERT_EQ(tilts.size(), 12u);
  EXPECT_LT(tilts[5](5, 32), -2.0f);
  EXPECT_EQ(tilts[5](32, 32), 0.0f);
}

TEST(HullTilts, LeaveTheTreeWhereOnePhotoOfManyMissedIt) {
  Ring ring = ring_of(12, 6.283);
  ring.means[3] = Image<float>(64, 64);
  Progress progress;
  const auto tilts = hull_tilts(ring.photos, agreed(ring), 1.0f, progress);
  EXPECT_EQ(tilts[3](32, 32), 0.0f);
}

TEST(HullTilts, SayNothingWithoutAWalkRoundTheTree) {
  Progress progress;
  const Ring frontal = ring_of(12, 0.3), few = ring_of(3, 6.283), around = ring_of(12, 6.283);
  EXPECT_FALSE(agreed_volume(frontal.photos, frontal.means, progress));
  EXPECT_FALSE(agreed_volume(few.photos, few.means, progress));
  const auto tilts = hull_tilts(around.photos, agreed(around), 0.0f, progress);
  for (const float value : tilts[0].pixels()) EXPECT_EQ(value, 0.0f);
}

TEST(HullTilts, SayNothingForPhotosWithoutCameras) {
  Ring ring = ring_of(12, 6.283);
  for (Photo& photo : ring.photos) photo.camera = Camera{};
  Progress progress;
  EXPECT_FALSE(agreed_volume(ring.photos, ring.means, progress));
}

}  // namespace
}  // namespace bosk
