#include "core/calibrate/tags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/aruco.hpp>

#include "core/base/error.h"
#include "core/calibrate/grey_image.h"

namespace bosk {
namespace {

struct DictionaryName {
  const char* name;
  int id;
};

constexpr std::array kDictionaries{
    DictionaryName{"DICT_4X4_50", cv::aruco::DICT_4X4_50},
    DictionaryName{"DICT_4X4_100", cv::aruco::DICT_4X4_100},
    DictionaryName{"DICT_4X4_250", cv::aruco::DICT_4X4_250},
    DictionaryName{"DICT_4X4_1000", cv::aruco::DICT_4X4_1000},
    DictionaryName{"DICT_5X5_50", cv::aruco::DICT_5X5_50},
    DictionaryName{"DICT_5X5_100", cv::aruco::DICT_5X5_100},
    DictionaryName{"DICT_5X5_250", cv::aruco::DICT_5X5_250},
    DictionaryName{"DICT_5X5_1000", cv::aruco::DICT_5X5_1000},
    DictionaryName{"DICT_6X6_50", cv::aruco::DICT_6X6_50},
    DictionaryName{"DICT_6X6_100", cv::aruco::DICT_6X6_100},
    DictionaryName{"DICT_6X6_250", cv::aruco::DICT_6X6_250},
    DictionaryName{"DICT_6X6_1000", cv::aruco::DICT_6X6_1000},
    DictionaryName{"DICT_7X7_50", cv::aruco::DICT_7X7_50},
    DictionaryName{"DICT_7X7_100", cv::aruco::DICT_7X7_100},
    DictionaryName{"DICT_7X7_250", cv::aruco::DICT_7X7_250},
    DictionaryName{"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
    DictionaryName{"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
    DictionaryName{"DICT_APRILTAG_16h5", cv::aruco::DICT_APRILTAG_16h5},
    DictionaryName{"DICT_APRILTAG_25h9", cv::aruco::DICT_APRILTAG_25h9},
    DictionaryName{"DICT_APRILTAG_36h10", cv::aruco::DICT_APRILTAG_36h10},
    DictionaryName{"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11}};

cv::Ptr<cv::aruco::Dictionary> dictionary_of(std::string_view name) {
  for (const DictionaryName& known : kDictionaries)
    if (name == known.name) return cv::aruco::getPredefinedDictionary(known.id);
  std::string list;
  for (const DictionaryName& known : kDictionaries)
    list += (list.empty() ? "" : ", ") + std::string(known.name);
  throw Error("\"" + std::string(name) + "\" is no dictionary of markers; known are " + list);
}

// Refinement fits lines to the edges: they cross at the corner of the print, also where the corner
// itself is blurred.
cv::Ptr<cv::aruco::DetectorParameters> detector_parameters() {
  auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_CONTOUR;
  parameters->adaptiveThreshWinSizeMax = 43;
  parameters->minMarkerPerimeterRate = 0.01;
  return parameters;
}

double shortest_side(const std::vector<cv::Point2f>& corners) {
  double shortest = 1e9;
  for (std::size_t i = 0; i < 4; ++i) {
    const cv::Point2f side = corners[(i + 1) % 4] - corners[i];
    shortest = std::min(shortest, std::hypot(double(side.x), double(side.y)));
  }
  return shortest;
}

SightedTag tag_of(int id, const std::vector<cv::Point2f>& corners) {
  SightedTag tag;
  tag.id = id;
  for (std::size_t i = 0; i < 4; ++i) tag.corner_px[i] = {corners[i].x, corners[i].y};
  // Lines through few edge pixels are less certain.
  tag.sigma_px = std::clamp(3.0 / std::sqrt(shortest_side(corners)), 0.3, 1.0);
  return tag;
}

std::vector<SightedTag> without_repeated(std::vector<SightedTag> tags) {
  std::stable_sort(tags.begin(), tags.end(),
                   [](const SightedTag& a, const SightedTag& b) { return a.id < b.id; });
  std::vector<SightedTag> single;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const bool repeated = (i > 0 && tags[i - 1].id == tags[i].id) ||
                          (i + 1 < tags.size() && tags[i + 1].id == tags[i].id);
    if (!repeated) single.push_back(tags[i]);
  }
  return single;
}

// Corner 0 to 3 of a tag whose lower left corner is at the origin: clockwise from the top left.
glm::dvec3 corner_in_tag(int corner, double side_m) {
  return {corner == 1 || corner == 2 ? side_m : 0.0, corner < 2 ? side_m : 0.0, 0.0};
}

void add_tag(RigidBody& body, int id, double side_m, const glm::dvec3& lower_left) {
  for (int corner = 0; corner < 4; ++corner) {
    body.points.push_back(tag_corner_name(id, corner));
    body.in_body.push_back(lower_left + corner_in_tag(corner, side_m));
  }
}

}  // namespace

std::vector<std::string> tag_dictionary_names() {
  std::vector<std::string> names;
  for (const DictionaryName& known : kDictionaries) names.emplace_back(known.name);
  return names;
}

std::vector<SightedTag> find_tags(const Image<glm::vec3>& srgb, std::string_view dictionary,
                                  const Progress& progress) {
  const auto tags = dictionary_of(dictionary);
  progress.check();
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(grey_of(srgb), tags, corners, ids, detector_parameters());
  progress.check();
  std::vector<SightedTag> found;
  for (std::size_t i = 0; i < ids.size(); ++i) found.push_back(tag_of(ids[i], corners[i]));
  return without_repeated(std::move(found));
}

std::string tag_corner_name(int id, int corner) {
  return "tag " + std::to_string(id) + "/" + std::to_string(corner);
}

std::vector<Sighting> tag_sightings(std::span<const SightedTag> tags) {
  std::vector<Sighting> sightings;
  for (const SightedTag& tag : tags)
    for (int corner = 0; corner < 4; ++corner)
      sightings.push_back({tag_corner_name(tag.id, corner), tag.corner_px[std::size_t(corner)],
                           tag.sigma_px, SightedBy::tag});
  return sightings;
}

RigidBody tag_body(int id, double side_m) {
  RigidBody body;
  body.name = "tag " + std::to_string(id);
  add_tag(body, id, side_m, {-0.5 * side_m, -0.5 * side_m, 0.0});
  return body;
}

RigidBody tag_board_body(const TagBoard& board) {
  RigidBody body;
  body.name = "board of tags from " + std::to_string(board.first_id);
  const double pitch = board.side_m + board.separation_m;
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column)
      add_tag(body, board.first_id + row * board.columns + column, board.side_m,
              {column * pitch, (board.rows - 1 - row) * pitch, 0.0});
  return body;
}

}  // namespace bosk
