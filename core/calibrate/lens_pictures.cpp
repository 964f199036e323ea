#include "core/calibrate/lens_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bosk {
namespace {

using glm::dvec3;

struct Stop {
  double at;
  dvec3 colour;
};
constexpr std::array<Stop, 4> kHeat{
    {{0.0, {49, 84, 163}}, {0.33, {72, 168, 94}}, {0.66, {236, 203, 60}}, {1.0, {200, 40, 35}}}};
constexpr dvec3 kBare{176, 62, 52}, kFew{60, 66, 74}, kMany{148, 160, 172};
constexpr double kManyCorners = 12.0;  // of one cell, beyond which more make no difference

// Colours of the scale from 0 to 1.
dvec3 heat(double value) {
  const double at = std::clamp(value, 0.0, 1.0);
  std::size_t i = 1;
  while (i + 1 < kHeat.size() && kHeat[i].at < at) ++i;
  const double share = (at - kHeat[i - 1].at) / (kHeat[i].at - kHeat[i - 1].at);
  return glm::mix(kHeat[i - 1].colour, kHeat[i].colour, std::clamp(share, 0.0, 1.0));
}

glm::u8vec3 bytes(const dvec3& colour) { return glm::u8vec3(colour + 0.5); }

int height_for(const Lens& lens, int width_px) {
  if (lens.width_px <= 0) return width_px;
  return std::max(1, int(std::lround(double(width_px) * lens.height_px / lens.width_px)));
}

// Bilinear between the cells' centres.
double map_value(const Image<float>& map, double x, double y) {
  const double left = std::clamp(x, 0.0, map.width() - 1.0);
  const double top = std::clamp(y, 0.0, map.height() - 1.0);
  const int x0 = std::min(int(left), std::max(0, map.width() - 2));
  const int y0 = std::min(int(top), std::max(0, map.height() - 2));
  const int x1 = std::min(x0 + 1, map.width() - 1), y1 = std::min(y0 + 1, map.height() - 1);
  const double sx = left - x0, sy = top - y0;
  return (map(x0, y0) * (1 - sx) + map(x1, y0) * sx) * (1 - sy) +
         (map(x0, y1) * (1 - sx) + map(x1, y1) * sx) * sy;
}

void draw_dot(Image<glm::u8vec3>& picture, const glm::dvec2& at, double radius,
              const glm::u8vec3& colour) {
  for (int y = std::max(0, int(at.y - radius));
       y <= std::min(picture.height() - 1, int(at.y + radius + 1)); ++y)
    for (int x = std::max(0, int(at.x - radius));
         x <= std::min(picture.width() - 1, int(at.x + radius + 1)); ++x)
      if (std::hypot(x - at.x, y - at.y) <= radius) picture(x, y) = colour;
}

dvec3 cell_colour(float corners) {
  if (corners <= 0.0f) return kBare;
  return glm::mix(kFew, kMany, std::min(1.0, double(corners) / kManyCorners));
}

}  // namespace

Image<glm::u8vec3> coverage_picture(const LensCalibration& calibration, int width_px) {
  const Lens& lens = calibration.profile.lens;
  const Image<float>& coverage = calibration.profile.coverage;
  Image<glm::u8vec3> picture(width_px, height_for(lens, width_px), bytes(kBare));
  if (coverage.empty()) return picture;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      picture(x, y) = bytes(cell_colour(coverage(x * coverage.width() / picture.width(),
                                                 y * coverage.height() / picture.height())));
  const double scale = double(width_px) / lens.width_px;
  const double worst_px = std::max(1e-9, 3.0 * calibration.corner_sigma_px);
  for (const CornerResidual& corner : calibration.residuals) {
    const double badness = corner.outlier ? 1.0 : glm::length(corner.error_px) / worst_px;
    draw_dot(picture, (corner.pixel + 0.5) * scale - 0.5, std::max(1.0, width_px / 320.0),
             bytes(heat(0.33 + 0.67 * badness)));
  }
  return picture;
}

Image<glm::u8vec3> uncertainty_picture(const LensProfile& profile, int width_px, double full_px) {
  const Image<float>& sigma = profile.uncertainty_px;
  Image<glm::u8vec3> picture(width_px, height_for(profile.lens, width_px),
                             bytes(kHeat.back().colour));
  if (sigma.empty()) return picture;
  const auto value = [&](int x, int y) {
    return map_value(sigma, (x + 0.5) / picture.width() * sigma.width() - 0.5,
                     (y + 0.5) / picture.height() * sigma.height() - 0.5) /
           full_px;
  };
  const auto band = [&](int x, int y) { return int(std::min(4.0, 4.0 * value(x, y))); };
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const bool contour =
          (x > 0 && band(x, y) != band(x - 1, y)) || (y > 0 && band(x, y) != band(x, y - 1));
      picture(x, y) = bytes((contour ? 0.55 : 1.0) * heat(value(x, y)));
    }
  return picture;
}

}  // namespace bosk
