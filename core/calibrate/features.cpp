#include "core/calibrate/features.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/calibrate/feature_match.h"
#include "core/calibrate/feature_poses.h"
#include "core/calibrate/feature_tracks.h"

namespace bosk {
namespace {

std::vector<PhotoFeatures> detect_all(std::span<const FeaturePhoto> photos,
                                      const FeatureOptions& options, Progress& progress) {
  std::vector<PhotoFeatures> features(photos.size());
  progress.begin("Finding features", photos.size(), 0.0, 0.3);
  tbb::parallel_for(std::size_t(0), photos.size(), [&](std::size_t i) {
    progress.check();
    features[i] = detect_features(photos[i], options.features_per_photo);
    progress.advance();
  });
  return features;
}

PhotoSightings without_sightings(const FeaturePhoto& photo) {
  PhotoSightings sightings;
  sightings.photo = photo.name;
  sightings.width_px = photo.srgb->width();
  sightings.height_px = photo.srgb->height();
  return sightings;
}

// SIFT places a point to a share of the size that it describes.
double sigma_of(float size_px) { return std::clamp(0.12 * double(size_px), 0.5, 3.0); }

// The longest tracks that give every photo its share.
std::vector<FeatureTrack> chosen_tracks(const std::vector<FeatureTrack>& tracks, std::size_t photos,
                                        int share) {
  std::vector<int> taken(photos, 0);
  std::vector<FeatureTrack> chosen;
  for (const FeatureTrack& track : tracks) {
    const bool is_wanted = std::any_of(track.begin(), track.end(), [&](const TrackSighting& seen) {
      return taken[seen.photo] < share;
    });
    if (!is_wanted) continue;
    chosen.push_back(track);
    for (const TrackSighting& seen : track) ++taken[seen.photo];
  }
  return chosen;
}

std::vector<BundleSighting> bundle_sightings(std::span<const FeatureTrack> tracks,
                                             std::span<const PhotoFeatures> features) {
  std::vector<BundleSighting> sightings;
  for (std::size_t i = 0; i < tracks.size(); ++i)
    for (const auto& [photo, feature] : tracks[i]) {
      const PhotoFeatures& of_photo = features[photo];
      sightings.push_back({int(photo), int(i), of_photo.pixel[std::size_t(feature)],
                           sigma_of(of_photo.size_px[std::size_t(feature)]), true});
    }
  std::stable_sort(sightings.begin(), sightings.end(),
                   [](const auto& a, const auto& b) { return a.camera < b.camera; });
  return sightings;
}

void keep_what_agrees(std::span<const BundleSighting> sightings, const FeaturePoses& poses,
                      FeatureSightings& result) {
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    if (!poses.agrees[i]) continue;
    const BundleSighting& sighting = sightings[i];
    result.photos[std::size_t(sighting.camera)].sightings.push_back(
        {"f" + std::to_string(sighting.point + 1), sighting.pixel, sighting.sigma_px,
         SightedBy::feature});
  }
}

std::size_t matches_between(std::span<const FeatureMatches> matches, std::size_t a, std::size_t b) {
  for (const FeatureMatches& match : matches)
    if (match.first == std::min(a, b) && match.second == std::max(a, b)) return match.pairs.size();
  return 0;
}

// Names the weakest link of each photo that couldn't be placed.
void explain(std::span<const FeaturePhoto> photos, std::span<const FeatureMatches> matches,
             FeatureSightings& result) {
  for (std::size_t i = 0; i < photos.size(); ++i) {
    if (result.camera_from_world[i]) continue;
    const std::size_t before = i > 0 ? i - 1 : photos.size() - 1;
    const std::size_t after = i + 1 < photos.size() ? i + 1 : 0;
    const bool back = matches_between(matches, before, i) <= matches_between(matches, i, after);
    result.sentences.push_back(
        "too few features were matched between photos " + photos[back ? before : i].name + " and " +
        photos[back ? i : after].name + ": put markers around the tree, or take photos in between");
  }
}

}  // namespace

FeatureSightings find_features(std::span<const FeaturePhoto> photos, const Lens& lens,
                               bool lens_known, const FeatureOptions& options, Progress& progress) {
  const std::vector<PhotoFeatures> features = detect_all(photos, options, progress);
  const std::vector<FeatureMatches> matches = match_photos(features, options, progress);
  const std::vector<FeatureTrack> tracks =
      chosen_tracks(feature_tracks(features, matches), photos.size(), options.tracks_per_photo);
  const std::vector<BundleSighting> sightings = bundle_sightings(tracks, features);
  const FeaturePoses poses =
      place_by_features(sightings, photos.size(), tracks.size(), lens, lens_known, progress);
  FeatureSightings result;
  result.lens = poses.lens;
  result.camera_from_world = poses.camera_from_world;
  for (const FeaturePhoto& photo : photos) result.photos.push_back(without_sightings(photo));
  keep_what_agrees(sightings, poses, result);
  explain(photos, matches, result);
  return result;
}

}  // namespace bosk
