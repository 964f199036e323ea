#include "core/calibrate/diagnosis_photo.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/calibrate/bundle_loss.h"
#include "core/calibrate/seed_pose.h"

namespace bosk {
namespace {

using Sightings = std::vector<KnownSighting>;

std::vector<PoseSighting> seen_through(const Lens& lens, const Sightings& sightings) {
  std::vector<PoseSighting> result;
  for (const KnownSighting& sighting : sightings)
    if (const auto bearing = camera_from_pixel(lens, sighting.pixel))
      result.push_back({sighting.in_world, *bearing, sighting.sigma_px / lens.focal_px.x});
  return result;
}

// How many sightings fit from one place, and that place.
struct Fit {
  int fitting = 0;
  RigidTransform camera_from_world;
};

int count_fitting(const Camera& camera, const Sightings& sightings, double sigmas) {
  return int(std::count_if(sightings.begin(), sightings.end(), [&](const KnownSighting& seen) {
    const auto pixel = project(camera, seen.in_world);
    return pixel && glm::distance(*pixel, seen.pixel) < sigmas * seen.sigma_px;
  }));
}

Fit best_fit(const Lens& lens, const Sightings& sightings, double sigmas) {
  Fit best;
  for (const PlacedPose& pose : place_camera(seen_through(lens, sightings), sigmas)) {
    const int fitting = count_fitting({"", lens, pose.camera_from_world}, sightings, sigmas);
    if (fitting > best.fitting) best = {fitting, pose.camera_from_world};
  }
  return best;
}

Sightings mirrored(Sightings sightings, const Lens& lens) {
  for (KnownSighting& sighting : sightings)
    sighting.pixel.x = lens.width_px - 1.0 - sighting.pixel.x;
  return sightings;
}

// A bundle of this photo alone whose points stay where they are and whose lens is free.
BundleProblem resection(const Sightings& sightings, const Lens& lens) {
  constexpr double kFixed = 1e-6, kAnyFocal = 3.0, kAnyPlace = 3.0;
  BundleProblem problem;
  problem.family = family_of(lens);
  problem.lens.mean = mrcal_intrinsics(lens, problem.family);
  for (std::size_t i = 0; i < problem.lens.mean.size(); ++i) {
    problem.lens_free.push_back(i < 4);
    problem.lens.sigma.push_back(i < 2 ? kAnyFocal * lens.focal_px.x : kAnyPlace * lens.width_px);
  }
  for (int i = 0; i < int(sightings.size()); ++i) {
    const KnownSighting& sighting = sightings[std::size_t(i)];
    problem.sightings.push_back({0, i, sighting.pixel, sighting.sigma_px, true});
    for (int axis = 0; axis < 3; ++axis)
      problem.coordinates.push_back({i, axis, sighting.in_world[axis], kFixed, true});
  }
  return problem;
}

struct LensFit {
  int fitting = 0;
  Lens lens;
};

// With focal length and principal point of its own, from several focal lengths.
LensFit fit_with_own_lens(const Lens& lens, const Sightings& sightings, double sigmas) {
  LensFit best{0, lens};
  BundleProblem problem = resection(sightings, lens);
  for (const double ratio : {1.0, 0.75, 1.33, 0.55, 1.8}) {
    Lens guess = lens;
    guess.focal_px *= ratio;
    BundleState state;
    state.intrinsics = mrcal_intrinsics(guess, problem.family);
    state.camera_from_world = {best_fit(guess, sightings, 10.0 * sigmas).camera_from_world};
    for (const KnownSighting& sighting : sightings) state.points.push_back(sighting.in_world);
    for (const double scale : {20.0 * sigmas, 5.0 * sigmas, sigmas})
      solve_bundle(problem, state, {scale, 20}, Progress{});
    const Lens own = lens_of(problem.family, state.intrinsics, lens.width_px, lens.height_px);
    const int fitting = count_fitting({"", own, state.camera_from_world[0]}, sightings, sigmas);
    if (fitting > best.fitting && own.focal_px.x > 0.0) best = {fitting, own};
  }
  return best;
}

std::string percent_text(double ratio) { return number_text(100.0 * std::abs(ratio - 1.0), 0); }

std::string own_lens_reason(const Lens& lens, const Lens& own) {
  const double ratio = own.focal_px.x / lens.focal_px.x;
  const glm::dvec2 shift = own.principal_px - lens.principal_px;
  if (glm::length(shift) > 0.04 * lens.width_px)
    return "looks cropped: its points fit a picture whose middle lies " +
           number_text(glm::length(shift), 0) + " px off; give the photo as the camera took it";
  return "fits with a focal length " + percent_text(ratio) + " % " +
         (ratio > 1.0 ? "longer" : "shorter") +
         " than the others': take all photos with one lens and one zoom setting";
}

// The two whose exchange makes all fit.
std::optional<std::string> swapped_reason(const Sightings& sightings, const Lens& lens,
                                          double sigmas, int needed) {
  for (std::size_t a = 0; a < sightings.size(); ++a) {
    for (std::size_t b = a + 1; b < sightings.size(); ++b) {
      Sightings swapped = sightings;
      std::swap(swapped[a].pixel, swapped[b].pixel);
      if (best_fit(lens, swapped, sigmas).fitting >= needed)
        return "fits when " + sightings[a].point + " and " + sightings[b].point +
               " are exchanged: correct their names in it";
    }
  }
  return std::nullopt;
}

}  // namespace

std::string why_photo_disagrees(std::span<const KnownSighting> known, const Lens& lens,
                                double loss_scale, std::optional<double> exif_focal_ratio) {
  constexpr std::size_t kMostExplained = 12;  // more sightings say no more, and take time
  const Sightings sightings(known.begin(),
                            known.begin() + long(std::min(known.size(), kMostExplained)));
  const int count = int(sightings.size());
  const int needed = std::max(5, (4 * count + 4) / 5);
  if (exif_focal_ratio && std::abs(*exif_focal_ratio - 1.0) > 0.05)
    return "was taken with a focal length " + percent_text(*exif_focal_ratio) + " % " +
           (*exif_focal_ratio > 1.0 ? "longer" : "shorter") +
           " than the others', as its EXIF says: take all photos with one lens and one zoom "
           "setting";
  if (count >= needed) {
    if (best_fit(lens, mirrored(sightings, lens), loss_scale).fitting >= needed)
      return "is mirrored: give it as the camera took it";
    if (const auto reason = swapped_reason(sightings, lens, loss_scale, count)) return *reason;
    if (const LensFit own = fit_with_own_lens(lens, sightings, loss_scale);
        count >= 6 && own.fitting >= needed)
      return own_lens_reason(lens, own.lens);
  }
  const int fitting = best_fit(lens, sightings, loss_scale).fitting;
  return "disagrees with the others: no place of the camera fits more than " +
         std::to_string(fitting) + " of " + std::to_string(count) +
         " sightings; is it another tree, or are its points named wrongly?";
}

}  // namespace bosk
