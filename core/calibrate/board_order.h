#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/calibrate/boards.h"

namespace bosk {

// Corners of a whole chessboard as a finder gives them, rows one after the other, in one of the
// grid's turns or mirror images, put into the order that BoardShape promises.
std::vector<glm::dvec2> in_board_order(const std::vector<glm::dvec2>& grid, const BoardShape& shape,
                                       const Image<std::uint8_t>& grey);

// Distance in pixels from a corner to its nearest neighbour along row or column.
double nearest_neighbour_px(const std::vector<glm::dvec2>& grid, int columns, int rows, int column,
                            int row);

}  // namespace bosk
