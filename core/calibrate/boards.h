#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/sightings.h"
#include "core/calibrate/survey.h"
#include "core/image/image.h"

namespace bosk {

enum class BoardKind : std::uint8_t { chessboard, charuco };

// A flat board of squares. Its frame: x along the columns, y along the rows, z into the board (away
// from who looks at it), origin at corner (0, 0); so in a picture the turn from x to y is
// clockwise.
//
// Corner (0, 0) is the one whose outer square, beyond it on both axes, is dark. A board whose
// numbers of inner corners are one odd and one even has only one such choice; any other looks the
// same when turned by half (or, where square, a quarter), and then the corner nearest to the
// picture's top left is taken. Good for a lens; for a board that stands still in several photos
// take an odd-even one.
struct BoardShape {
  BoardKind kind = BoardKind::chessboard;
  int columns = 9, rows = 6;  // INNER corners, where four squares meet; at least 3
  double square_m = 0.03;     // side of a square, > 0
  // ChArUco alone: markers lie in the light squares, numbered along the rows from the top left.
  std::string dictionary = "DICT_4X4_50";  // as OpenCV names it
  double marker_share = 0.75;              // a marker's side over a square's, 0.3 to 0.95

  bool operator==(const BoardShape&) const = default;
};

// Throws Error that names the value when the shape is none of a board.
void check_board_shape(const BoardShape& shape);

struct BoardCorner {
  int column = 0, row = 0;  // from 0 to the shape's columns - 1 and rows - 1
  glm::dvec2 pixel{0.0};    // of the picture given
  double sigma_px = 0.1;    // along each axis, from the contrast and noise around it
};

// Corners by row, then by column. A chessboard has all of them or none (empty); a ChArUco those
// that are seen beside a marker, at least 6 of them not on a line, or none. Large pictures are
// searched at 1.5, then at 6 megapixels and the corners refined in the picture itself.
//
// Finders: mrgingham where the board is square, cv::findChessboardCornersSB else and where that
// found nothing; the markers of cv::aruco. Never cv::findChessboardCorners, which can run for
// minutes. None of them can be stopped: between them Progress is asked, so cancelling waits up to 2
// s.
std::vector<BoardCorner> find_board(const Image<std::uint8_t>& grey, const BoardShape& shape,
                                    const Progress& progress);

// Rec. 601 luma of an sRGB picture, as board finders expect.
Image<std::uint8_t> grey_of(const Image<glm::vec3>& srgb);

// Metres, in the board's frame; z is 0.
glm::dvec3 corner_in_board(const BoardShape& shape, int column, int row);

// A board that stands still among the photos, for the common solve: "board 4,2" and so on.
std::vector<Sighting> board_sightings(const std::vector<BoardCorner>& corners);
RigidBody board_body(const BoardShape& shape);

}  // namespace bosk
