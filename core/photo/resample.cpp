#include "core/photo/resample.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/colour.h"
#include "core/photo/pixel_source.h"

namespace bosk {
namespace {

// An alpha too small to see, given to every pixel: it keeps the colour of clear areas.
constexpr float kTrace = 1e-6f;
constexpr double kMaxScale = 100.0;
constexpr int kMaxTaps = 128;

// Integral of the Catmull-Rom kernel from 0 to t.
double catmull_rom_integral(double t) {
  const double a = std::min(std::abs(t), 2.0);
  const double inner = ((0.375 * a - 2.5 / 3.0) * a * a + 1.0) * a;
  const double outer = (((-0.125 * a + 2.5 / 3.0) * a - 2.0) * a + 2.0) * a - 1.0 / 6.0;
  return std::copysign(a < 1.0 ? inner : outer, t);
}

double catmull_rom(double t) {
  const double a = std::abs(t);
  if (a >= 2.0) return 0.0;
  if (a < 1.0) return (1.5 * a - 2.5) * a * a + 1.0;
  return ((-0.5 * a + 2.5) * a - 4.0) * a + 2.0;
}

// The original pixels along one axis that make up one pixel of the result.
struct Taps {
  int count = 0;
  std::array<int, kMaxTaps> position;
  std::array<float, kMaxTaps> weight;
};

void find_taps(double centre, double scale, int size, Taps& taps) {
  const double inside = std::clamp(centre, -0.5, double(size) - 0.5);
  const double radius = resampling_radius(scale);
  const int first = int(std::ceil(inside - radius)), last = int(std::floor(inside + radius));
  taps.count = std::min(last - first + 1, kMaxTaps);
  for (int i = 0; i < taps.count; ++i) {
    const auto slot = std::size_t(i);
    taps.position[slot] = std::clamp(first + i, 0, size - 1);
    taps.weight[slot] = float(resampling_weight(first + i - inside, scale));
  }
}

glm::vec4 premultiplied(const glm::vec4& straight_linear) {
  const float weight = straight_linear.a + kTrace;
  return {glm::vec3(straight_linear) * weight, weight};
}

// Negative weights ring beside a bright sky; the result stays within what the positive ones saw.
template <class Fetch>
glm::vec4 weighted_mean(const Fetch& premultiplied_at, const Taps& columns, const Taps& rows) {
  glm::vec4 sum(0.0f), lowest(1e30f), highest(-1e30f);
  for (int j = 0; j < rows.count; ++j) {
    const float row_weight = rows.weight[std::size_t(j)];
    const int y = rows.position[std::size_t(j)];
    for (int i = 0; i < columns.count; ++i) {
      const float weight = row_weight * columns.weight[std::size_t(i)];
      const glm::vec4 value = premultiplied_at(columns.position[std::size_t(i)], y);
      sum += weight * value;
      if (row_weight <= 0.0f || weight <= 0.0f) continue;
      lowest = glm::min(lowest, value);
      highest = glm::max(highest, value);
    }
  }
  return glm::clamp(sum, lowest, highest);
}

glm::vec4 straight_srgb(const glm::vec4& premultiplied_linear) {
  const float weight = std::max(premultiplied_linear.a, 0.5f * kTrace);
  const glm::vec3 linear = glm::max(glm::vec3(premultiplied_linear) / weight, 0.0f);
  return {glm::min(srgb_from_linear(linear), 1.0f),
          std::clamp(premultiplied_linear.a - kTrace, 0.0f, 1.0f)};
}

using Place = std::optional<glm::dvec2>;

// Where the pixels of one row of the result, and one more, lie in the original.
std::vector<Place> row_in_original(const Lens& original, const Lens& working, int y) {
  std::vector<Place> places;
  for (int x = 0; x <= working.width_px; ++x) {
    const auto direction = camera_from_pixel(working, glm::dvec2(x, y));
    places.push_back(direction ? pixel_from_camera(original, *direction) : std::nullopt);
  }
  return places;
}

double scale_between(const Place& a, const Place& b, int axis) {
  if (!a || !b) return 1.0;
  return std::clamp(std::abs((*b)[axis] - (*a)[axis]), 1.0, kMaxScale);
}

template <class Fetch>
void resample_row(const Fetch& premultiplied_at, const Lens& original,
                  const std::vector<Place>& row, const std::vector<Place>& below, int y,
                  Image<glm::vec4>& result) {
  Taps columns, rows;
  for (int x = 0; x < result.width(); ++x) {
    const auto i = std::size_t(x);
    if (!row[i]) continue;
    find_taps(row[i]->x, scale_between(row[i], row[i + 1], 0), original.width_px, columns);
    find_taps(row[i]->y, scale_between(row[i], below[i], 1), original.height_px, rows);
    result(x, y) = straight_srgb(weighted_mean(premultiplied_at, columns, rows));
  }
}

template <class Fetch>
Image<glm::vec4> resampled(const Fetch& premultiplied_at, const Lens& original,
                           const Lens& working) {
  Image<glm::vec4> result(working.width_px, working.height_px, glm::vec4(0.0f));
  const tbb::blocked_range<int> all_rows(0, working.height_px, 16);
  tbb::parallel_for(all_rows, [&](const tbb::blocked_range<int>& rows) {
    std::vector<Place> row = row_in_original(original, working, rows.begin());
    for (int y = rows.begin(); y < rows.end(); ++y) {
      std::vector<Place> below = row_in_original(original, working, y + 1);
      resample_row(premultiplied_at, original, row, below, y, result);
      row = std::move(below);
    }
  });
  return result;
}

// A lens that bends nothing maps as a pinhole does, whatever its formulas are called.
bool same_mapping(Lens a, const Lens& b) {
  const bool bends = std::any_of(a.distortion.begin(), a.distortion.end(),
                                 [](double coefficient) { return coefficient != 0.0; });
  if (a.model == LensModel::opencv && !bends) a.model = LensModel::pinhole;
  return a == b;
}

std::string size_text(int width_px, int height_px) {
  return std::to_string(width_px) + " x " + std::to_string(height_px);
}

}  // namespace

double resampling_weight(double offset, double scale) {
  const double half_box = 0.5 * (scale - 1.0);
  if (half_box < 1e-3) return catmull_rom(offset);
  return (catmull_rom_integral(offset + half_box) - catmull_rom_integral(offset - half_box)) /
         (2.0 * half_box);
}

double resampling_radius(double scale) { return 2.0 + 0.5 * (scale - 1.0); }

Lens lens_for_size(const Lens& lens, int width_px, int height_px) {
  const double across = double(width_px) / lens.width_px, down = double(height_px) / lens.height_px;
  const bool same_shape = std::abs(lens.height_px * across - height_px) <= 1.0 ||
                          std::abs(lens.width_px * down - width_px) <= 1.0;
  if (same_shape) return scaled(lens, width_px, height_px);
  const bool turned = lens.width_px == height_px && lens.height_px == width_px;
  throw Error("it has " + size_text(width_px, height_px) + " pixels, its camera " +
              size_text(lens.width_px, lens.height_px) +
              (turned ? "; give the photo unturned, as the sensor delivered it"
                      : "; give the photo that the camera was calibrated with, uncropped"));
}

Image<glm::vec4> undistorted_photo(const DecodedPhoto& photo, const Lens& original,
                                   const Lens& working) {
  if (same_mapping(original, working)) return straight_of(photo);
  return visit_pixels(photo, [&](const auto& source) {
    const auto fetch = [&](int x, int y) { return premultiplied(source.straight_linear(x, y)); };
    return resampled(fetch, original, working);
  });
}

Image<glm::vec4> undistort_rgba(const Image<glm::vec4>& straight, const Camera& original,
                                const Camera& working) {
  const Lens lens = lens_for_size(original.lens, straight.width(), straight.height());
  if (same_mapping(lens, working.lens)) return straight;
  Image<glm::vec4> light(straight.width(), straight.height());
  tbb::parallel_for(0, straight.height(), [&](int y) {
    for (int x = 0; x < straight.width(); ++x) {
      const glm::vec4& pixel = straight(x, y);
      light(x, y) = premultiplied({linear_from_srgb(glm::vec3(pixel)), pixel.a});
    }
  });
  return resampled([&](int x, int y) { return light(x, y); }, lens, working.lens);
}

}  // namespace bosk
