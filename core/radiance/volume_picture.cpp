#include "core/radiance/volume_picture.h"

#include <array>
#include <cassert>
#include <cmath>

#include "core/opacity/ray_cache.h"
#include "core/radiance/volume_march.h"

namespace bosk {
namespace {

glm::u8vec4 bytes_of(const glm::vec3& straight, float alpha) {
  return glm::u8vec4(glm::clamp(glm::vec4(straight, alpha), 0.0f, 1.0f) * 255.0f + 0.5f);
}

// Lightness grows all the way, so that it also reads without colour.
glm::vec3 ramp(float stopped) {
  constexpr std::array<glm::vec3, 5> kStops{
      glm::vec3{0.0f, 0.0f, 0.02f}, glm::vec3{0.28f, 0.07f, 0.43f}, glm::vec3{0.72f, 0.21f, 0.33f},
      glm::vec3{0.98f, 0.60f, 0.16f}, glm::vec3{1.0f, 1.0f, 0.93f}};
  const float at = std::clamp(stopped, 0.0f, 1.0f) * 4.0f;
  const int stop = std::min(int(at), 3);
  return glm::mix(kStops[std::size_t(stop)], kStops[std::size_t(stop + 1)], at - float(stop));
}

glm::vec4 sample_at(const VolumeSnapshot& volume, const glm::vec3& at) {
  const glm::ivec3 base(glm::floor(at));
  const bool inside = glm::all(glm::greaterThanEqual(base, glm::ivec3(-1))) &&
                      glm::all(glm::lessThan(base, glm::ivec3(volume.side())));
  const VolumeSnapshot::Brick* brick = inside ? brick_around(volume, base) : nullptr;
  return brick ? sample_brick(*brick, at - glm::vec3(base), base & 7) : glm::vec4(0.0f);
}

glm::u8vec4 slice_pixel(const glm::vec4& sample, SliceLook look) {
  const float stopped = 1.0f - std::exp(-sample.w);
  if (look == SliceLook::extinction) return bytes_of(ramp(stopped), 1.0f);
  if (sample.w <= 0.0f) return glm::u8vec4(0);
  return bytes_of(glm::vec3(sample) / sample.w, stopped);
}

double longest_edge(const Box& box) {
  const glm::dvec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

}  // namespace

Image<glm::u8vec4> volume_picture(const VolumeSnapshot& volume, const Camera& pinhole, int width_px,
                                  int height_px) {
  Camera camera = pinhole;
  camera.lens = scaled(pinhole.lens, width_px, height_px);
  const Image<glm::vec4> premultiplied = premultiplied_picture(volume, camera);
  Image<glm::u8vec4> picture(width_px, height_px);
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const glm::vec4& pixel = premultiplied.pixels()[i];
    if (pixel.a > 0.0f) picture.pixels()[i] = bytes_of(glm::vec3(pixel) / pixel.a, pixel.a);
  }
  return picture;
}

Camera orbit_camera(const VolumeSnapshot& volume, double azimuth, double elevation, double distance,
                    int width_px, int height_px, double view) {
  const glm::dvec3 out(std::cos(elevation) * std::cos(azimuth),
                       std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const glm::dvec3 right(-std::sin(azimuth), std::cos(azimuth), 0.0);
  const glm::dvec3 down = glm::cross(-out, right);
  const glm::dvec3 eye = volume.bounds.centre() + out * (distance * longest_edge(volume.bounds));
  Camera camera;
  camera.name = "orbit";
  camera.camera_from_world.rotation = glm::transpose(glm::dmat3(right, down, -out));
  camera.camera_from_world.translation = -(camera.camera_from_world.rotation * eye);
  camera.lens.width_px = width_px;
  camera.lens.height_px = height_px;
  camera.lens.focal_px = glm::dvec2(0.5 * std::min(width_px, height_px) / std::tan(0.5 * view));
  camera.lens.principal_px = 0.5 * glm::dvec2(width_px, height_px) - 0.5;
  return camera;
}

Image<glm::u8vec4> slice_picture(const VolumeSnapshot& volume, int axis, double position,
                                 int size_px, SliceLook look) {
  assert(axis >= 0 && axis < 3 && size_px > 0);
  const int across = axis == 0 ? 1 : 0, up = axis == 2 ? 1 : 2;
  const double edge = longest_edge(volume.bounds), pixel_m = edge / size_px;
  Image<glm::u8vec4> picture(size_px, size_px);
  for (int row = 0; row < size_px; ++row) {
    glm::dvec3 point = volume.bounds.centre();
    point[axis] = volume.bounds.lower[axis] + position * volume.bounds.size()[axis];
    point[up] += 0.5 * edge - (row + 0.5) * pixel_m;
    const double left = point[across] - 0.5 * edge;
    for (int column = 0; column < size_px; ++column) {
      point[across] = left + (column + 0.5) * pixel_m;
      const glm::vec3 at = cells_from_world(point, {volume.origin, volume.size_m}, volume.level);
      picture(column, row) = slice_pixel(sample_at(volume, at), look);
    }
  }
  return picture;
}

}  // namespace bosk
