#include "core/matte/ground.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "ring_of_cameras.h"

namespace bosk {
namespace {

constexpr int kSize = 128;          // px, and as many cells: one pixel is one cell
constexpr double kHeight = -1.6;    // of the ground; the cameras are at 0
constexpr double kDistance = 10.0;  // of the cameras from the trunk
constexpr float kCircle = 6.2831853f;

struct Walk {
  Photos photos;
  std::vector<LabPlanes> samples;
};

// Lightness of the ground: waves 4 m long, so that heights a few cells off no longer agree.
float marks(double x, double y) {
  return 50.0f + 25.0f * float(std::sin(1.5 * x) * std::cos(1.5 * y));
}
float lawn(double, double) { return 50.0f; }

// Where the ray through a pixel meets the ground; none at the horizon and above.
std::optional<glm::dvec3> shown(const Camera& camera, int x, int y) {
  const Ray ray = world_ray(camera, {x, y}).value();
  if (ray.direction.z >= 0.0) return std::nullopt;
  return ray.origin + ray.direction * (kHeight - ray.origin.z) / ray.direction.z;
}

Walk walk(int count, float arc, float (*lightness)(double, double)) {
  Walk walk;
  for (int i = 0; i < count; ++i) {
    walk.photos.emplace_back();
    walk.photos.back().camera = camera_around(arc * float(i) / float(count), kSize, kSize, kSize);
    Image<float> l(kSize, kSize, 90.0f);  // the sky
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const auto place = shown(walk.photos.back().camera, x, y);
        if (place) l(x, y) = lightness(place->x, place->y);
      }
    }
    walk.samples.push_back({l, Image<float>(kSize, kSize), Image<float>(kSize, kSize)});
  }
  return walk;
}

// The cell of a photo that shows a place.
glm::ivec2 cell_of(const Photo& photo, const glm::dvec3& place) {
  const glm::dvec2 pixel = project(photo.camera, place).value();
  return {int(std::lround(pixel.x)), int(std::lround(pixel.y))};
}

TEST(FindGround, RecoversItsHeight) {
  const Walk round = walk(12, kCircle, marks);
  Progress progress;
  const auto ground = find_ground(round.photos, round.samples, progress);
  ASSERT_TRUE(ground);
  EXPECT_NEAR(ground->height_m, kHeight, kDistance / kSize);  // a cell at the trunk
}

TEST(FindGround, TellsWhatStandsBeforeTheGroundFromTheGround) {
  Walk round = walk(12, kCircle, marks);
  for (int y = 60; y < 90; ++y) {
    for (int x = 60; x < 68; ++x) round.samples[5].b(x, y) = 60.0f;  // a yellow post
  }
  Progress progress;
  const auto ground = find_ground(round.photos, round.samples, progress);
  ASSERT_TRUE(ground);
  const Image<float>& likeness = ground->likeness[5];
  EXPECT_EQ(likeness(64, 82), 0.0f);
  EXPECT_GT(likeness(40, 82), 0.9f);
  EXPECT_GT(ground->likeness[4](64, 82), 0.9f);
  EXPECT_EQ(likeness(40, 40), 0.0f);  // the sky
}

TEST(FindGround, SaysNothingOfALawnWithoutMarks) {
  const Walk round = walk(12, kCircle, lawn);
  Progress progress;
  EXPECT_FALSE(find_ground(round.photos, round.samples, progress));
}

TEST(FindGround, SaysNothingWithoutAWalkRoundTheTree) {
  const Walk frontal = walk(12, 0.3f, marks), few = walk(3, kCircle, marks);
  Progress progress;
  EXPECT_FALSE(find_ground(frontal.photos, frontal.samples, progress));
  EXPECT_FALSE(find_ground(few.photos, few.samples, progress));
}

TEST(FindGround, SameWithOneThreadAndMany) {
  const Walk round = walk(6, kCircle, marks);
  const auto with_threads = [&](std::size_t count) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    Progress progress;
    return find_ground(round.photos, round.samples, progress).value();
  };
  const Ground one = with_threads(1), many = with_threads(8);
  EXPECT_EQ(one.height_m, many.height_m);
  EXPECT_EQ(one.likeness, many.likeness);
}

TEST(GroundTilts, LeaveTheFootOfTheTrunk) {
  const Walk round = walk(12, kCircle, marks);
  Ground ground{kHeight, std::vector<Image<float>>(12, Image<float>(kSize, kSize, 1.0f))};
  AgreedVolume volume{glm::dvec3(0.0), 6.4, {}};  // cells of 0.2 m
  volume.alpha.resize(64 * 64 * 64);
  for (int z = 0; z < 64; ++z) {
    for (int y = 31; y <= 32; ++y) {
      for (int x = 31; x <= 32; ++x) volume.alpha[std::size_t((z * 64 + y) * 64 + x)] = 0.9f;
    }
  }
  Progress progress;
  const auto tilts = ground_tilts(round.photos, ground, volume, 2.0f, progress);
  const auto bare = ground_tilts(round.photos, ground, std::nullopt, 2.0f, progress);
  const glm::ivec2 foot = cell_of(round.photos[3], {0.0, 0.0, kHeight});
  const glm::ivec2 aside = cell_of(round.photos[3], {0.0, 2.0, kHeight});
  EXPECT_EQ(tilts[3](foot.x, foot.y), 0.0f);
  EXPECT_FLOAT_EQ(bare[3](foot.x, foot.y), 2.0f * kMostDoubt);
  EXPECT_FLOAT_EQ(tilts[3](aside.x, aside.y), 2.0f * kMostDoubt);
}

}  // namespace
}  // namespace bosk
