#include "core/project/feature_finds.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/image/area_mean.h"
#include "core/photo/import.h"
#include "core/project/binary_items.h"
#include "core/project/calibration_store.h"
#include "core/project/capture.h"
#include "core/project/each_photo.h"
#include "core/project/left_out.h"

namespace bosk {
namespace {

constexpr int kVersion = 1;  // raised whenever the same photos give other features
constexpr const char* kEntry = "features";
constexpr int kEntriesKept = 4;
constexpr int kFewMarkers = 6;  // points of a photo that others show too, for features to help

struct FeatureInput {
  std::vector<SourceFile> photos;
  Strokes left_out;                 // of these photos
  std::vector<std::size_t> places;  // of the photos in the finds
  glm::ivec2 size_px{0};            // of the photos as delivered
  Lens lens;                        // at the size that features are found at
  bool lens_known = false;
};

FeatureInput input_of(const CalibrationSources& sources, const CalibrationFinds& finds) {
  FeatureInput input;
  const Lens& lens = finds.lens.lens;
  input.size_px = {lens.width_px, lens.height_px};
  for (std::size_t i = 0; i < finds.photos.size(); ++i) {
    const PhotoSightings& photo = finds.photos[i];
    if (photo.width_px != lens.width_px || photo.height_px != lens.height_px) continue;
    const auto file = std::find_if(sources.photos.begin(), sources.photos.end(),
                                   [&](const SourceFile& one) { return one.name == photo.photo; });
    input.photos.push_back(*file);
    const auto left_out = sources.left_out.find(file->name);
    if (left_out != sources.left_out.end()) input.left_out.insert(*left_out);
    input.places.push_back(i);
  }
  const glm::ivec2 size =
      working_size(lens.width_px, lens.height_px, sources.options.feature_megapixels);
  input.lens = scaled(lens, size.x, size.y);
  input.lens_known = finds.lens.known;
  return input;
}

ContentHash key_of(const FeatureInput& input, const FeatureOptions& options) {
  ContentHasher hasher;
  hasher.text(kEntry).value(kVersion);
  hash_files(hasher, input.photos);
  hash_camera(hasher, {"", input.lens, {}});
  hasher.value(std::uint8_t(input.lens_known)).value(options.features_per_photo);
  hasher.value(options.ratio).value(options.largest_error_px);
  hasher.value(options.fewest_matches).value(options.tracks_per_photo);
  hash_left_out(hasher, input.left_out);
  return hasher.finish();
}

std::vector<Image<glm::vec3>> small_photos(const FeatureInput& input, const DecodeLimits& limits,
                                           Progress& progress) {
  progress.begin("reading photos for features", input.photos.size());
  std::vector<Image<glm::vec3>> images(input.photos.size());
  for_each_photo(images.size(), limits, progress, [&](std::size_t i, PhotoDecoder& decoder) {
    const DecodedPhoto photo = decoder.decode(input.photos[i].path, progress);
    images[i] = area_mean_srgb(srgb_of(photo), input.lens.width_px, input.lens.height_px);
  });
  return images;
}

// Empty where nothing is left out.
std::vector<Image<std::uint8_t>> masks_of(const FeatureInput& input) {
  std::vector<Image<std::uint8_t>> masks(input.photos.size());
  for (std::size_t i = 0; i < masks.size(); ++i) {
    const auto strokes = input.left_out.find(input.photos[i].name);
    if (strokes == input.left_out.end()) continue;
    masks[i] = mask_of(strokes->second, input.size_px, {input.lens.width_px, input.lens.height_px});
  }
  return masks;
}

FeatureSightings made_features(const FeatureInput& input, const CalibrationSources& sources,
                               Progress& progress) {
  std::vector<Image<glm::vec3>> images;
  {
    const ProgressPart part(progress, 0.0, 0.3);
    images = small_photos(input, sources.limits, progress);
  }
  const std::vector<Image<std::uint8_t>> masks = masks_of(input);
  std::vector<FeaturePhoto> photos;
  for (std::size_t i = 0; i < images.size(); ++i) {
    photos.push_back({input.photos[i].name, &images[i], masks[i].empty() ? nullptr : &masks[i]});
  }
  const ProgressPart part(progress, 0.3, 1.0);
  return find_features(photos, input.lens, input.lens_known, sources.options.feature, progress);
}

FeatureSightings features_of(const FeatureInput& input, const CalibrationSources& sources,
                             const Cache& cache, Progress& progress) {
  const ContentHash key = key_of(input, sources.options.feature);
  if (const auto entry = cache.load(kEntry, key)) {
    try {
      return read_all<FeatureSightings>(entry->result, read_feature_sightings);
    } catch (const Error&) {
      // Made again
    }
  }
  const auto start = std::chrono::steady_clock::now();
  FeatureSightings features = made_features(input, sources, progress);
  BinaryWriter writer;
  write(writer, features);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  cache.store(kEntry, key, writer.bytes(), spent.count());
  cache.forget_old(kEntry, key, kEntriesKept);
  return features;
}

// From the size that features were found at to the photo as delivered; pixel centres stay centres.
Sighting enlarged(Sighting sighting, const glm::dvec2& scale) {
  sighting.pixel = (sighting.pixel + 0.5) * scale - 0.5;
  sighting.sigma_px *= std::max(scale.x, scale.y);
  return sighting;
}

}  // namespace

bool needs_features(const std::vector<PhotoSightings>& photos, const CalibrateOptions& options) {
  if (options.features != "auto") return options.features == "on";
  std::map<std::string, int> photos_of;
  for (const PhotoSightings& photo : photos) {
    for (const Sighting& sighting : photo.sightings) ++photos_of[sighting.point];
  }
  return std::any_of(photos.begin(), photos.end(), [&](const PhotoSightings& photo) {
    const auto shared =
        std::count_if(photo.sightings.begin(), photo.sightings.end(),
                      [&](const Sighting& sighting) { return photos_of[sighting.point] >= 2; });
    return shared < kFewMarkers;
  });
}

bool finds_features(const CalibrationFinds& finds) {
  return std::any_of(finds.photos.begin(), finds.photos.end(), [](const PhotoSightings& photo) {
    return std::any_of(photo.sightings.begin(), photo.sightings.end(),
                       [](const Sighting& one) { return one.by == SightedBy::feature; });
  });
}

void add_features(const CalibrationSources& sources, const Cache& cache, CalibrationFinds& finds,
                  Progress& progress) {
  const FeatureInput input = input_of(sources, finds);
  if (input.photos.size() < 2) return;
  const FeatureSightings features = features_of(input, sources, cache, progress);
  const Lens& lens = finds.lens.lens;
  const glm::dvec2 scale = glm::dvec2(lens.width_px, lens.height_px) /
                           glm::dvec2(input.lens.width_px, input.lens.height_px);
  for (std::size_t i = 0; i < input.places.size(); ++i) {
    PhotoSightings& photo = finds.photos[input.places[i]];
    for (const Sighting& sighting : features.photos[i].sightings) {
      photo.sightings.push_back(enlarged(sighting, scale));
    }
    const auto& pose = features.camera_from_world[i];
    if (pose) finds.first_poses.push_back({photo.photo, *pose});
  }
  finds.feature_sentences = features.sentences;
  if (!finds.lens.known && !finds.first_poses.empty()) {
    finds.lens.lens = scaled(features.lens, lens.width_px, lens.height_px);
  }
}

}  // namespace bosk
