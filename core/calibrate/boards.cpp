#include "core/calibrate/boards.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mrgingham/mrgingham.hh>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/calibrate/board_charuco.h"
#include "core/calibrate/board_order.h"
#include "core/calibrate/board_refine.h"

namespace bosk {
namespace {

using glm::dvec2;

using Grid = std::vector<dvec2>;  // by row, then by column

constexpr double kSearchMegapixels[] = {1.5, 6.0};
constexpr double kFarthestMove = 0.25;  // of the way to the next corner, that refining may go

// Square boards alone. Empty: not found.
Grid found_by_mrgingham(const cv::Mat& grey, const BoardShape& shape) {
  std::vector<mrgingham::PointDouble> points;
  signed char* levels = nullptr;
  const int level =
      mrgingham::find_chessboard_from_image_array(points, &levels, shape.columns, grey, -1);
  std::free(levels);
  Grid grid;
  if (level < 0 || points.size() != std::size_t(shape.columns * shape.rows)) return grid;
  for (const auto& point : points) grid.emplace_back(point.x, point.y);
  return grid;
}

Grid found_by_sectors(const cv::Mat& grey, const BoardShape& shape, int flags) {
  std::vector<cv::Point2f> points;
  if (!cv::findChessboardCornersSB(grey, {shape.columns, shape.rows}, points, flags)) return {};
  Grid grid;
  for (const cv::Point2f& point : points) grid.emplace_back(point.x, point.y);
  return grid;
}

// Finders from fast to thorough.
Grid found_at_this_size(const cv::Mat& grey, const BoardShape& shape, bool thorough,
                        const Progress& progress) {
  progress.check();
  if (shape.columns == shape.rows) {
    Grid grid = found_by_mrgingham(grey, shape);
    if (!grid.empty()) return grid;
    progress.check();
  }
  Grid grid = found_by_sectors(grey, shape, 0);
  if (!grid.empty() || !thorough) return grid;
  progress.check();
  return found_by_sectors(grey, shape, cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_EXHAUSTIVE);
}

Grid at_size(Grid grid, const cv::Mat& from, const cv::Mat& to) {
  const dvec2 scale(double(to.cols) / from.cols, double(to.rows) / from.rows);
  for (dvec2& pixel : grid) pixel = (pixel + 0.5) * scale - 0.5;
  return grid;
}

// At the sizes that large pictures are searched at, in pixels of the whole picture.
Grid found_in(const cv::Mat& grey, const BoardShape& shape, const Progress& progress) {
  for (const double megapixels : kSearchMegapixels) {
    const cv::Mat small = at_most(grey, megapixels);
    const bool first = megapixels == kSearchMegapixels[0];
    const Grid grid = found_at_this_size(small, shape, first, progress);
    if (!grid.empty()) return at_size(grid, small, grey);
    if (small.total() == grey.total()) break;
  }
  return {};
}

cv::Rect box_of(const Grid& grid) {
  dvec2 low = grid.front(), high = low;
  for (const dvec2& pixel : grid) low = glm::min(low, pixel), high = glm::max(high, pixel);
  return {cv::Point(int(low.x), int(low.y)), cv::Point(int(high.x) + 1, int(high.y) + 1)};
}

std::vector<BoardCorner> refined(const Grid& grid, const BoardShape& shape, const cv::Mat& grey) {
  const double noise = grey_noise(grey, box_of(grid));
  std::vector<BoardCorner> corners;
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.columns; ++column) {
      const dvec2 start = grid[std::size_t(row * shape.columns + column)];
      const double spacing = nearest_neighbour_px(grid, shape.columns, shape.rows, column, row);
      RefinedCorner corner = refined_corner(grey, start, spacing, noise);
      const double moved = glm::distance(corner.pixel, start);
      if (moved > kFarthestMove * spacing) corner = {start, std::max(moved, corner.sigma_px)};
      corners.push_back({column, row, corner.pixel, corner.sigma_px});
    }
  return corners;
}

std::string corner_name(int column, int row) {
  return "board " + std::to_string(column) + "," + std::to_string(row);
}

}  // namespace

void check_board_shape(const BoardShape& shape) {
  const auto refuse = [](const std::string& what) { throw Error("the board: " + what); };
  if (shape.columns < 3 || shape.rows < 3 || shape.columns > 100 || shape.rows > 100)
    refuse(std::to_string(shape.columns) + " x " + std::to_string(shape.rows) +
           " inner corners; give 3 to 100 each way, counted where four squares meet");
  if (!(shape.square_m > 0.0) || !std::isfinite(shape.square_m))
    refuse("squares of " + number_text(shape.square_m, 4) + " m; measure a square's side");
  if (shape.kind == BoardKind::chessboard) return;
  if (!(shape.marker_share >= 0.3 && shape.marker_share <= 0.95))
    refuse("markers of " + number_text(shape.marker_share, 2) +
           " of a square; give a share from 0.3 to 0.95");
  check_dictionary(shape.dictionary);
}

std::vector<BoardCorner> find_board(const Image<std::uint8_t>& grey, const BoardShape& shape,
                                    const Progress& progress) {
  check_board_shape(shape);
  if (grey.width() < 32 || grey.height() < 32) return {};
  const cv::Mat picture = cv_grey(grey);
  if (shape.kind == BoardKind::charuco) return find_charuco(picture, shape, progress);
  const Grid grid = found_in(picture, shape, progress);
  if (grid.empty()) return {};
  progress.check();
  return refined(in_board_order(grid, shape, grey), shape, picture);
}

Image<std::uint8_t> grey_of(const Image<glm::vec3>& srgb) {
  Image<std::uint8_t> grey(srgb.width(), srgb.height());
  for (std::size_t i = 0; i < srgb.size(); ++i) {
    const float luma = glm::dot(srgb.pixels()[i], glm::vec3(0.299f, 0.587f, 0.114f));
    grey.pixels()[i] = std::uint8_t(std::clamp(luma * 255.0f + 0.5f, 0.0f, 255.0f));
  }
  return grey;
}

glm::dvec3 corner_in_board(const BoardShape& shape, int column, int row) {
  return {column * shape.square_m, row * shape.square_m, 0.0};
}

std::vector<Sighting> board_sightings(const std::vector<BoardCorner>& corners) {
  std::vector<Sighting> sightings;
  for (const BoardCorner& corner : corners)
    sightings.push_back(
        {corner_name(corner.column, corner.row), corner.pixel, corner.sigma_px, SightedBy::board});
  return sightings;
}

RigidBody board_body(const BoardShape& shape) {
  RigidBody body{"board", {}, {}};
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.columns; ++column) {
      body.points.push_back(corner_name(column, row));
      body.in_body.push_back(corner_in_board(shape, column, row));
    }
  return body;
}

}  // namespace bosk
