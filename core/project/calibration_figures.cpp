#include "core/project/calibration_figures.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/number_text.h"
#include "core/base/system_error.h"

namespace bosk {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

constexpr std::size_t kNumberWidth = 9;

// The first column to the left, numbers to the right, the last as it is.
std::string table_text(const std::vector<Row>& rows) {
  std::size_t first = 0;
  for (const Row& row : rows) first = std::max(first, row.front().size());
  std::string text;
  for (const Row& row : rows) {
    text += "  " + row.front() + std::string(first - row.front().size(), ' ');
    for (std::size_t i = 1; i < row.size(); ++i) {
      const bool words = i + 1 == row.size();
      const std::size_t width = words ? 0 : kNumberWidth;
      text += words ? "  " : " ";
      text += std::string(width > row[i].size() ? width - row[i].size() : 0, ' ') + row[i];
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text;
}

// Metres as millimetres; of a world without scale three digits of its own unit.
std::string length_text(double length, bool in_metres) {
  return in_metres ? number_text(1000.0 * length, 1) : number_text(length, 4);
}

std::string photo_table(const Calibration& calibration) {
  const bool metres = calibration.scale_known;
  std::vector<Row> rows = {
      {"photo", "points", "outliers", "rms px", "crown px", metres ? "place mm" : "place", ""}};
  for (const PhotoFinding& photo : calibration.photos) {
    const bool placed = photo.fate != PhotoFate::refused;
    const auto figure = [&](const std::string& text) { return placed ? text : "-"; };
    const std::string why = photo.reason.empty() ? "" : ": " + printable(photo.reason);
    rows.push_back({printable(photo.photo), std::to_string(photo.sightings),
                    figure(std::to_string(photo.outliers)), figure(number_text(photo.rms_px, 2)),
                    figure(number_text(photo.crown_sigma_px, 2)),
                    figure(length_text(spread(photo.centre_covariance_m2), metres)),
                    fate_words(photo.fate) + why});
  }
  return table_text(rows);
}

std::string marker_table(const Calibration& calibration) {
  const bool metres = calibration.scale_known;
  std::vector<Row> rows = {
      {"marker", "photos", "rms px", "x", "y", "z", metres ? "error mm" : "error"}};
  for (const SolvedPoint& point : calibration.points) {
    if (is_feature(point.name)) continue;
    const glm::dvec3& place = point.in_world;
    rows.push_back({printable(point.name), std::to_string(point.photos),
                    number_text(point.rms_px, 2), number_text(place.x, 3), number_text(place.y, 3),
                    number_text(place.z, 3), length_text(spread(point.covariance_m2), metres)});
  }
  return rows.size() > 1 ? table_text(rows) : "";
}

Json vector_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
Json vector_json(const glm::dvec2& v) { return {v.x, v.y}; }

Json matrix_json(const glm::dmat3& m) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) rows.push_back({m[0][row], m[1][row], m[2][row]});
  return rows;
}

Json photo_json(const PhotoFinding& photo, const Calibration& calibration) {
  Json json = {{"photo", printable(photo.photo)},
               {"fate", fate_words(photo.fate)},
               {"reason", printable(photo.reason)},
               {"points", photo.sightings},
               {"outliers", photo.outliers},
               {"rms_px", photo.rms_px},
               {"crown_sigma_px", photo.crown_sigma_px}};
  for (const Camera& camera : calibration.cameras) {
    if (camera.name != photo.photo) continue;
    json["centre_m"] = vector_json(camera.centre_in_world());
    json["centre_covariance_m2"] = matrix_json(photo.centre_covariance_m2);
  }
  return json;
}

Json point_json(const SolvedPoint& point) {
  return {{"point", printable(point.name)},
          {"in_world_m", vector_json(point.in_world)},
          {"covariance_m2", matrix_json(point.covariance_m2)},
          {"photos", point.photos},
          {"rms_px", point.rms_px}};
}

Json residual_json(const SightingResidual& residual) {
  return {{"photo", printable(residual.photo)},
          {"point", printable(residual.point)},
          {"pixel", vector_json(residual.pixel)},
          {"error_px", vector_json(residual.error_px)},
          {"outlier", residual.outlier}};
}

Json lens_json(const Calibration& calibration) {
  const Lens& lens = calibration.lens;
  return {{"was_known", calibration.lens_was_known},
          {"width_px", lens.width_px},
          {"height_px", lens.height_px},
          {"focal_px", vector_json(lens.focal_px)},
          {"principal_px", vector_json(lens.principal_px)},
          {"distortion", lens.distortion}};
}

template <class Item, class ToJson>
Json list_json(const std::vector<Item>& items, ToJson to_json) {
  Json list = Json::array();
  for (const Item& item : items) list.push_back(to_json(item));
  return list;
}

}  // namespace

std::string verdict_words(Verdict verdict) {
  if (verdict == Verdict::good) return "good";
  return verdict == Verdict::usable ? "usable, with reservations" : "refused";
}

std::string fate_words(PhotoFate fate) {
  if (fate == PhotoFate::placed) return "placed";
  return fate == PhotoFate::uncertain ? "uncertain" : "not placed";
}

std::string summary_words(const Calibration& calibration) {
  std::string text = std::to_string(calibration.cameras.size()) + " of " +
                     std::to_string(calibration.photos.size()) + " photos placed";
  if (calibration.cameras.empty()) return text;
  text += ", " + number_text(calibration.rms_px, 2) + " px";
  if (!calibration.scale_known) return text + ", scale not known";
  return text + ", scale within " + number_text(100.0 * calibration.scale_sigma, 2) + " %";
}

bool is_feature(const std::string& point) {
  return point.size() > 1 && point.front() == 'f' &&
         point.find_first_not_of("0123456789", 1) == std::string::npos;
}

bool is_foot(const std::string& point) {
  constexpr std::string_view kFoot = " foot";
  return point.size() > kFoot.size() && point.ends_with(kFoot);
}

double spread(const glm::dmat3& covariance) {
  return std::sqrt(std::max(0.0, covariance[0][0] + covariance[1][1] + covariance[2][2]));
}

std::string calibration_figures_text(const Calibration& calibration) {
  std::string text = verdict_words(calibration.verdict) + ": " + summary_words(calibration) + "\n";
  for (const std::string& sentence : calibration.sentences) {
    text += "  " + printable(sentence) + "\n";
  }
  text += "\n" + photo_table(calibration);
  const std::string markers = marker_table(calibration);
  return markers.empty() ? text : text + "\n" + markers;
}

Json calibration_figures_json(const Calibration& calibration) {
  return {{"verdict", verdict_words(calibration.verdict)},
          {"summary", summary_words(calibration)},
          {"sentences", list_json(calibration.sentences, printable)},
          {"rms_px", calibration.rms_px},
          {"scale_known", calibration.scale_known},
          {"scale_sigma", calibration.scale_sigma},
          {"up_known", calibration.up_known},
          {"lens", lens_json(calibration)},
          {"photos", list_json(calibration.photos,
                               [&](const auto& photo) { return photo_json(photo, calibration); })},
          {"points", list_json(calibration.points, point_json)},
          {"residuals", list_json(calibration.residuals, residual_json)}};
}

}  // namespace bosk
