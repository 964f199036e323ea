#include "core/matte/study.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/matte/alpha.h"
#include "core/matte/exposure.h"
#include "core/matte/surroundings.h"

namespace bosk {
namespace {

constexpr double kSample = 50000.0;      // pixels that settle where the tree is
constexpr double kSmallSample = 5000.0;  // pixels that settle teacher and gain
constexpr int kRounds = 4;               // region and alpha settle each other
constexpr float kSamplePurity =
    4.0f;  // while the region settles, haze does more harm than hard edges
constexpr float kWorstFit =
    -40.0f;  // pixels of things that no stroke shows count no worse than this
constexpr double kGainMustWin =
    0.3;  // natural logarithm, mean per pixel: else the exposure is left as it is

int step_for(const Image<glm::vec3>& image, double sample) {
  return std::max(1, int(std::lround(std::sqrt(double(image.size()) / sample))));
}

Image<std::uint8_t> every_nth(const Image<std::uint8_t>& full, int step) {
  if (full.empty()) return full;
  Image<std::uint8_t> small((full.width() + step - 1) / step, (full.height() + step - 1) / step);
  for (int y = 0; y < small.height(); ++y) {
    for (int x = 0; x < small.width(); ++x) small(x, y) = full(x * step, y * step);
  }
  return small;
}

AlphaSettings settings_for(bool own_strokes, const MatteOptions& options) {
  AlphaSettings settings;
  settings.mixing = options.mixing;
  settings.position_sigma = float(own_strokes ? options.position_sigma : options.transfer_sigma);
  return settings;
}

double mean_likelihood(const Photo& photo, const glm::vec3& gain, const StrokeModel& model,
                       const AlphaSettings& settings, Progress& progress) {
  const LabPlanes lab = lab_planes(photo.srgb, gain, step_for(photo.srgb, kSmallSample), progress);
  const AlphaEstimate estimate = estimate_alpha(lab, model, Image<float>(1, 1), settings, progress);
  double sum = 0.0;
  for (const float value : estimate.likelihood.pixels()) sum += std::max(value, kWorstFit);
  return sum / double(estimate.likelihood.size());
}

void try_teacher(const Photo& photo, const Teacher& teacher, const MatteOptions& options,
                 Study& best, Progress& progress) {
  const AlphaSettings settings = settings_for(false, options);
  const auto consider = [&](const glm::vec3& gain, double handicap) {
    const double likelihood = mean_likelihood(photo, gain, teacher.model, settings, progress);
    if (best.teacher != nullptr && likelihood - handicap <= best.likelihood) return;
    best.teacher = &teacher;
    best.gain = gain;
    best.likelihood = likelihood;
  };
  consider(glm::vec3(1.0f), 0.0);
  consider(exposure_gain(photo.srgb, teacher.photo->srgb), kGainMustWin);
}

// What the places alone say: strokes of the same or, more weakly, of the teaching photo.
Image<float> place_tilt(const Study& study, const MatteOptions& options) {
  const bool own = !study.strokes.empty();
  return position_tilt(study.teacher->model,
                       float(own ? 1.0 : 0.5) * float(options.position_weight));
}

Image<float> settle_region(const LabPlanes& sample, const Study& study, const Image<float>& place,
                           Image<float> tilt, const MatteOptions& options, Progress& progress) {
  AlphaSettings settings = settings_for(!study.strokes.empty(), options);
  settings.purity = kSamplePurity;
  Image<float> mean;
  for (int round = 0; round < kRounds; ++round) {
    const AlphaEstimate estimate =
        estimate_alpha(sample, study.teacher->model, tilt, settings, progress);
    mean = mean_alpha(estimate.alpha, study.strokes, float(options.region_sigma));
    tilt = sum_of_grids(region_tilt(mean, float(options.region_weight)), place);
  }
  return mean;
}

}  // namespace

std::vector<Teacher> learn_from_scribbles(const Photos& photos, const Scribbles& scribbles,
                                          const MatteOptions& options, Progress& progress) {
  std::vector<Teacher> teachers;
  for (const Photo& photo : photos) {
    const auto found = scribbles.find(photo.name);
    if (found == scribbles.end()) continue;
    const Image<std::uint8_t>& strokes = found->second;
    if (strokes.width() != photo.srgb.width() || strokes.height() != photo.srgb.height()) {
      throw Error("strokes for " + photo.name +
                  ": their size is not the photo's; draw them over the photo");
    }
    require_both_kinds(strokes, "strokes for " + photo.name);
    const LabPlanes lab = lab_planes(photo.srgb, glm::vec3(1.0f), 1, progress);
    Teacher teacher{&photo, learn_strokes(lab, strokes, options.clusters), 0.0};
    teacher.likelihood = mean_likelihood(photo, glm::vec3(1.0f), teacher.model,
                                         settings_for(true, options), progress);
    teachers.push_back(std::move(teacher));
  }
  return teachers;
}

Study study_photo(const Photo& photo, const Image<std::uint8_t>& strokes,
                  const std::vector<Teacher>& teachers, const MatteOptions& options,
                  Progress& progress) {
  Study study;
  for (const Teacher& teacher : teachers) {
    if (teacher.photo == &photo) {
      study.teacher = &teacher;
      study.likelihood = teacher.likelihood;
    }
  }
  if (study.teacher == nullptr) {
    for (const Teacher& teacher : teachers) try_teacher(photo, teacher, options, study, progress);
  }
  const int step = step_for(photo.srgb, kSample);
  study.strokes = every_nth(strokes, step);
  const Image<float> place = place_tilt(study, options);
  const LabPlanes sample = lab_planes(photo.srgb, study.gain, step, progress);
  study.mean_alpha = settle_region(sample, study, place, place, options, progress);
  return study;
}

Image<float> alpha_of_photo(const Photo& photo, const Study& study, const Image<float>& hull_tilt,
                            const MatteOptions& options, Progress& progress) {
  Image<float> place = place_tilt(study, options), mean = study.mean_alpha;
  const auto region = [&] {
    return sum_of_grids(region_tilt(mean, float(options.region_weight)), place);
  };
  if (!hull_tilt.empty()) {
    place = sum_of_grids(place, hull_tilt);
    const LabPlanes sample =
        lab_planes(photo.srgb, study.gain, step_for(photo.srgb, kSample), progress);
    mean = settle_region(sample, study, place, region(), options, progress);
  }
  const LabPlanes lab = lab_planes(photo.srgb, study.gain, 1, progress);
  const AlphaSettings settings = settings_for(!study.strokes.empty(), options);
  return estimate_alpha(lab, study.teacher->model, region(), settings, progress).alpha;
}

}  // namespace bosk
