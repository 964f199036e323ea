#include "core/calibrate/features.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/calibrate/feature_poses.h"
#include "core/calibrate/feature_tracks.h"
#include "core/geometry/similarity.h"

namespace bosk {
namespace {

Lens lens_of_focal(double focal_px) {
  Lens lens;
  lens.width_px = 800;
  lens.height_px = 600;
  lens.focal_px = glm::dvec2(focal_px);
  lens.principal_px = {399.5, 299.5};
  return lens;
}

// A camera at `centre` that looks at the origin, z up.
Camera looking_at_origin(const glm::dvec3& centre, const Lens& lens) {
  const glm::dvec3 z = glm::normalize(-centre);
  const glm::dvec3 x = glm::normalize(glm::cross(z, glm::dvec3(0.0, 0.0, 1.0)));
  Camera camera;
  camera.lens = lens;
  camera.camera_from_world.rotation = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
  camera.camera_from_world.translation = -(camera.camera_from_world.rotation * centre);
  return camera;
}

struct Walk {
  std::vector<Camera> cameras;
  std::vector<BundleSighting> sightings;
};

// A quarter of a circle round a cloud of points, 0.5 px of noise, one sighting in ten far off.
Walk quarter_walk(int photos, int points) {
  Random random(5, 1);
  Walk walk;
  std::vector<glm::dvec3> cloud;
  for (int i = 0; i < points; ++i)
    cloud.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  for (int i = 0; i < photos; ++i) {
    const double angle = 1.5 * i / photos;
    walk.cameras.push_back(looking_at_origin(
        {6.0 * std::cos(angle), 6.0 * std::sin(angle), 1.0 + 0.2 * (i % 2)}, lens_of_focal(900)));
    for (int point = 0; point < points; ++point) {
      glm::dvec2 pixel = *project(walk.cameras.back(), cloud[std::size_t(point)]);
      const double reach = random.uniform() < 0.1 ? 60.0 : 0.9;
      pixel += glm::dvec2(random.uniform(-reach, reach), random.uniform(-reach, reach));
      walk.sightings.push_back({i, point, pixel, 0.5, true});
    }
  }
  return walk;
}

TEST(PlaceByFeatures, FindsPosesAndFocalLengthDespiteWrongMatches) {
  const Walk walk = quarter_walk(8, 150);
  Progress progress;
  const FeaturePoses found =
      place_by_features(walk.sightings, 8, 150, lens_of_focal(1080), false, progress);
  std::vector<glm::dvec3> ours, theirs;
  for (std::size_t i = 0; i < 8; ++i) {
    ASSERT_TRUE(found.camera_from_world[i]);
    ours.push_back(inverse(*found.camera_from_world[i]).translation);
    theirs.push_back(walk.cameras[i].centre_in_world());
  }
  EXPECT_NEAR(found.lens.focal_px.x, 900.0, 20.0);
  const Similarity fit = fit_similarity(ours, theirs);
  for (std::size_t i = 0; i < 8; ++i)  // 0.5 px at 6 m and 900 px is 3 mm a point
    EXPECT_LT(glm::distance(fit * ours[i], theirs[i]), 0.04);
  const auto agree = std::count(found.agrees.begin(), found.agrees.end(), true);
  EXPECT_NEAR(double(agree), 0.9 * 8 * 150, 0.06 * 8 * 150);
}

TEST(FindFeatures, SaysWhereTooFewWereMatched) {
  const Image<glm::vec3> fog(160, 120, glm::vec3(0.6f));
  const std::vector<FeaturePhoto> photos{
      {"a", &fog, nullptr}, {"b", &fog, nullptr}, {"c", &fog, nullptr}};
  Progress progress;
  const auto found = find_features(photos, lens_of_focal(160), false, {}, progress);
  EXPECT_FALSE(found.camera_from_world[0]);
  ASSERT_EQ(found.sentences.size(), 3u);
  EXPECT_NE(found.sentences[1].find("between photos a and b"), std::string::npos);
  EXPECT_NE(found.sentences[1].find("put markers around the tree"), std::string::npos);
}

// Blobs at random places.
Image<glm::vec3> speckled(const glm::ivec2& shift) {
  Random random(11, 1);
  Image<glm::vec3> image(240, 200, glm::vec3(0.2f));
  for (int i = 0; i < 250; ++i) {
    const glm::ivec2 at(int(random.uniform(10, 215)), int(random.uniform(10, 175)));
    const glm::vec3 grey(float(random.uniform(0.3, 1.0)));
    const int size = int(random.uniform(3, 9));
    for (int y = 0; y < size; ++y)
      for (int x = 0; x + y / 2 < size; ++x) image(at.x + x + shift.x, at.y + y + shift.y) = grey;
  }
  return image;
}

TEST(MatchFeatures, FollowsAPatternThatMoved) {
  const Image<glm::vec3> before = speckled({0, 0}), after = speckled({6, 3});
  const PhotoFeatures a = detect_features({"a", &before, nullptr}, 500);
  const PhotoFeatures b = detect_features({"b", &after, nullptr}, 500);
  const auto pairs = match_features(a, b, {});
  ASSERT_GT(pairs.size(), 60u);
  for (const auto& [i, j] : pairs)
    EXPECT_LT(glm::distance(a.pixel[std::size_t(i)] + glm::dvec2(6, 3), b.pixel[std::size_t(j)]),
              2.0);
}

TEST(DetectFeatures, StaysInTheMask) {
  const Image<glm::vec3> image = speckled({0, 0});
  Image<std::uint8_t> mask(240, 200, 0);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 100; ++x) mask(x, y) = 255;
  const PhotoFeatures features = detect_features({"a", &image, &mask}, 500);
  ASSERT_GT(features.pixel.size(), 20u);
  for (const glm::dvec2& pixel : features.pixel) EXPECT_LT(pixel.x, 100.5);
}

TEST(FeatureTracks, ChainMatchesAndDropContradictions) {
  std::vector<PhotoFeatures> photos(3);
  for (PhotoFeatures& photo : photos) photo.pixel.resize(4);
  const std::vector<FeatureMatches> matches{{0, 1, {{0, 1}, {2, 2}}},
                                            {1, 2, {{1, 3}, {2, 0}}},
                                            {0, 2, {{3, 0}}}};  // 0: 2 and 3 are one point
  const auto tracks = feature_tracks(photos, matches);
  ASSERT_EQ(tracks.size(), 1u);
  ASSERT_EQ(tracks[0].size(), 3u);
  EXPECT_EQ(tracks[0][2].photo, 2u);
  EXPECT_EQ(tracks[0][2].feature, 3);
}

}  // namespace
}  // namespace bosk
