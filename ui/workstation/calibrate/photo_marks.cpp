#include "ui/workstation/calibrate/photo_marks.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "core/project/calibration_figures.h"

namespace bosk {
namespace {

const PhotoSightings* found_in(const CalibrationFinds* finds, const std::string& photo) {
  if (!finds) return nullptr;
  for (const PhotoSightings& each : finds->photos) {
    if (each.photo == photo) return &each;
  }
  return nullptr;
}

const std::map<std::string, HandSighting>& told_of(const HandSightings& told,
                                                   const std::string& photo) {
  static const std::map<std::string, HandSighting> nothing;
  const auto said = told.find(photo);
  return said == told.end() ? nothing : said->second;
}

bool is_found(const CalibrationFinds* finds, const std::string& photo, const std::string& point) {
  const PhotoSightings* found = found_in(finds, photo);
  return found && std::any_of(found->sightings.begin(), found->sightings.end(),
                              [&](const Sighting& each) { return each.point == point; });
}

std::vector<PhotoMark> seen_marks(const std::string& photo, const CalibrationFinds* finds,
                                  const HandSightings& told) {
  std::vector<PhotoMark> marks;
  const auto& said = told_of(told, photo);
  if (const PhotoSightings* found = found_in(finds, photo)) {
    for (const Sighting& each : found->sightings) {
      const auto hand = said.find(each.point);
      if (hand != said.end() && hand->second.there) continue;
      PhotoMark mark{PhotoMark::Kind::found, each.point, each.pixel};
      if (hand != said.end()) mark.kind = PhotoMark::Kind::removed;
      mark.is_feature = is_feature(each.point);
      marks.push_back(std::move(mark));
    }
  }
  for (const auto& [point, hand] : said) {
    if (hand.there) marks.push_back({PhotoMark::Kind::by_hand, point, hand.pixel});
  }
  return marks;
}

// What the newest solve says of marks that still are where it saw them.
void add_errors(const std::string& photo, const Calibration& solved,
                std::vector<PhotoMark>& marks) {
  std::map<std::string, const SightingResidual*> residuals;
  for (const SightingResidual& each : solved.residuals) {
    if (each.photo == photo) residuals[each.point] = &each;
  }
  for (PhotoMark& mark : marks) {
    const auto found = residuals.find(mark.point);
    if (mark.kind == PhotoMark::Kind::removed || found == residuals.end()) continue;
    if (found->second->pixel != mark.pixel) continue;
    mark.error_px = found->second->error_px;
    mark.outlier = found->second->outlier;
  }
}

bool is_in_picture(const Lens& lens, const glm::dvec2& pixel) {
  return pixel.x > -0.5 && pixel.y > -0.5 && pixel.x < lens.width_px - 0.5 &&
         pixel.y < lens.height_px - 0.5;
}

void add_expected(const std::string& photo, const Calibration& solved,
                  std::vector<PhotoMark>& marks) {
  const auto camera = std::find_if(solved.cameras.begin(), solved.cameras.end(),
                                   [&](const Camera& each) { return each.name == photo; });
  if (camera == solved.cameras.end()) return;
  std::set<std::string> shown;
  for (const PhotoMark& mark : marks) shown.insert(mark.point);
  for (const SolvedPoint& point : solved.points) {
    if (is_feature(point.name) || shown.contains(point.name)) continue;
    const auto pixel = project(*camera, point.in_world);
    if (!pixel || !is_in_picture(camera->lens, *pixel)) continue;
    marks.push_back({PhotoMark::Kind::expected, point.name, *pixel});
  }
}

using Counts = std::map<std::string, int>;

void count_found(const CalibrationFinds& finds, const HandSightings& told, Counts& photos_of) {
  for (const PhotoSightings& photo : finds.photos) {
    const auto& said = told_of(told, photo.photo);
    for (const Sighting& each : photo.sightings) {
      if (!is_feature(each.point)) photos_of[each.point] += int(!said.contains(each.point));
    }
  }
}

void count_told(const CalibrationInputs& told, Counts& photos_of) {
  for (const auto& [photo, points] : told.sightings) {
    for (const auto& [point, hand] : points) photos_of[point] += int(hand.there);
  }
  for (const Tape& tape : told.measurements.tapes) {
    photos_of[tape.from];
    photos_of[tape.to];
  }
  for (const Height& height : told.measurements.heights) photos_of[height.point];
  for (const SurveyedPoint& point : told.measurements.points) photos_of[point.point];
}

// Where a person or the finder sees the point in the photo; none: nowhere.
std::optional<glm::dvec2> place_of(const std::vector<PhotoMark>& marks, const std::string& point) {
  for (const PhotoMark& mark : marks) {
    if (mark.point == point && mark.kind != PhotoMark::Kind::removed) return mark.pixel;
  }
  return std::nullopt;
}

SetSighting move_edit(const Project& project, const CalibrationFinds* finds,
                      const std::string& photo, const std::string& point,
                      const std::optional<glm::dvec2>& pixel) {
  if (!pixel) return removal_edit(project, finds, photo, point);
  return sighting_edit(project, photo, point, HandSighting{true, *pixel});
}

}  // namespace

std::vector<PhotoMark> marks_of(const std::string& photo, const CalibrationFinds* finds,
                                const HandSightings& told, const Calibration* solved) {
  std::vector<PhotoMark> marks = seen_marks(photo, finds, told);
  if (!solved) return marks;
  add_errors(photo, *solved, marks);
  add_expected(photo, *solved, marks);
  return marks;
}

const PhotoMark* mark_at(std::span<const PhotoMark> marks, const glm::dvec2& pixel,
                         double reach_px) {
  const PhotoMark* nearest = nullptr;
  for (const PhotoMark& mark : marks) {
    if (mark.is_feature || mark.kind == PhotoMark::Kind::expected) continue;
    const double distance = glm::distance(mark.pixel, pixel);
    if (distance > reach_px) continue;
    reach_px = distance;
    nearest = &mark;
  }
  return nearest;
}

std::string words_of(const PhotoMark& mark) {
  if (mark.kind == PhotoMark::Kind::removed) return mark.point + ", removed";
  if (mark.kind == PhotoMark::Kind::expected) return mark.point + ", expected here";
  std::string words = mark.point;
  if (mark.kind == PhotoMark::Kind::by_hand) words += ", by hand";
  if (!mark.error_px) return words;
  char error[64];
  std::snprintf(error, sizeof error, "%s%.2f px off", mark.outlier ? ", left out: " : ", ",
                glm::length(*mark.error_px));
  return words + error;
}

std::vector<PointRow> points_of(const CalibrationFinds* finds, const CalibrationInputs& told,
                                const Calibration* solved) {
  Counts photos_of;
  if (finds) count_found(*finds, told.sightings, photos_of);
  count_told(told, photos_of);
  std::map<std::string, const SolvedPoint*> places;
  if (solved) {
    for (const SolvedPoint& point : solved->points) places[point.name] = &point;
  }
  std::vector<PointRow> rows;
  for (const auto& [name, photos] : photos_of) {
    PointRow row{name, photos, {}, {}};
    const auto place = places.find(name);
    if (place != places.end()) {
      row.rms_px = place->second->rms_px;
      row.sigma_m = spread(place->second->covariance_m2);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

SetSighting removal_edit(const Project& project, const CalibrationFinds* finds,
                         const std::string& photo, const std::string& point) {
  std::optional<HandSighting> after;
  if (is_found(finds, photo, point)) after = HandSighting{false, {}};
  return sighting_edit(project, photo, point, after);
}

SetSightings renaming_edit(const Project& project, const CalibrationFinds* finds,
                           std::span<const std::string> photos, const std::string& from,
                           const std::string& to) {
  SetSightings edit{from + " is " + to, {}};
  if (from == to) return edit;
  for (const std::string& photo : photos) {
    const auto marks = seen_marks(photo, finds, project.calibration.sightings);
    const auto place = place_of(marks, from);
    if (!place) continue;
    edit.sightings.push_back(move_edit(project, finds, photo, to, place));
    edit.sightings.push_back(move_edit(project, finds, photo, from, place_of(marks, to)));
  }
  return edit;
}

std::string obstacle_to_name(const std::string& name) {
  if (name.empty()) return "type a name first";
  return is_feature(name) ? "names like f12 are those of features; choose another" : "";
}

Measurements renamed(Measurements measurements, const std::string& from, const std::string& to) {
  const auto rename = [&](std::string& name) {
    if (name == from) name = to;
  };
  for (Tape& tape : measurements.tapes) {
    rename(tape.from);
    rename(tape.to);
  }
  for (Height& height : measurements.heights) rename(height.point);
  for (SurveyedPoint& point : measurements.points) rename(point.point);
  return measurements;
}

}  // namespace bosk
