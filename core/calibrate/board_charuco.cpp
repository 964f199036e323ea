#include "core/calibrate/board_charuco.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/aruco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/calibrate/board_refine.h"

namespace bosk {
namespace {

using cv::Point2f;

constexpr double kDetectMegapixels = 6.0;
constexpr std::size_t kFewestCorners = 6;
constexpr std::size_t kLocalMarkers = 4;  // that foretell a corner together
// Of a square, between a marker's corner and where the others say it is: room for a lens's bending.
constexpr double kDisagreement = 0.25;

using cv::aruco::PREDEFINED_DICTIONARY_NAME;
constexpr std::pair<const char*, PREDEFINED_DICTIONARY_NAME> kDictionaries[] = {
    {"DICT_4X4_50", cv::aruco::DICT_4X4_50},
    {"DICT_4X4_100", cv::aruco::DICT_4X4_100},
    {"DICT_4X4_250", cv::aruco::DICT_4X4_250},
    {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000},
    {"DICT_5X5_50", cv::aruco::DICT_5X5_50},
    {"DICT_5X5_100", cv::aruco::DICT_5X5_100},
    {"DICT_5X5_250", cv::aruco::DICT_5X5_250},
    {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000},
    {"DICT_6X6_50", cv::aruco::DICT_6X6_50},
    {"DICT_6X6_100", cv::aruco::DICT_6X6_100},
    {"DICT_6X6_250", cv::aruco::DICT_6X6_250},
    {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000},
    {"DICT_7X7_50", cv::aruco::DICT_7X7_50},
    {"DICT_7X7_100", cv::aruco::DICT_7X7_100},
    {"DICT_7X7_250", cv::aruco::DICT_7X7_250},
    {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
    {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
};

// Board coordinates here: a square's side is 1 and the origin the board's outer top left corner, so
// that inner corner (0, 0) is at (1, 1).
struct SeenMarker {
  int column = 0, row = 0;  // of its square
  std::array<Point2f, 4> on_board, in_picture;
};

struct Layout {
  std::vector<SeenMarker> markers;  // those that agree
  cv::Mat picture_from_board;       // 3 x 3
};

struct Detections {
  std::vector<int> numbers;
  std::vector<std::vector<Point2f>> corners;
};

Detections detect(const cv::Mat& grey, const std::string& dictionary) {
  const auto* named = std::find_if(std::begin(kDictionaries), std::end(kDictionaries),
                                   [&](const auto& entry) { return dictionary == entry.first; });
  const cv::Mat small = at_most(grey, kDetectMegapixels);
  Detections found;
  cv::aruco::detectMarkers(small, cv::aruco::getPredefinedDictionary(named->second), found.corners,
                           found.numbers);
  const Point2f scale(float(grey.cols) / float(small.cols), float(grey.rows) / float(small.rows));
  for (auto& corners : found.corners)
    for (Point2f& corner : corners)
      corner = {(corner.x + 0.5f) * scale.x - 0.5f, (corner.y + 0.5f) * scale.y - 0.5f};
  return found;
}

// The square that a marker lies in; columns of -1 where the board has no such marker.
std::pair<int, int> square_of(int number, const BoardShape& shape, bool dark_first) {
  const int columns = shape.columns + 1, rows = shape.rows + 1;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      if (((column + row) % 2 == 1) == dark_first && number-- == 0) return {column, row};
  return {-1, -1};
}

SeenMarker marker_at(std::pair<int, int> square, const std::vector<Point2f>& seen, double share) {
  const auto [column, row] = square;
  const float margin = float(0.5 - 0.5 * share);
  const float left = float(column) + margin, right = float(column + 1) - margin;
  const float top = float(row) + margin, bottom = float(row + 1) - margin;
  return {column,
          row,
          {{{left, top}, {right, top}, {right, bottom}, {left, bottom}}},
          {{seen[0], seen[1], seen[2], seen[3]}}};
}

double mean_side_px(const std::vector<SeenMarker>& markers) {
  double sum = 0.0;
  for (const SeenMarker& marker : markers)
    for (std::size_t i = 0; i < 4; ++i)
      sum += cv::norm(marker.in_picture[i] - marker.in_picture[(i + 1) % 4]);
  return sum / (4.0 * double(markers.size()));
}

cv::Mat fit(const std::vector<SeenMarker>& markers, int method, double tolerance_px,
            cv::Mat& good) {
  std::vector<Point2f> on_board, in_picture;
  for (const SeenMarker& marker : markers) {
    on_board.insert(on_board.end(), marker.on_board.begin(), marker.on_board.end());
    in_picture.insert(in_picture.end(), marker.in_picture.begin(), marker.in_picture.end());
  }
  return cv::findHomography(on_board, in_picture, method, tolerance_px, good);
}

Layout laid_out(const Detections& found, const BoardShape& shape, bool dark_first) {
  std::vector<SeenMarker> markers;
  for (std::size_t i = 0; i < found.numbers.size(); ++i) {
    const auto square = square_of(found.numbers[i], shape, dark_first);
    if (square.first >= 0)
      markers.push_back(marker_at(square, found.corners[i], shape.marker_share));
  }
  Layout layout;
  if (markers.empty()) return layout;
  cv::Mat good;
  const double square_px = mean_side_px(markers) / shape.marker_share;
  layout.picture_from_board = fit(markers, cv::RANSAC, kDisagreement * square_px, good);
  if (layout.picture_from_board.empty()) return layout;
  for (std::size_t i = 0; i < markers.size(); ++i) {
    bool agrees = true;
    for (int corner = 0; corner < 4; ++corner)
      agrees = agrees && good.at<std::uint8_t>(int(4 * i) + corner) != 0;
    if (agrees) layout.markers.push_back(markers[i]);
  }
  return layout;
}

double squared_distance(const SeenMarker& marker, double x, double y) {
  const double dx = marker.column + 0.5 - x, dy = marker.row + 0.5 - y;
  return dx * dx + dy * dy;
}

// The nearest markers to a corner, one of which must touch it; else none.
std::vector<SeenMarker> markers_near(const Layout& layout, double x, double y) {
  std::vector<SeenMarker> near = layout.markers;
  const auto nearer = [&](const SeenMarker& a, const SeenMarker& b) {
    return squared_distance(a, x, y) < squared_distance(b, x, y);
  };
  std::stable_sort(near.begin(), near.end(), nearer);
  near.resize(std::min(near.size(), kLocalMarkers));
  if (near.empty() || squared_distance(near.front(), x, y) > 0.6) return {};
  return near;
}

Point2f through(const cv::Mat& homography, double x, double y) {
  std::vector<Point2f> points{{float(x), float(y)}};
  cv::perspectiveTransform(points, points, homography);
  return points.front();
}

bool inside(const cv::Mat& grey, const Point2f& point) {
  return point.x >= 3.0f && point.y >= 3.0f && point.x <= float(grey.cols - 4) &&
         point.y <= float(grey.rows - 4);
}

// Inner corner (column, row), refined in a window that ends before the markers begin.
std::optional<RefinedCorner> corner_seen(const cv::Mat& grey, const Layout& layout, double share,
                                         int column, int row, double noise) {
  const double x = column + 1.0, y = row + 1.0;
  const std::vector<SeenMarker> near = markers_near(layout, x, y);
  cv::Mat ignored;
  const cv::Mat local = near.empty() ? cv::Mat() : fit(near, 0, 0.0, ignored);
  if (local.empty()) return std::nullopt;
  const Point2f start = through(local, x, y);
  if (!inside(grey, start)) return std::nullopt;
  const double square_px = std::min(cv::norm(through(local, x + 1.0, y) - start),
                                    cv::norm(through(local, x, y + 1.0) - start));
  const double clear_px = 0.5 * (1.0 - share) * square_px;
  const RefinedCorner corner =
      refined_corner(grey, {start.x, start.y}, clear_px / kWindowShare, noise);
  const double moved = glm::distance(corner.pixel, glm::dvec2(start.x, start.y));
  if (moved > 0.15 * square_px) return std::nullopt;
  return corner;
}

cv::Rect box_of(const Layout& layout) {
  std::vector<Point2f> points;
  for (const SeenMarker& marker : layout.markers)
    points.insert(points.end(), marker.in_picture.begin(), marker.in_picture.end());
  return cv::boundingRect(points);
}

bool spread(const std::vector<BoardCorner>& corners) {
  std::set<int> columns, rows;
  for (const BoardCorner& corner : corners) {
    columns.insert(corner.column);
    rows.insert(corner.row);
  }
  return corners.size() >= kFewestCorners && columns.size() >= 2 && rows.size() >= 2;
}

}  // namespace

void check_dictionary(const std::string& name) {
  std::string names;
  for (const auto& [known, unused] : kDictionaries) {
    if (name == known) return;
    names += names.empty() ? known : std::string(", ") + known;
  }
  throw Error("the board: no dictionary of markers is called \"" + name + "\"; give one of " +
              names);
}

std::vector<BoardCorner> find_charuco(const cv::Mat& grey, const BoardShape& shape,
                                      const Progress& progress) {
  progress.check();
  const Detections found = detect(grey, shape.dictionary);
  progress.check();
  Layout layout = laid_out(found, shape, true);
  Layout other = laid_out(found, shape, false);
  if (other.markers.size() > layout.markers.size()) layout = std::move(other);
  if (layout.markers.empty()) return {};
  const double noise = grey_noise(grey, box_of(layout));
  std::vector<BoardCorner> corners;
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.columns; ++column) {
      const auto seen = corner_seen(grey, layout, shape.marker_share, column, row, noise);
      if (seen) corners.push_back({column, row, seen->pixel, seen->sigma_px});
    }
  return spread(corners) ? corners : std::vector<BoardCorner>{};
}

}  // namespace bosk
