#include "core/calibrate/seed.h"

#include <gtest/gtest.h>

#include "core/calibrate/seed_pose.h"
#include "core/calibrate/seed_solve.h"
#include "orbit.h"
#include "orbit_bundle.h"

namespace bosk {
namespace {

std::vector<PoseSighting> seen_by(const Orbit& orbit, const Camera& camera) {
  std::vector<PoseSighting> result;
  for (const Sighting& sighting : exact_sightings(orbit, camera).sightings)
    result.push_back({orbit.place(sighting.point), *camera_from_pixel(camera.lens, sighting.pixel),
                      0.5 / camera.lens.focal_px.x});
  return result;
}

TEST(PlaceCamera, FindsThePoseThroughAGrossMistake) {
  const Orbit orbit = make_orbit({});
  for (const Camera& camera : orbit.cameras) {
    std::vector<PoseSighting> sightings = seen_by(orbit, camera);
    sightings[3].bearing = sightings[0].bearing;
    const auto poses = place_camera(sightings, 5.0);
    ASSERT_FALSE(poses.empty());
    EXPECT_LT(
        glm::length(inverse(poses[0].camera_from_world).translation - camera.centre_in_world()),
        1e-3);
  }
}

TEST(PlaceCamera, NeedsFourSightings) {
  const Orbit orbit = make_orbit({.markers = 3});
  EXPECT_TRUE(place_camera(seen_by(orbit, orbit.cameras[0]), 5.0).empty());
}

// The seed that wins on a walk.
std::string winner(const Orbit& orbit, bool orbits, bool pairs) {
  const OrbitBundle bundle = orbit_bundle(orbit);
  Progress progress;
  const SeedScene scene = seed_scene(bundle.problem, bundle.state.intrinsics, orbit.lens,
                                     orbit.cameras.size(), orbit.points.size());
  std::vector<Seed> seeds;
  if (orbits) seeds = orbit_seeds(scene);
  if (pairs)
    for (Seed& seed : pair_seeds(scene, 4, progress)) seeds.push_back(std::move(seed));
  const auto solved = solve_seeds(bundle.problem, scene, seeds, kFinalLoss, progress);
  // Half a pixel of noise costs two for each sighting less the unknowns, a mistake 25; a wrong walk
  // costs most sightings 25.
  const double usual = 4.0 * double(bundle.problem.sightings.size());
  return solved.empty() || solved[0].cost > usual ? "none" : solved[0].from;
}

TEST(Seeds, OrbitsKnowTheirDirection) {
  EXPECT_NE(winner(make_orbit({.seed = 3}), true, false), "none");
  EXPECT_NE(winner(make_orbit({.seed = 3, .turns = -1.0}), true, false), "none");
  EXPECT_NE(winner(make_orbit({.seed = 3, .turns = 0.5}), true, false), "none");
}

TEST(Seeds, PairsOfPhotosNeedNoOrder) {
  EXPECT_NE(winner(make_orbit({.seed = 4, .markers = 12, .jitter_deg = 180.0}), false, true),
            "none");
}

}  // namespace
}  // namespace bosk
