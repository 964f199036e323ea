#include "core/calibrate/board_order.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace bosk {
namespace {

using glm::dvec2;

struct Grid {
  int columns = 0, rows = 0;
  std::vector<dvec2> corners;

  const dvec2& at(int column, int row) const {
    return corners[std::size_t(row * columns + column)];
  }
};

Grid mirrored(const Grid& grid, bool along_x, bool along_y) {
  Grid result = grid;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      result.corners[std::size_t(row * grid.columns + column)] = grid.at(
          along_x ? grid.columns - 1 - column : column, along_y ? grid.rows - 1 - row : row);
  return result;
}

Grid transposed(const Grid& grid) {
  Grid result{grid.rows, grid.columns, grid.corners};
  for (int row = 0; row < result.rows; ++row)
    for (int column = 0; column < result.columns; ++column)
      result.corners[std::size_t(row * result.columns + column)] = grid.at(row, column);
  return result;
}

bool is_clockwise(const Grid& grid) {
  const dvec2 x = grid.at(grid.columns - 1, 0) - grid.at(0, 0);
  const dvec2 y = grid.at(0, grid.rows - 1) - grid.at(0, 0);
  return x.x * y.y - x.y * y.x > 0.0;
}

double grey_at(const Image<std::uint8_t>& grey, const dvec2& pixel) {
  const int x = std::clamp(int(std::lround(pixel.x)), 0, grey.width() - 1);
  const int y = std::clamp(int(std::lround(pixel.y)), 0, grey.height() - 1);
  return grey(x, y);
}

// Whether the squares of even column + row, to which the one beyond corner (0, 0) belongs, are the
// darker ones: each square against its neighbour on the right, so that slow shadows cancel.
bool starts_dark(const Grid& grid, const Image<std::uint8_t>& grey) {
  const auto middle = [&](int column, int row) {
    return grey_at(grey, 0.25 * (grid.at(column, row) + grid.at(column + 1, row) +
                                 grid.at(column, row + 1) + grid.at(column + 1, row + 1)));
  };
  double odd_minus_even = 0.0;
  for (int row = 0; row + 1 < grid.rows; ++row)
    for (int column = 0; column + 2 < grid.columns; ++column) {
      const double step = middle(column + 1, row) - middle(column, row);
      odd_minus_even += (column + row) % 2 == 0 ? step : -step;
    }
  return odd_minus_even > 0.0;
}

}  // namespace

std::vector<dvec2> in_board_order(const std::vector<dvec2>& grid, const BoardShape& shape,
                                  const Image<std::uint8_t>& grey) {
  assert(grid.size() == std::size_t(shape.columns * shape.rows));
  const Grid given{shape.columns, shape.rows, grid};
  std::vector<Grid> bases{given};
  if (shape.columns == shape.rows) bases.push_back(transposed(given));
  const Grid* best = nullptr;
  std::vector<Grid> turns;
  for (const Grid& base : bases)
    for (const bool along_x : {false, true})
      for (const bool along_y : {false, true}) turns.push_back(mirrored(base, along_x, along_y));
  // A dark start first, then the start that is nearest to the picture's top left.
  const auto rank = [&](const Grid& turn) {
    const dvec2& start = turn.at(0, 0);
    return std::pair(starts_dark(turn, grey) ? 0 : 1, start.x + start.y);
  };
  for (const Grid& turn : turns)
    if (is_clockwise(turn) && (!best || rank(turn) < rank(*best))) best = &turn;
  return best ? best->corners : grid;
}

double nearest_neighbour_px(const std::vector<dvec2>& grid, int columns, int rows, int column,
                            int row) {
  constexpr std::array<std::array<int, 2>, 4> kSides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const auto at = [&](int c, int r) { return grid[std::size_t(r * columns + c)]; };
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [dc, dr] : kSides) {
    const int c = column + dc, r = row + dr;
    if (c < 0 || r < 0 || c >= columns || r >= rows) continue;
    nearest = std::min(nearest, glm::distance(at(c, r), at(column, row)));
  }
  return nearest;
}

}  // namespace bosk
