#include "core/radiance/pose_refinement.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/geometry/rotation.h"
#include "core/phantom/phantom.h"
#include "core/radiance/volume_snapshot.h"
#include "tests/radiance/disturbed_poses.h"

namespace bosk {
namespace {

struct Capture {
  Photos photos;
  Mattes mattes;
  Box crown;
};

Capture make_capture() {
  PhantomOptions options = tiny_phantom();
  options.photos = 12;
  options.distortion = 0.0;
  options.markers = 0;
  Progress progress;
  const Phantom phantom = make_phantom(options, progress);
  Capture capture{pinhole_photos(phantom), {}, {}};
  for (std::size_t i = 0; i < phantom.photos.size(); ++i) {
    capture.mattes.push_back({capture.photos[i].name, straight_matte(phantom.photos[i])});
  }
  OpacityOptions coarse;
  coarse.finest_level = 5;
  capture.crown =
      snapshot_of(estimate_opacity(capture.photos, capture.mattes, coarse, progress)).bounds;
  return capture;
}

const Capture& made_up_capture() {
  static const Capture capture = make_capture();
  return capture;
}

PoseRefinementOptions whole_pictures() {
  PoseRefinementOptions options;
  options.longest_px = 128;
  options.rounds = 1;
  return options;
}

TEST(RefinePoses, TakesBackMostOfWhatTurnedTheCameras) {
  const Capture& capture = made_up_capture();
  const Photos photos = disturbed(capture.photos, 2.0, 3);
  Progress progress;
  const PoseRefinement refined = refine_poses(photos, capture.mattes, whole_pictures(), progress);
  EXPECT_TRUE(refined.accepted);
  EXPECT_LT(refined.error_after, refined.error_before);
  // Two thirds of the error: mattes of a tree of 100 px pin a pose to about half a pixel
  EXPECT_LT(rms_px(capture.photos, refined.camera_from_world, capture.crown),
            0.34 * rms_px(capture.photos, poses_of(photos), capture.crown));
}

TEST(RefinePoses, TruePosesStayAboutWhereTheyAre) {
  const Capture& capture = made_up_capture();
  Progress progress;
  const PoseRefinement refined =
      refine_poses(capture.photos, capture.mattes, whole_pictures(), progress);
  // Where mattes of a tree of 100 px pin a pose
  EXPECT_LT(rms_px(capture.photos, refined.camera_from_world, capture.crown), 0.6);
}

TEST(RefinePoses, PosesStayTheSameToTheBitWhereTheGainIsSmall) {
  const Capture& capture = made_up_capture();
  PoseRefinementOptions options = whole_pictures();
  options.least_gain = 0.99;
  Progress progress;
  const PoseRefinement refined = refine_poses(capture.photos, capture.mattes, options, progress);
  EXPECT_FALSE(refined.accepted);
  EXPECT_GT(refined.error_before, 0.0);
  for (std::size_t i = 0; i < capture.photos.size(); ++i) {
    const RigidTransform& pose = capture.photos[i].camera.camera_from_world;
    EXPECT_EQ(refined.camera_from_world[i].rotation, pose.rotation);
    EXPECT_EQ(refined.camera_from_world[i].translation, pose.translation);
    EXPECT_EQ(refined.moved_px[i], 0.0);
  }
}

TEST(RefinePoses, AsksForMorePhotos) {
  Capture capture = made_up_capture();
  capture.photos.resize(5);
  capture.mattes.resize(5);
  Progress progress;
  EXPECT_THROW(refine_poses(capture.photos, capture.mattes, {}, progress), Error);
}

TEST(RefinePoses, StopsWhenAsked) {
  const Capture& capture = made_up_capture();
  Progress progress;
  progress.cancel();
  EXPECT_THROW(refine_poses(capture.photos, capture.mattes, {}, progress), Cancelled);
}

TEST(Alignment, FindsTheMoveOfTheWorld) {
  const Capture& capture = made_up_capture();
  const Similarity move{1.02, rotation_from_rodrigues({0.01, -0.02, 0.015}), {0.05, 0.02, -0.03}};
  std::vector<Camera> wanted, given;
  for (const Photo& photo : capture.photos) {
    wanted.push_back(photo.camera);
    given.push_back(photo.camera);
    given.back().camera_from_world = moved(given.back().camera_from_world, inverse(move));
  }
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 1}, {0, 1, 2}, {-1, -1, 1}};
  const Similarity found = alignment(wanted, given, points);
  for (const glm::dvec3& point : points) {
    EXPECT_LT(glm::distance(found * point, move * point), 1e-6);  // Gauss-Newton, converged
  }
}

}  // namespace
}  // namespace bosk
