#include "core/matte/teacher.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/matte/exposure.h"

namespace bosk {
namespace {

constexpr double kSample = 5000.0;  // pixels that settle teacher and gain
constexpr float kWorstFit =
    -40.0f;  // pixels of things that no stroke shows count no worse than this
constexpr double kGainMustWin =
    0.3;  // natural logarithm, mean per pixel: else the exposure is left as it is

double mean_likelihood(const Photo& photo, const glm::vec3& gain, const StrokeModel& model,
                       const AlphaSettings& settings, Progress& progress) {
  const LabPlanes lab =
      lab_planes(photo.srgb, gain, step_for(photo.srgb.size(), kSample), progress);
  const AlphaEstimate estimate = estimate_alpha(lab, model, Image<float>(1, 1), settings, progress);
  double sum = 0.0;
  for (const float value : estimate.likelihood.pixels()) sum += std::max(value, kWorstFit);
  return sum / double(estimate.likelihood.size());
}

void try_teacher(const Photo& photo, const Teacher& teacher, const MatteOptions& options,
                 Lesson& best, Progress& progress) {
  const AlphaSettings settings = alpha_settings(false, options);
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

}  // namespace

int step_for(std::size_t pixels, double sample) {
  return std::max(1, int(std::lround(std::sqrt(double(pixels) / sample))));
}

AlphaSettings alpha_settings(bool own_strokes, const MatteOptions& options) {
  AlphaSettings settings;
  settings.mixing = options.mixing;
  settings.position_sigma = float(own_strokes ? options.position_sigma : options.transfer_sigma);
  return settings;
}

std::vector<Teacher> learn_from_scribbles(const Photos& photos, const Scribbles& scribbles,
                                          const MatteOptions& options, Progress& progress) {
  std::vector<Teacher> teachers;
  const Photo* half_drawn = nullptr;
  for (const Photo& photo : photos) {
    const auto found = scribbles.find(photo.name);
    if (found == scribbles.end()) continue;
    const Image<std::uint8_t>& strokes = found->second;
    if (strokes.width() != photo.srgb.width() || strokes.height() != photo.srgb.height()) {
      throw Error("strokes for " + photo.name +
                  ": their size is not the photo's; draw them over the photo");
    }
    if (!has_both_kinds(strokes)) {
      half_drawn = &photo;
      continue;
    }
    const LabPlanes lab = lab_planes(photo.srgb, glm::vec3(1.0f), 1, progress);
    const StrokeModel model = learn_strokes(lab, strokes, options.clusters);
    teachers.push_back({&photo, model, model, 0.0});
    teachers.back().likelihood = own_likelihood(teachers.back(), options, progress);
  }
  if (teachers.empty() && half_drawn) {
    require_both_kinds(scribbles.at(half_drawn->name), "strokes for " + half_drawn->name);
  }
  return teachers;
}

double own_likelihood(const Teacher& teacher, const MatteOptions& options, Progress& progress) {
  return mean_likelihood(*teacher.photo, glm::vec3(1.0f), teacher.model,
                         alpha_settings(true, options), progress);
}

Lesson choose_teacher(const Photo& photo, const std::vector<Teacher>& teachers,
                      const MatteOptions& options, Progress& progress) {
  Lesson best;
  for (const Teacher& teacher : teachers) {
    if (teacher.photo == &photo) return {&teacher, glm::vec3(1.0f), teacher.likelihood};
    try_teacher(photo, teacher, options, best, progress);
  }
  return best;
}

}  // namespace bosk
