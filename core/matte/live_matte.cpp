#include "core/matte/live_matte.h"

#include <algorithm>

#include "core/image/area_mean.h"
#include "core/matte/agreement.h"
#include "core/matte/photo_matte.h"
#include "core/matte/surroundings.h"
#include "core/photo/import.h"

namespace bosk {
namespace {

constexpr double kLiveSample = 10000.0;   // pixels that settle where the tree is
constexpr std::size_t kStudyRows = 1300;  // about, of all samples

Photo reduced(const Photo& photo, double megapixels) {
  const glm::ivec2 size = working_size(photo.srgb.width(), photo.srgb.height(), megapixels);
  Photo small{photo.name, photo.camera, photo.original_camera, {}};
  small.camera.lens = scaled(photo.camera.lens, size.x, size.y);
  small.srgb = area_mean_srgb(photo.srgb, size.x, size.y);
  return small;
}

std::string what_is_missing(const Image<std::uint8_t>& strokes) {
  const bool tree = has_kind(strokes, kForegroundStroke),
             background = has_kind(strokes, kBackgroundStroke);
  if (tree && background) return {};
  if (tree) return "Now draw over the background: the sky, the ground, whatever lies behind.";
  if (background) return "Now draw over the tree: leaves in light and in shade, and the trunk.";
  return "Draw over the tree and over the background.";
}

Study studied(const LivePhoto& photo, const Image<std::uint8_t>& strokes,
              const std::vector<Teacher>& teachers, const Image<float>& hull_tilt,
              const MatteOptions& options, Progress& progress) {
  Study study = study_photo(photo.full, strokes, teachers, options, progress, kLiveSample);
  for (int round = 0; round < kHullRounds; ++round)
    study_again(photo.full, hull_tilt, options, study, progress);
  return study;
}

// The photos' exposures are taken as they are.
std::optional<Ground> ground_of(const Photos& photos, Progress& progress) {
  std::vector<LabPlanes> samples;
  for (const Photo& photo : photos) {
    const int step = step_for(photo.srgb.size(), kStudySample);
    samples.push_back(lab_planes(photo.srgb, glm::vec3(1.0f), step, progress));
  }
  return find_ground(photos, samples, progress);
}

}  // namespace

LivePhoto ready_for_live(const Photo& photo, Progress& progress, double megapixels) {
  LivePhoto live{photo, {}, reduced(photo, megapixels), {}};
  live.lab = lab_planes(photo.srgb, glm::vec3(1.0f), 1, progress);
  live.small_linear = linear_light(live.small.srgb, progress);
  return live;
}

std::vector<Image<float>> hull_tilts_from(const Photos& photos, const Mattes& mattes,
                                          const MatteOptions& options, Progress& progress) {
  std::vector<Image<float>> outlines;
  for (const Matte& matte : mattes) {
    progress.check();
    Image<float> alpha(matte.rgba.width(), matte.rgba.height());
    std::transform(matte.rgba.pixels().begin(), matte.rgba.pixels().end(), alpha.pixels().begin(),
                   [](const glm::vec4& pixel) { return pixel.a; });
    outlines.push_back(mean_alpha(alpha, {}, kOutlineSigma));
  }
  return agreement_tilts(photos, outlines, ground_of(photos, progress), true,
                         float(options.hull_weight), progress);
}

LiveMatte live_matte(const LivePhoto& photo, const Image<std::uint8_t>& strokes,
                     const Image<float>& hull_tilt, const MatteOptions& options,
                     Progress& progress) {
  const std::string missing = what_is_missing(strokes);
  if (!missing.empty()) return {{photo.full.name, {}}, missing};
  progress.begin("Matte of " + photo.full.name,
                 kStudyRows + kRowSteps * std::size_t(photo.small.srgb.height()));
  const StrokeModel drawn = learn_strokes(photo.lab, strokes, options.clusters);
  progress.check();
  std::vector<Teacher> teachers{{&photo.full, drawn, drawn, 0.0}};
  complete(teachers.front(), strokes, options, progress, kLiveSample);
  const Study study = studied(photo, strokes, teachers, hull_tilt, options, progress);
  return {matte_from_study(photo.small, photo.small_linear, study, options, progress), {}};
}

}  // namespace bosk
