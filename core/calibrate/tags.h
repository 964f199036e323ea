#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/sightings.h"
#include "core/calibrate/survey.h"
#include "core/image/image.h"

namespace bosk {

// A printed square marker (ArUco or AprilTag), as one photo shows it. Corners run clockwise in the
// print, from its top left.
struct SightedTag {
  int id = 0;
  std::array<glm::dvec2, 4> corner_px{};
  double sigma_px = 0.3;  // of each corner, along each axis
};

// Tags in a grid, printed on one sheet: ids run along the rows from `first_id` at the top left.
struct TagBoard {
  int columns = 5, rows = 7, first_id = 0;
  double side_m = 0.05, separation_m = 0.01;  // edge of a tag; free strip between two
};

// OpenCV's names: "DICT_4X4_50" ... "DICT_ARUCO_ORIGINAL", "DICT_APRILTAG_36h11".
std::vector<std::string> tag_dictionary_names();

// The tags of one photo (sRGB, 0 to 1), by id; an id that shows twice is left out, since nothing
// tells which is meant. Throws Error for an unknown dictionary, listing the known; Cancelled.
std::vector<SightedTag> find_tags(const Image<glm::vec3>& srgb, std::string_view dictionary,
                                  const Progress& progress);

// "tag 12/3": corner 0 to 3 of a tag.
std::string tag_corner_name(int id, int corner);
std::vector<Sighting> tag_sightings(std::span<const SightedTag> tags);

// The corners of one tag, origin at its centre, x right and y up in the print, z out of it.
RigidBody tag_body(int id, double side_m);
// The corners of all tags of a board, origin at its lower left corner, x right, y up, z out of it.
RigidBody tag_board_body(const TagBoard& board);

}  // namespace bosk
