#include "core/project/reshoot.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>

#include "core/base/number_text.h"
#include "core/base/system_error.h"

namespace bosk {
namespace {

constexpr double kWideGap = 1.8;       // over the median step of the walk
constexpr double kNarrowestGap = 0.5;  // radians; what is less is never called a gap
constexpr double kTurn = 2.0 * glm::pi<double>();

// A placed photo on the walk round the trunk.
struct Stand {
  std::string photo;
  double heading = 0.0, radius = 0.0;  // of the camera, from the trunk
};

glm::dvec2 place_at(double heading, double radius) {
  return radius * glm::dvec2(std::cos(heading), std::sin(heading));
}

std::vector<Stand> stands_of(const Calibration& calibration) {
  std::vector<Stand> stands;
  for (const Camera& camera : calibration.cameras) {
    const glm::dvec3 centre = camera.centre_in_world();
    stands.push_back({camera.name, std::atan2(centre.y, centre.x), std::hypot(centre.x, centre.y)});
  }
  return stands;
}

void add_gaps(std::vector<Stand> stands, std::vector<ReshootPlace>& places) {
  std::sort(stands.begin(), stands.end(),
            [](const Stand& a, const Stand& b) { return a.heading < b.heading; });
  std::vector<double> steps;
  for (std::size_t i = 0; i < stands.size(); ++i) {
    const bool last = i + 1 == stands.size();
    steps.push_back((last ? stands[0].heading + kTurn : stands[i + 1].heading) - stands[i].heading);
  }
  std::vector<double> sorted = steps;
  std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2),
                   sorted.end());
  const double widest_fine = std::max(kNarrowestGap, kWideGap * sorted[sorted.size() / 2]);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] <= widest_fine) continue;
    const Stand &from = stands[i], &to = stands[(i + 1) % stands.size()];
    places.push_back({place_at(from.heading + 0.5 * steps[i], 0.5 * (from.radius + to.radius)),
                      "between " + printable(from.photo) + " and " + printable(to.photo) + ": " +
                          number_text(steps[i] / kTurn * 360.0, 0) + " degrees without a photo"});
  }
}

// Half way, the short way round, between the placed photos before and after it by name.
glm::dvec2 place_between(const Stand& before, const Stand& after) {
  const double turn = std::remainder(after.heading - before.heading, kTurn);
  return place_at(before.heading + 0.5 * turn, 0.5 * (before.radius + after.radius));
}

void add_photos(const Calibration& calibration, const std::vector<Stand>& stands,
                std::vector<ReshootPlace>& places) {
  std::map<std::string, Stand> by_name;
  for (const Stand& stand : stands) by_name[stand.photo] = stand;
  for (const PhotoFinding& photo : calibration.photos) {
    const std::string why = printable(photo.photo) + ": " + printable(photo.reason);
    const auto placed = by_name.find(photo.photo);
    if (photo.fate == PhotoFate::uncertain && placed != by_name.end()) {
      places.push_back({place_at(placed->second.heading, placed->second.radius), why});
    } else if (photo.fate == PhotoFate::refused) {
      const auto after = by_name.lower_bound(photo.photo);
      const Stand& next = after == by_name.end() ? by_name.begin()->second : after->second;
      const Stand& last =
          after == by_name.begin() ? by_name.rbegin()->second : std::prev(after)->second;
      places.push_back({place_between(last, next), why});
    }
  }
}

}  // namespace

std::vector<ReshootPlace> reshoot_places(const Calibration& calibration) {
  std::vector<ReshootPlace> places;
  const std::vector<Stand> stands = stands_of(calibration);
  if (stands.size() < 2) return places;
  add_gaps(stands, places);
  add_photos(calibration, stands, places);
  return places;
}

}  // namespace bosk
