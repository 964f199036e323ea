#include "core/phantom/photograph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/image/colour.h"

namespace bosk {
namespace {

// A black square card of one leaf-like facet at distance 10 before the camera at the origin.
Tree card(double half_size, double off_x) {
  const auto at = [&](double x, double y) {
    return glm::vec3(x * half_size + off_x, 10.0, y * half_size);
  };
  Tree tree;
  tree.vertices = {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)};
  tree.vertex_anchors = tree.vertices;
  tree.triangles = {{0, 1, 2}, {0, 2, 3}};
  tree.triangles_per_facet = 2;
  return tree;
}

Camera camera_along_y(int width, int height, double focal) {
  Camera camera{"000", {}, {}};
  camera.lens.width_px = width;
  camera.lens.height_px = height;
  camera.lens.focal_px = glm::dvec2(focal);
  camera.lens.principal_px = {(width - 1) / 2.0, (height - 1) / 2.0};
  camera.camera_from_world.rotation = glm::dmat3({1, 0, 0}, {0, 0, 1}, {0, -1, 0});
  return camera;
}

Studio studio_of(Tree tree) {
  Progress progress;
  return set_up_studio(std::move(tree), World{}, 16, progress);
}

Shot plain_shot() {
  Shot shot;
  shot.noise = 0.0;
  shot.background = false;
  return shot;
}

double alpha_sum(const Exposure& exposure) {
  double sum = 0.0;
  for (const glm::u8vec4& pixel : exposure.matte.pixels()) sum += pixel.a / 255.0;
  return sum;
}

TEST(RayScene, MeetsATriangleWhereGeometrySays) {
  const RayScene scene({{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}, {{0, 1, 2}});
  const RayHit hit = scene.first_hit({0.2f, 0.3f, 0.0f}, {0.0f, 0.0f, 0.5f});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit.distance, 4.0f, 1e-5f);  // float rounding
  EXPECT_NEAR(hit.u, 0.2f, 1e-5f);
  EXPECT_NEAR(hit.v, 0.3f, 1e-5f);
  EXPECT_GT(hit.normal.z, 0.0f);  // counter-clockwise seen from +z
  EXPECT_FALSE(scene.first_hit({0.6f, 0.6f, 0.0f}, {0.0f, 0.0f, 1.0f}));
  EXPECT_TRUE(scene.blocked({0.2f, 0.3f, 0.0f}, {0.0f, 0.0f, 1.0f}, 2.1f));
  EXPECT_FALSE(scene.blocked({0.2f, 0.3f, 0.0f}, {0.0f, 0.0f, 1.0f}, 1.9f));
}

TEST(Photograph, GivesACardItsAreaAsAlpha) {
  const Studio studio = studio_of(card(1.0, 0.13));
  const Camera camera = camera_along_y(40, 40, 100.0);
  Progress progress;
  const Exposure exposure = photograph(studio, camera, plain_shot(), progress);
  // 20 px x 20 px. The edge crosses 80 pixels; each stratified 8x8 pixel errs by about 1/64 there.
  EXPECT_NEAR(alpha_sum(exposure), 400.0, 4.0 * std::sqrt(80.0) / 64.0 + 80.0 / 512.0);
  EXPECT_EQ(exposure.matte(20, 20).a, 255);
  EXPECT_EQ(exposure.matte(5, 5), glm::u8vec4(0));
}

TEST(Photograph, PutsACardWhereTheLensModelPutsIt) {
  const double off = 2.4;
  const Studio studio = studio_of(card(0.3, off));
  Camera camera = camera_along_y(80, 40, 100.0);
  camera.lens.model = LensModel::opencv;
  camera.lens.distortion = {-0.2, 0.04, 0.01, -0.005};
  Progress progress;
  const Exposure exposure = photograph(studio, camera, plain_shot(), progress);
  glm::dvec2 centroid(0.0);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 80; ++x) centroid += exposure.matte(x, y).a / 255.0 * glm::dvec2(x, y);
  }
  centroid /= alpha_sum(exposure);
  const auto expected = project(camera, {off, 10.0, 0.0});
  ASSERT_TRUE(expected);
  // Sampling moves the centroid of 36 px by some 0.02 px; a pinhole would be 1 px away.
  EXPECT_NEAR(centroid.x, expected->x, 0.06);
  EXPECT_NEAR(centroid.y, expected->y, 0.06);
}

TEST(Photograph, PutsABallWhereItsTruthSays) {
  World world;
  // Below the ground, where it has no stick.
  world.markers = {{"red", {214, 24, 24}, {1.2, 10.0, -0.9}, 0.3}};
  Progress progress;
  const Studio studio = set_up_studio(card(0.1, -2.0), world, 16, progress);
  const Camera camera = camera_along_y(60, 40, 100.0);
  Shot shot = plain_shot();
  shot.background = true;
  const Exposure exposure = photograph(studio, camera, shot, progress);
  glm::dvec2 sum(0.0);
  double area = 0.0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 60; ++x) {
      sum += exposure.in_front(x, y) / 255.0 * glm::dvec2(x, y);
      area += exposure.in_front(x, y) / 255.0;
    }
  }
  EXPECT_NEAR(area, 28.6,
              0.6);  // pi (3 px)^2, 1% more for perspective, and the sampling of the rim
  const auto expected = project(camera, world.markers[0].centre);
  // The outline of a ball lies 0.015 px further out than its centre; sampling adds some 0.02 px.
  EXPECT_LT(glm::distance(sum / area, *expected), 0.06);
  EXPECT_EQ(visible_share(studio, camera, 0), 1.0);
}

TEST(Photograph, ShowsTheMatteOverBlackWhenThereIsNoBackground) {
  const Studio studio = studio_of(card(1.0, 0.13));
  Progress progress;
  const Exposure exposure =
      photograph(studio, camera_along_y(40, 40, 100.0), plain_shot(), progress);
  for (std::size_t i = 0; i < exposure.matte.size(); ++i) {
    const glm::vec4 matte = glm::vec4(exposure.matte.pixels()[i]) / 255.0f;
    const glm::vec3 photo = glm::vec3(exposure.photograph.pixels()[i]) / 255.0f;
    for (int c = 0; c < 3; ++c) {
      const float composed = matte.a * linear_from_srgb(matte[c]);
      // Half a step of 8 bits in the photograph and in the matte's colour and alpha.
      EXPECT_NEAR(srgb_from_linear(composed), photo[c], 1.5f / 255.0f);
    }
  }
}

TEST(Photograph, ScalesWithExposure) {
  const Studio studio = studio_of(card(1.0, 0.13));
  const Camera camera = camera_along_y(40, 40, 100.0);
  Progress progress;
  Shot shot = plain_shot();
  const glm::vec3 once(photograph(studio, camera, shot, progress).matte(20, 20));
  shot.exposure = 0.5;
  const glm::vec3 half(photograph(studio, camera, shot, progress).matte(20, 20));
  for (int c = 0; c < 3; ++c) {
    const float expected = srgb_from_linear(0.5f * linear_from_srgb(once[c] / 255.0f)) * 255.0f;
    EXPECT_NEAR(half[c], expected, 1.0f);  // rounding to 8 bits twice
  }
}

TEST(Photograph, StopsWhenAsked) {
  const Studio studio = studio_of(card(1.0, 0.0));
  Progress progress;
  progress.cancel();
  EXPECT_THROW(photograph(studio, camera_along_y(40, 40, 100.0), plain_shot(), progress),
               Cancelled);
}

}  // namespace
}  // namespace bosk
