#include "ball_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace bosk {
namespace {

constexpr glm::vec3 kRed{0.8f, 0.2f, 0.1f}, kGreen{0.1f, 0.6f, 0.2f};

// Colour and alpha of a stretch of the ray in one half of the ball.
glm::vec4 stretch(const glm::vec3& colour, double depth) {
  const auto alpha = float(1.0 - std::exp(-depth));
  return {colour * alpha, alpha};
}

}  // namespace

glm::vec4 BallScene::along(const glm::dvec3& eye, const glm::dvec3& unit_direction) const {
  const glm::dvec3 from = eye - centre();
  const double b = glm::dot(from, unit_direction);
  const double root = b * b - glm::dot(from, from) + radius * radius;
  if (root <= 0.0) return glm::vec4(0.0f);
  const double enter = -b - std::sqrt(root), leave = -b + std::sqrt(root);
  const auto colour_at = [&](double s) {
    return !split || eye.x + s * unit_direction.x > 0.0 ? kRed : kGreen;
  };
  double middle = enter;  // where the ray crosses x = 0
  if (unit_direction.x != 0.0) middle = std::clamp(-eye.x / unit_direction.x, enter, leave);
  const glm::vec4 front = stretch(colour_at(0.5 * (enter + middle)), extinction * (middle - enter));
  const glm::vec4 back = stretch(colour_at(0.5 * (middle + leave)), extinction * (leave - middle));
  const glm::vec4 sum = front + (1.0f - front.a) * back;
  return sum.a > 0.0f ? glm::vec4(glm::vec3(sum) / sum.a, sum.a) : sum;
}

Camera camera_at(const glm::dvec3& eye, const glm::dvec3& target) {
  const glm::dvec3 forward = glm::normalize(target - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 down = glm::cross(forward, right);
  const glm::dmat3 camera_from_world = glm::transpose(glm::dmat3(right, down, forward));
  Camera camera;
  camera.lens.width_px = camera.lens.height_px = BallScene::kSize;
  camera.lens.focal_px = glm::dvec2(BallScene::kFocalPx);
  camera.lens.principal_px = glm::dvec2(0.5 * BallScene::kSize - 0.5);
  camera.camera_from_world = {camera_from_world, -(camera_from_world * eye)};
  return camera;
}

glm::dvec3 ring_place(const BallScene& scene, double turn, double height) {
  const double across = std::sqrt(BallScene::kDistance * BallScene::kDistance - height * height);
  return scene.centre() + glm::dvec3(across * std::cos(turn), across * std::sin(turn), height);
}

Photos ring_photos(const BallScene& scene, int count) {
  Photos photos;
  for (int i = 0; i < count; ++i) {
    const double turn = 2.0 * std::numbers::pi * (i + 0.25) / count;
    Photo photo;
    photo.name = "ring" + std::to_string(i);
    photo.camera = camera_at(ring_place(scene, turn, i % 2 == 0 ? -1.5 : 1.5), scene.centre());
    photo.camera.name = photo.name;
    photo.original_camera = photo.camera;
    photos.push_back(photo);
  }
  return photos;
}

Matte matte_of(const BallScene& scene, const Photo& photo) {
  constexpr int kRays = 4;  // along each edge of a pixel
  Matte matte{photo.name, Image<glm::vec4>(BallScene::kSize, BallScene::kSize)};
  for (int y = 0; y < BallScene::kSize; ++y) {
    for (int x = 0; x < BallScene::kSize; ++x) {
      glm::vec4 sum(0.0f);  // premultiplied
      for (int i = 0; i < kRays * kRays; ++i) {
        const glm::ivec2 ray_place(i % kRays, i / kRays);
        const glm::dvec2 place = (glm::dvec2(ray_place) + 0.5) / double(kRays) - 0.5;
        const Ray ray = world_ray(photo.camera, glm::dvec2(x, y) + place).value();
        const glm::vec4 straight = scene.along(ray.origin, ray.direction);
        sum += glm::vec4(glm::vec3(straight) * straight.a, straight.a);
      }
      if (sum.a <= 0.0f) continue;
      matte.rgba(x, y) = glm::vec4(glm::vec3(sum) / sum.a, sum.a / float(kRays * kRays));
    }
  }
  return matte;
}

Mattes mattes_of(const BallScene& scene, const Photos& photos) {
  Mattes mattes;
  for (const Photo& photo : photos) mattes.push_back(matte_of(scene, photo));
  return mattes;
}

}  // namespace bosk
