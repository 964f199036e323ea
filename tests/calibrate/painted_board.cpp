#include "tests/calibrate/painted_board.h"

#include <algorithm>
#include <cmath>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/geometry/rotation.h"

namespace bosk {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kDark = 30.0, kLight = 210.0, kBehind = 110.0;
constexpr int kMarkerSide = 60;  // of a drawn marker, in its own pixels
constexpr int kSamples = 8;

// Grey of the board's plane, in squares from its outer top left corner.
class BoardFace {
 public:
  BoardFace(const BoardShape& shape, bool dark_first) : shape_(shape), dark_first_(dark_first) {
    if (shape.kind != BoardKind::charuco) return;
    const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
    markers_.resize(std::size_t((shape.columns + 1) * (shape.rows + 1)));
    int number = 0;
    for (int row = 0; row <= shape.rows; ++row)
      for (int column = 0; column <= shape.columns; ++column)
        if (!dark(column, row))
          cv::aruco::drawMarker(dictionary, number++, kMarkerSide, marker(column, row));
  }

  double grey(const dvec2& at) const {
    const int columns = shape_.columns + 1, rows = shape_.rows + 1;
    if (at.x < -1.0 || at.y < -1.0 || at.x > columns + 1.0 || at.y > rows + 1.0) return kBehind;
    if (at.x < 0.0 || at.y < 0.0 || at.x >= columns || at.y >= rows) return kLight;
    const int column = int(at.x), row = int(at.y);
    if (dark(column, row)) return kDark;
    return shape_.kind == BoardKind::charuco ? marker_grey(column, row, at) : kLight;
  }

  // Whether a square has one grey: no markers.
  bool is_plain() const { return markers_.empty(); }

 private:
  bool dark(int column, int row) const { return ((column + row) % 2 == 0) == dark_first_; }
  cv::Mat& marker(int column, int row) {
    return markers_[std::size_t(row * (shape_.columns + 1) + column)];
  }
  double marker_grey(int column, int row, const dvec2& at) const {
    const dvec2 inside =
        (at - dvec2(column, row) - 0.5 * (1.0 - shape_.marker_share)) / shape_.marker_share;
    if (inside.x < 0.0 || inside.y < 0.0 || inside.x >= 1.0 || inside.y >= 1.0) return kLight;
    const cv::Mat& drawn = markers_[std::size_t(row * (shape_.columns + 1) + column)];
    return drawn.at<std::uint8_t>(int(inside.y * kMarkerSide), int(inside.x * kMarkerSide)) > 127
               ? kLight
               : kDark;
  }

  BoardShape shape_;
  bool dark_first_;
  std::vector<cv::Mat> markers_;
};

// Where the ray through a pixel meets the board's plane, in squares from the outer corner.
std::optional<dvec2> plane_point(const BoardShape& shape, const Lens& lens,
                                 const RigidTransform& board_from_camera, const dvec2& pixel) {
  const std::optional<dvec3> ray = camera_from_pixel(lens, pixel);
  if (!ray) return std::nullopt;
  const dvec3 direction = board_from_camera.rotation * *ray;
  const double along = -board_from_camera.translation.z / direction.z;
  if (!(along > 0.0)) return std::nullopt;
  return dvec2(board_from_camera.translation + along * direction) / shape.square_m + 1.0;
}

// Whether no edge of the board's pattern can pass between the plane points of a pixel's corners.
bool inside_one_square(const dvec2& corner, const dvec2& right, const dvec2& down, bool plain) {
  constexpr double kMargin = 1e-6;
  const dvec2 low = glm::min(corner, glm::min(right, glm::min(down, right + down - corner)));
  const dvec2 high = glm::max(corner, glm::max(right, glm::max(down, right + down - corner)));
  return plain && glm::floor(low - kMargin) == glm::floor(high + kMargin);
}

// Mean over the pixel, whose plane coordinates are taken as linear within it.
double pixel_grey(const BoardFace& face, const dvec2& corner, const dvec2& right,
                  const dvec2& down) {
  if (inside_one_square(corner, right, down, face.is_plain())) return face.grey(corner);
  double sum = 0.0;
  for (int j = 0; j < kSamples; ++j)
    for (int i = 0; i < kSamples; ++i)
      sum += face.grey(corner + (i + 0.5) / kSamples * (right - corner) +
                       (j + 0.5) / kSamples * (down - corner));
  return sum / (kSamples * kSamples);
}

}  // namespace

Image<std::uint8_t> paint_board(const BoardShape& shape, const Lens& lens,
                                const RigidTransform& camera_from_board, const BoardPaint& paint) {
  const RigidTransform board_from_camera = inverse(camera_from_board);
  const BoardFace face(shape, paint.dark_first);
  const int width = lens.width_px, height = lens.height_px;
  Image<dvec2> plane(width + 1, height + 1, dvec2(-100.0));
  for (int y = 0; y <= height; ++y)
    for (int x = 0; x <= width; ++x)
      if (const auto at = plane_point(shape, lens, board_from_camera, dvec2(x, y) - 0.5))
        plane(x, y) = *at;
  cv::Mat grey(height, width, CV_64FC1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      grey.at<double>(y, x) = pixel_grey(face, plane(x, y), plane(x + 1, y), plane(x, y + 1)) *
                              (1.0 - paint.lit_unevenly * x / width);
  if (paint.blur_px > 0.0) cv::GaussianBlur(grey, grey, {}, paint.blur_px);
  Random random(paint.seed, 77);
  Image<std::uint8_t> picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      picture(x, y) = std::uint8_t(
          std::clamp(std::lround(grey.at<double>(y, x) + paint.noise * random.normal()), 0L, 255L));
  return picture;
}

Lens phone_lens(int width_px, int height_px) {
  Lens lens;
  lens.model = LensModel::opencv;
  lens.width_px = width_px;
  lens.height_px = height_px;
  lens.focal_px = dvec2(0.76 * width_px, 0.763 * width_px);
  lens.principal_px = {0.507 * width_px, 0.494 * height_px};
  lens.distortion = {0.06, -0.11, 8e-4, -6e-4};
  return lens;
}

RigidTransform board_pose(const BoardShape& shape, const Lens& lens, const glm::dvec3& rodrigues,
                          const glm::dvec2& middle_px, double distance_m) {
  const glm::dmat3 turn = rotation_from_rodrigues(rodrigues);
  const dvec3 middle = 0.5 * corner_in_board(shape, shape.columns - 1, shape.rows - 1);
  const dvec3 ray = camera_from_pixel(lens, middle_px).value();
  return {turn, distance_m * ray - turn * middle};
}

std::vector<BoardCorner> true_corners(const BoardShape& shape, const Lens& lens,
                                      const RigidTransform& camera_from_board) {
  std::vector<BoardCorner> corners;
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.columns; ++column) {
      const auto pixel =
          pixel_from_camera(lens, camera_from_board * corner_in_board(shape, column, row));
      if (!pixel || pixel->x < 0.0 || pixel->y < 0.0 || pixel->x > lens.width_px - 1 ||
          pixel->y > lens.height_px - 1)
        continue;
      corners.push_back({column, row, *pixel, 0.1});
    }
  return corners;
}

}  // namespace bosk
