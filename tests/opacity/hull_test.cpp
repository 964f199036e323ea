#include "core/opacity/hull.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "ball_scene.h"
#include "core/base/error.h"

namespace bosk {
namespace {

std::vector<Silhouette> silhouettes_of(const Photos& photos, const Mattes& mattes) {
  std::vector<Silhouette> silhouettes;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    silhouettes.emplace_back(photos[i].camera, mattes[i].rgba, 0.0f);
  }
  return silhouettes;
}

std::vector<Silhouette> ball_silhouettes() {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 8);
  return silhouettes_of(photos, mattes_of(scene, photos));
}

TEST(FindCrown, HoldsTheBallTightly) {
  const BallScene scene;
  Progress progress;
  const Cube crown = find_crown(ball_silhouettes(), progress);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(crown.origin[axis], scene.centre()[axis] - scene.radius);
    EXPECT_GE(crown.origin[axis] + crown.size_m, scene.centre()[axis] + scene.radius);
  }
  // The hull of 8 views with pixels of 5 cm is some 1.3 balls; a free cell of 1/64 all around.
  EXPECT_LT(crown.size_m, 1.6 * 2.0 * scene.radius);
}

TEST(CarveHull, KeepsEveryCellInsideTheBall) {
  const BallScene scene;
  Progress progress;
  const std::vector<Silhouette> silhouettes = ball_silhouettes();
  const Cube cube{scene.centre() - 1.5, 3.0};
  const std::vector<glm::ivec3> cells = carve_hull(silhouettes, cube, 4, progress);
  std::set<std::array<int, 3>> kept;
  for (const glm::ivec3& cell : cells) kept.insert({cell.x, cell.y, cell.z});
  for (int i = 0; i < 4096; ++i) {
    const glm::ivec3 cell(i % 16, i / 16 % 16, i / 256);
    const glm::dvec3 centre = cube.origin + (glm::dvec3(cell) + 0.5) * cube.size_m / 16.0;
    if (glm::distance(centre, scene.centre()) > scene.radius) continue;
    EXPECT_TRUE(kept.contains({cell.x, cell.y, cell.z})) << "cell " << i;
  }
  EXPECT_LT(kept.size(), 2048u);  // the ball fills 16% of the cube
}

TEST(CarveHull, DropsWhatAnyOnePhotoSeesEmpty) {
  const BallScene scene;
  Progress progress;
  const Photos photos = ring_photos(scene, 8);
  Mattes mattes = mattes_of(scene, photos);
  const Cube cube{scene.centre() - 1.5, 3.0};
  const auto before = carve_hull(silhouettes_of(photos, mattes), cube, 5, progress);
  for (int y = 0; y < BallScene::kSize; ++y) {  // photo 3: clear left of the middle
    for (int x = 0; x < BallScene::kSize / 2; ++x) mattes[3].rgba(x, y) = glm::vec4(0.0f);
  }
  const auto after = carve_hull(silhouettes_of(photos, mattes), cube, 5, progress);
  EXPECT_LT(after.size(), before.size());
  for (const glm::ivec3& cell : after) {
    const double edge = cube.size_m / 32.0;
    const glm::dvec3 centre = cube.origin + (glm::dvec3(cell) + 0.5) * edge;
    // Half a cell's diagonal at 4 m or more and one pixel for the whole-pixel footprint.
    const double slack_px = 0.87 * edge * BallScene::kFocalPx / (BallScene::kDistance - 1.5) + 1.0;
    EXPECT_GE(project(photos[3].camera, centre)->x, BallScene::kSize / 2.0 - 0.5 - slack_px);
  }
}

TEST(CarveChildren, GivesCellsOfTheParentsAlone) {
  const BallScene scene;
  Progress progress;
  const Cube cube{scene.centre() - 1.5, 3.0};
  const std::vector<glm::ivec3> parents{{8, 8, 8}, {8, 8, 14}};  // the middle, clear air above
  const auto children = carve_children(ball_silhouettes(), cube, parents, 5, progress);
  EXPECT_EQ(children.size(), 8u);
  for (const glm::ivec3& child : children) EXPECT_EQ(child / 2, parents[0]);
}

TEST(Silhouette, SaysUnseenOfWhatReachesOutOfTheFrameOrBehindTheCamera) {
  const BallScene scene;
  const std::vector<Silhouette> silhouettes = ball_silhouettes();
  const glm::dvec3 eye = silhouettes[0].camera().centre_in_world();
  EXPECT_EQ(silhouettes[0].look_at(eye - 0.1, 0.2), Silhouette::Verdict::unseen);
  EXPECT_EQ(silhouettes[0].look_at(scene.centre() - 4.0, 8.0), Silhouette::Verdict::unseen);
  EXPECT_EQ(silhouettes[0].look_at(scene.centre() - 0.1, 0.2), Silhouette::Verdict::occupied);
}

TEST(FindCrown, NamesTheRemedyWhenViewsHaveNoVolumeInCommon) {
  const BallScene scene;
  Photos photos = ring_photos(scene, 8);
  const Mattes mattes = mattes_of(scene, photos);
  for (std::size_t i = 0; i < photos.size(); ++i) {  // every camera looks away from the others
    const glm::dvec3 eye = photos[i].camera.centre_in_world();
    photos[i].camera = camera_at(eye, eye + (eye - scene.centre()));
  }
  Progress progress;
  try {
    find_crown(silhouettes_of(photos, mattes), progress);
    FAIL() << "found a crown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("cameras and photos belong together"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace bosk
