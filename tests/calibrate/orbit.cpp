#include "orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/base/random.h"
#include "core/geometry/similarity.h"

namespace bosk {
namespace {

using glm::dvec3;

const dvec3 kCrown(0.0, 0.0, 2.6);
const char* const kColours[] = {"red",  "green",  "blue",  "yellow", "pink",   "orange",
                                "cyan", "purple", "white", "black",  "silver", "brown"};

// A phone's, of 12 megapixels and a focal length like 26 mm on a full frame.
Lens orbit_lens(double distortion, double focal_px) {
  Lens lens;
  lens.model = distortion == 0.0 ? LensModel::pinhole : LensModel::opencv;
  lens.width_px = 4032;
  lens.height_px = 3024;
  lens.focal_px = {focal_px, focal_px + 0.9};
  lens.principal_px = {2030.0, 1498.0};
  lens.distortion = {distortion, -0.3 * distortion, 0.002 * distortion, 0.003 * distortion};
  return lens;
}

Camera looking_at(const Lens& lens, const std::string& name, const dvec3& place,
                  const dvec3& target, double roll) {
  const dvec3 forward = glm::normalize(target - place);
  const dvec3 level = glm::normalize(glm::cross(forward, dvec3(0.0, 0.0, 1.0)));
  const dvec3 down = glm::cross(forward, level);
  const dvec3 right = std::cos(roll) * level + std::sin(roll) * down;
  const glm::dmat3 rotation =
      glm::transpose(glm::dmat3(right, glm::cross(forward, right), forward));
  return {name, lens, {rotation, -(rotation * place)}};
}

void add_markers(const OrbitOptions& options, Random& random, Orbit& orbit) {
  for (int i = 0; i < options.markers; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(-0.3, 0.3)) / options.markers;
    const double radius = random.uniform(0.7, 2.4);
    const dvec3 ball(radius * std::cos(angle), radius * std::sin(angle), random.uniform(0.4, 1.9));
    const std::string name = i < 12 ? kColours[i] : "marker " + std::to_string(i);
    orbit.names.push_back(name);
    orbit.points.push_back(ball);
    if (!options.feet) continue;
    orbit.names.push_back(name + " foot");
    orbit.points.emplace_back(ball.x, ball.y, 0.0);
  }
}

void add_cameras(const OrbitOptions& options, Random& random, Orbit& orbit) {
  const double degree = std::numbers::pi / 180.0;
  for (int i = 0; i < options.photos; ++i) {
    const double angle = 2.0 * std::numbers::pi * options.turns * i / options.photos +
                         degree * random.uniform(-options.jitter_deg, options.jitter_deg);
    const double radius =
        options.radius_m * (1.0 + random.uniform(-options.radius_jitter, options.radius_jitter));
    const bool high = options.second_height_m > 0.0 && i % 2 == 1;
    const dvec3 place(
        radius * std::cos(angle), radius * std::sin(angle),
        (high ? options.second_height_m : options.eye_m) + random.uniform(-0.05, 0.05));
    const dvec3 target = kCrown + dvec3(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3),
                                        random.uniform(-0.3, 0.3));
    orbit.cameras.push_back(looking_at(orbit.lens, orbit_photo_name(i), place, target,
                                       degree * random.uniform(-3.0, 3.0)));
  }
}

bool inside(const Lens& lens, const glm::dvec2& pixel) {
  return pixel.x > 0.0 && pixel.y > 0.0 && pixel.x < lens.width_px && pixel.y < lens.height_px;
}

void spoil(const OrbitOptions& options, Random& random, PhotoSightings& photo) {
  auto& all = photo.sightings;
  const std::size_t count = all.size();
  const auto fewest = std::size_t(std::max(options.fewest_sightings, 0));
  for (std::size_t i = 0; i < count; ++i)
    if (random.uniform() < options.missing && all.size() > fewest)
      all.erase(all.begin() + long(random.below(all.size())));
  for (Sighting& sighting : all) {
    sighting.pixel += options.noise_px * glm::dvec2(random.normal(), random.normal());
    if (random.uniform() >= options.gross) continue;
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    sighting.pixel += random.uniform(20.0, 100.0) * glm::dvec2(std::cos(angle), std::sin(angle));
  }
}

}  // namespace

const dvec3& Orbit::place(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::logic_error("no point " + name);
  return points[std::size_t(found - names.begin())];
}

std::string orbit_photo_name(int index) {
  return "oak_" + std::string(index < 10 ? "0" : "") + std::to_string(index);
}

PhotoSightings exact_sightings(const Orbit& orbit, const Camera& camera) {
  PhotoSightings photo;
  photo.photo = camera.name;
  photo.width_px = camera.lens.width_px;
  photo.height_px = camera.lens.height_px;
  for (std::size_t i = 0; i < orbit.points.size(); ++i) {
    const auto pixel = project(camera, orbit.points[i]);
    if (pixel && inside(camera.lens, *pixel))
      photo.sightings.push_back({orbit.names[i], *pixel, 0.5, SightedBy::click});
  }
  return photo;
}

Orbit make_orbit(const OrbitOptions& options) {
  Random random(options.seed);
  Orbit orbit;
  orbit.lens = orbit_lens(options.distortion, options.focal_px);
  add_markers(options, random, orbit);
  add_cameras(options, random, orbit);
  for (const Camera& camera : orbit.cameras) {
    orbit.photos.push_back(exact_sightings(orbit, camera));
    spoil(options, random, orbit.photos.back());
  }
  return orbit;
}

Tape exact_tape(const Orbit& orbit, const std::string& from, const std::string& to) {
  return {from, to, glm::distance(orbit.place(from), orbit.place(to)), 0.002};
}

std::vector<Height> exact_heights(const Orbit& orbit) {
  std::vector<Height> heights;
  for (std::size_t i = 0; i < orbit.points.size(); ++i)
    if (!orbit.names[i].ends_with(" foot"))
      heights.push_back({orbit.names[i], orbit.points[i].z, 0.005});
  return heights;
}

Lens guessed_orbit_lens(const Orbit& orbit, double focal_ratio) {
  Lens lens;
  lens.width_px = orbit.lens.width_px;
  lens.height_px = orbit.lens.height_px;
  lens.focal_px = focal_ratio * orbit.lens.focal_px;
  lens.principal_px = 0.5 * glm::dvec2(lens.width_px - 1, lens.height_px - 1);
  return lens;
}

OrbitErrors orbit_errors(const Orbit& orbit, const Calibration& calibration) {
  std::vector<dvec3> found, truth;
  std::vector<const Camera*> true_cameras;
  for (const SolvedPoint& point : calibration.points) {
    found.push_back(point.in_world);
    truth.push_back(orbit.place(point.name));
  }
  for (const Camera& camera : calibration.cameras) {
    const auto same = std::find_if(orbit.cameras.begin(), orbit.cameras.end(),
                                   [&](const Camera& c) { return c.name == camera.name; });
    true_cameras.push_back(&*same);
    if (finding_of(calibration, camera.name).fate != PhotoFate::placed) continue;
    found.push_back(camera.centre_in_world());
    truth.push_back(same->centre_in_world());
  }
  const Similarity truth_from_found = fit_similarity(found, truth);
  const std::size_t points = calibration.points.size();
  const Similarity by_points =
      fit_similarity(std::span(found).first(points), std::span(truth).first(points));
  OrbitErrors errors;
  errors.scale_error = by_points.scale - 1.0;
  std::vector<double> marker_errors;
  double squares = 0.0;
  for (std::size_t i = 0; i < calibration.points.size(); ++i) {
    marker_errors.push_back(glm::distance(by_points * found[i], truth[i]));
    squares += marker_errors.back() * marker_errors.back();
  }
  errors.marker_rms_m = std::sqrt(squares / double(marker_errors.size()));
  std::sort(marker_errors.begin(), marker_errors.end());
  errors.marker_median_m = marker_errors[marker_errors.size() / 2];
  double crown_squares = 0.0, placed = 0.0;
  for (std::size_t i = 0; i < calibration.cameras.size(); ++i) {
    const Camera& camera = calibration.cameras[i];
    const Camera there{camera.name, camera.lens, moved(camera.camera_from_world, truth_from_found)};
    const auto seen = project(there, kCrown), should = project(*true_cameras[i], kCrown);
    errors.crown_px.push_back(seen && should ? glm::distance(*seen, *should) : 1e6);
    if (finding_of(calibration, camera.name).fate != PhotoFate::placed) continue;
    errors.worst_crown_px = std::max(errors.worst_crown_px, errors.crown_px.back());
    crown_squares += errors.crown_px.back() * errors.crown_px.back();
    placed += 1.0;
  }
  errors.crown_rms_px = std::sqrt(crown_squares / std::max(placed, 1.0));
  return errors;
}

const PhotoFinding& finding_of(const Calibration& calibration, const std::string& photo) {
  for (const PhotoFinding& finding : calibration.photos)
    if (finding.photo == photo) return finding;
  throw std::logic_error("no finding of " + photo);
}

std::string sentences_of(const Calibration& calibration) {
  std::string text;
  for (const std::string& sentence : calibration.sentences) text += sentence + "\n";
  return text;
}

}  // namespace bosk
