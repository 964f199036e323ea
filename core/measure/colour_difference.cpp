#include "core/measure/colour_difference.h"

#include <cmath>
#include <numbers>

#include "core/image/colour.h"

namespace bosk {
namespace {

constexpr double kPi = std::numbers::pi;

double radians(double degrees) { return degrees * kPi / 180.0; }

// x^7 / (x^7 + 25^7), under a root.
double chroma_weight(double chroma) {
  const double power = std::pow(chroma, 7.0);
  return std::sqrt(power / (power + std::pow(25.0, 7.0)));
}

struct Hues {
  double difference = 0.0, mean = 0.0;  // radians
};

// Hues of grey are undefined: then their difference is 0 and their mean the other's.
Hues compare_hues(double a, double b, bool one_is_grey) {
  if (one_is_grey) return {0.0, a + b};
  double difference = b - a, mean = 0.5 * (a + b);
  if (std::abs(difference) > kPi) {
    difference += difference > 0.0 ? -2.0 * kPi : 2.0 * kPi;
    mean += a + b < 2.0 * kPi ? kPi : -kPi;
  }
  return {difference, mean};
}

double hue_angle(double a, double b) {
  const double angle = a == 0.0 && b == 0.0 ? 0.0 : std::atan2(b, a);
  return angle < 0.0 ? angle + 2.0 * kPi : angle;
}

double hue_term(double hue) {
  return 1.0 - 0.17 * std::cos(hue - radians(30.0)) + 0.24 * std::cos(2.0 * hue) +
         0.32 * std::cos(3.0 * hue + radians(6.0)) - 0.20 * std::cos(4.0 * hue - radians(63.0));
}

double rotation_term(double mean_hue, double mean_chroma) {
  const double offset = (mean_hue * 180.0 / kPi - 275.0) / 25.0;
  return -2.0 * chroma_weight(mean_chroma) * std::sin(radians(60.0) * std::exp(-offset * offset));
}

}  // namespace

// Names follow the standard: a stretched for greys, then chroma C and hue h of that.
double colour_difference_2000(const glm::dvec3& lab_a, const glm::dvec3& lab_b) {
  const double plain_chroma = 0.5 * (std::hypot(lab_a.y, lab_a.z) + std::hypot(lab_b.y, lab_b.z));
  const double stretch = 1.0 + 0.5 * (1.0 - chroma_weight(plain_chroma));
  const double chroma_a = std::hypot(stretch * lab_a.y, lab_a.z);
  const double chroma_b = std::hypot(stretch * lab_b.y, lab_b.z);
  const Hues hues = compare_hues(hue_angle(stretch * lab_a.y, lab_a.z),
                                 hue_angle(stretch * lab_b.y, lab_b.z), chroma_a * chroma_b == 0.0);
  const double chroma = 0.5 * (chroma_a + chroma_b);
  const double from_middle = 0.5 * (lab_a.x + lab_b.x) - 50.0, square = from_middle * from_middle;
  const double lightness_scale = 1.0 + 0.015 * square / std::sqrt(20.0 + square);
  const double light = (lab_b.x - lab_a.x) / lightness_scale;
  const double colourful = (chroma_b - chroma_a) / (1.0 + 0.045 * chroma);
  const double hue = 2.0 * std::sqrt(chroma_a * chroma_b) * std::sin(0.5 * hues.difference) /
                     (1.0 + 0.015 * chroma * hue_term(hues.mean));
  return std::sqrt(light * light + colourful * colourful + hue * hue +
                   rotation_term(hues.mean, chroma) * colourful * hue);
}

double colour_difference_srgb(const glm::dvec3& srgb_a, const glm::dvec3& srgb_b) {
  return colour_difference_2000(lab_from_srgb(glm::vec3(srgb_a)), lab_from_srgb(glm::vec3(srgb_b)));
}

}  // namespace bosk
