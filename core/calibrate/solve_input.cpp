#include "core/calibrate/solve_input.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/calibrate/photo_quirks.h"
#include "core/calibrate/survey_rows.h"

namespace bosk {
namespace {

// How many photos, of those not refused, see each point.
std::map<std::string, int> photos_of_points(std::span<const PhotoSightings> photos,
                                            const std::vector<std::string>& refused) {
  std::map<std::string, int> counts;
  for (std::size_t i = 0; i < photos.size(); ++i)
    if (refused[i].empty())
      for (const Sighting& sighting : photos[i].sightings) ++counts[sighting.point];
  return counts;
}

int shared_sightings(const PhotoSightings& photo, const std::map<std::string, int>& counts) {
  return int(
      std::count_if(photo.sightings.begin(), photo.sightings.end(),
                    [&](const Sighting& sighting) { return counts.at(sighting.point) >= 2; }));
}

void refuse_poor_photos(std::span<const PhotoSightings> photos, int fewest,
                        std::vector<std::string>& refused) {
  for (bool changed = true; changed;) {
    changed = false;
    const auto counts = photos_of_points(photos, refused);
    for (std::size_t i = 0; i < photos.size(); ++i) {
      if (!refused[i].empty()) continue;
      const int shared = shared_sightings(photos[i], counts);
      if (shared >= fewest) continue;
      refused[i] = "sees " + std::to_string(shared) + " points that other photos see too, and " +
                   std::to_string(fewest) + " are the least: mark more points in it";
      changed = true;
    }
  }
}

void add_sightings(std::span<const PhotoSightings> photos, SolveInput& input) {
  const auto counts = photos_of_points(photos, input.refused);
  std::map<std::string, int> index;
  for (const auto& [name, count] : counts) {
    if (count < 2) continue;
    index[name] = int(input.points.size());
    input.points.push_back(name);
  }
  for (std::size_t i = 0; i < photos.size(); ++i) {
    if (!input.refused[i].empty()) continue;
    const int camera = int(input.photo_of_camera.size());
    input.photo_of_camera.push_back(i);
    for (const Sighting& sighting : photos[i].sightings) {
      const auto point = index.find(sighting.point);
      if (point == index.end()) continue;
      input.problem.sightings.push_back(
          {camera, point->second, sighting.pixel, sighting.sigma_px, true});
    }
  }
}

// Square pixels, an axis near the middle and little distortion, unless the guess says otherwise.
void add_lens(const LensKnowledge& knowledge, SolveInput& input) {
  constexpr double kFocal = 0.3, kPrincipal = 0.01, kRadial = 0.1, kTangential = 1e-3;
  input.lens = knowledge.lens;
  BundleProblem& problem = input.problem;
  problem.family = family_of(knowledge.lens);
  if (!knowledge.known && problem.family == LensFamily::pinhole)
    problem.family = LensFamily::opencv4;
  problem.lens.mean = mrcal_intrinsics(knowledge.lens, problem.family);
  const double width_px = knowledge.lens.width_px;
  for (std::size_t i = 0; i < problem.lens.mean.size(); ++i) {
    problem.lens_free.push_back(!knowledge.known && i < 8);
    problem.lens.sigma.push_back(i < 2   ? kFocal * problem.lens.mean[i]
                                 : i < 4 ? kPrincipal * width_px
                                 : i < 6 ? kRadial
                                         : kTangential);
  }
}

void check_photo(const PhotoSightings& photo) {
  std::set<std::string> seen;
  for (const Sighting& sighting : photo.sightings) {
    if (!seen.insert(sighting.point).second)
      throw Error("photo " + photo.photo + " has two sightings of " + sighting.point +
                  ": keep one, or give the other a name of its own");
    const double sum = sighting.pixel.x + sighting.pixel.y + sighting.sigma_px;
    if (!(sighting.sigma_px > 0.0) || !std::isfinite(sum))
      throw Error("photo " + photo.photo + ": the sighting of " + sighting.point +
                  " has no finite place or no accuracy above 0: mark it again");
  }
  if (photo.width_px <= 0 || photo.height_px <= 0)
    throw Error("photo " + photo.photo + " has no size: read its sightings from the photo again");
}

}  // namespace

void check_input(std::span<const PhotoSightings> photos, const Survey& survey,
                 const LensKnowledge& knowledge) {
  std::set<std::string> names;
  for (const PhotoSightings& photo : photos) {
    if (!names.insert(photo.photo).second)
      throw Error("two photos have the name " + photo.photo + ": rename one");
    check_photo(photo);
  }
  check_survey(survey);
  const Lens& lens = knowledge.lens;
  if (!(lens.focal_px.x > 0.0) || !(lens.focal_px.y > 0.0) || lens.width_px <= 0 ||
      lens.height_px <= 0 || !std::isfinite(lens.focal_px.x + lens.focal_px.y))
    throw Error(
        "the lens has no focal length or size above 0: give a first guess, such as the photo's "
        "width in pixels");
}

SolveInput solve_input(std::span<const PhotoSightings> photos, const Survey& survey,
                       const LensKnowledge& lens, const SolveOptions& options,
                       std::vector<std::string> refused) {
  SolveInput input;
  input.refused = std::move(refused);
  input.refused.resize(photos.size());
  refuse_other_sizes(photos, lens.lens, input.refused);
  refuse_copies(photos, input.refused);
  refuse_poor_photos(photos, options.fewest_sightings, input.refused);
  add_sightings(photos, input);
  add_lens(lens, input);
  add_survey(survey, photos, input);
  return input;
}

std::vector<SeedBody> seed_bodies(const SolveInput& input) {
  std::vector<SeedBody> bodies(input.bodies.size());
  for (const BodyRow& row : input.problem.bodies) {
    SeedBody& body = bodies[std::size_t(row.body)];
    body.points.push_back(row.point);
    body.in_body.push_back(row.in_body);
  }
  std::erase_if(bodies, [](const SeedBody& body) { return body.points.size() < 4; });
  return bodies;
}

}  // namespace bosk
