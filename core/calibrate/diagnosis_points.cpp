#include "core/calibrate/diagnosis_points.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/calibrate/seed_scene.h"

namespace bosk {
namespace {

Camera camera_of(const SolveInput& input, const BundleState& state, int camera) {
  const Lens lens =
      lens_of(input.problem.family, state.intrinsics, input.lens.width_px, input.lens.height_px);
  return {"", lens, state.camera_from_world[std::size_t(camera)]};
}

bool seen_at(const Camera& camera, const glm::dvec3& point, const BundleSighting& sighting,
             double sigmas) {
  const auto pixel = project(camera, point);
  return pixel && glm::distance(*pixel, sighting.pixel) < sigmas * sighting.sigma_px;
}

// Of each point, in the order of the photos.
std::vector<std::vector<std::size_t>> left_out_by_point(const SolveInput& input) {
  std::vector<std::vector<std::size_t>> result(input.points.size());
  const auto& sightings = input.problem.sightings;
  for (std::size_t i = 0; i < sightings.size(); ++i)
    if (!sightings[i].used) result[std::size_t(sightings[i].point)].push_back(i);
  return result;
}

// Where the sightings that were left out see the point, if most of them, and three at least, agree.
std::optional<glm::dvec3> other_place(const SolveInput& input, const BundleState& state,
                                      const std::vector<std::size_t>& left_out, double loss_scale) {
  BundleProblem alone;
  for (const std::size_t i : left_out) {
    alone.sightings.push_back(input.problem.sightings[i]);
    alone.sightings.back().point = 0;
    alone.sightings.back().used = true;
  }
  const SeedScene scene =
      seed_scene(alone, state.intrinsics, camera_of(input, state, 0).lens, input.cameras(), 1);
  const PartialScene cameras{{state.camera_from_world.begin(), state.camera_from_world.end()}, {}};
  const auto place = seed_point(scene, cameras, 0);
  if (!place) return std::nullopt;
  const auto agreeing = std::count_if(alone.sightings.begin(), alone.sightings.end(),
                                      [&](const BundleSighting& sighting) {
                                        return seen_at(camera_of(input, state, sighting.camera),
                                                       *place, sighting, 2.0 * loss_scale);
                                      });
  if (agreeing < 3 || 3 * agreeing < 2 * long(left_out.size())) return std::nullopt;
  return place;
}

}  // namespace

std::vector<std::string> swapped_names(const SolveInput& input, const BundleState& state,
                                       std::span<const PhotoSightings> photos, double loss_scale) {
  std::vector<std::string> sentences;
  const auto& all = input.problem.sightings;
  const auto fits = [&](const BundleSighting& seen, const BundleSighting& as) {
    return seen_at(camera_of(input, state, seen.camera), state.points[std::size_t(as.point)], seen,
                   2.0 * loss_scale);
  };
  for (std::size_t a = 0; a < all.size(); ++a) {
    if (all[a].used) continue;
    for (std::size_t b = a + 1; b < all.size() && all[b].camera == all[a].camera; ++b) {
      if (all[b].used || !fits(all[a], all[b]) || !fits(all[b], all[a])) continue;
      sentences.push_back(input.points[std::size_t(all[a].point)] + " and " +
                          input.points[std::size_t(all[b].point)] + " are exchanged in photo " +
                          photos[input.photo_of_camera[std::size_t(all[a].camera)]].photo +
                          ": correct their names there");
    }
  }
  return sentences;
}

std::vector<std::string> moved_points(const SolveInput& input, const BundleState& state,
                                      std::span<const PhotoSightings> photos, double loss_scale,
                                      bool scale_known) {
  std::vector<std::string> sentences;
  const auto all_left_out = left_out_by_point(input);
  for (std::size_t point = 0; point < input.points.size(); ++point) {
    const auto& left_out = all_left_out[point];
    if (left_out.size() < 3) continue;
    const auto place = other_place(input, state, left_out, loss_scale);
    if (!place) continue;
    const auto photo_of = [&](std::size_t sighting) {
      const auto camera = std::size_t(input.problem.sightings[sighting].camera);
      return photos[input.photo_of_camera[camera]].photo;
    };
    const double distance = glm::distance(*place, state.points[point]);
    const std::string& name = input.points[point];
    sentences.push_back(name + " was moved between the photos: " + std::to_string(left_out.size()) +
                        " of them, from " + photo_of(left_out.front()) + " to " +
                        photo_of(left_out.back()) + ", see it " +
                        (scale_known ? number_text(distance, 2) + " m away" : "elsewhere") +
                        "; give it another name there");
  }
  return sentences;
}

}  // namespace bosk
