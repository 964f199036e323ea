#include "core/matte/matte.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/matte/agreement.h"
#include "core/matte/photo_matte.h"
#include "core/matte/study.h"

namespace bosk {
namespace {

constexpr std::size_t kStudyRows = 1500;  // about, of the samples of one photo
constexpr double kWorseFit = 4.0;  // natural logarithm, mean per pixel, below the teacher's own fit
constexpr float kStrangeGain =
    3.0f;  // a factor in linear light that a session's photos rarely differ by

void warn_of_fit(const Photo& photo, const Study& study, Progress& progress) {
  if (study.lesson.teacher->photo == &photo) return;
  const float most = std::max({study.lesson.gain.r, study.lesson.gain.g, study.lesson.gain.b});
  const float least = std::min({study.lesson.gain.r, study.lesson.gain.g, study.lesson.gain.b});
  const std::string remedy =
      "; look at its matte and, if it is wrong, draw a few strokes over this photo too";
  if (most > kStrangeGain || least < 1.0f / kStrangeGain) {
    progress.warn("photo " + photo.name + " is exposed very differently from the scribbled photo " +
                  study.lesson.teacher->photo->name + remedy);
  } else if (study.lesson.likelihood < study.lesson.teacher->likelihood - kWorseFit) {
    progress.warn("photo " + photo.name + " has colours that the strokes over " +
                  study.lesson.teacher->photo->name + " do not cover" + remedy);
  }
}

void warn_of_result(const Photo& photo, const Matte& matte, Progress& progress) {
  double sum = 0.0;
  for (const glm::vec4& pixel : matte.rgba.pixels()) sum += pixel.a;
  const double mean = sum / double(std::max<std::size_t>(1, matte.rgba.size()));
  if (mean < kNothing) {
    progress.warn("photo " + photo.name +
                  ": the matte is clear everywhere; draw strokes over the tree in this "
                  "photo, or leave it out");
  } else if (mean > kAll) {
    progress.warn("photo " + photo.name +
                  ": the matte is opaque everywhere; draw strokes over the background in "
                  "this photo, or leave it out");
  }
}

Image<std::uint8_t> strokes_of(const Photo& photo, const Scribbles& scribbles) {
  const auto found = scribbles.find(photo.name);
  return found == scribbles.end() ? Image<std::uint8_t>() : found->second;
}

std::size_t rows_of_scribbled(const Photos& photos, const Scribbles& scribbles) {
  std::size_t rows = 0;
  for (const Photo& photo : photos)
    rows += scribbles.contains(photo.name) ? std::size_t(photo.srgb.height()) : 0;
  return rows;
}

std::vector<Study> study_all(const Photos& photos, const Scribbles& scribbles,
                             const std::vector<Teacher>& teachers, const MatteOptions& options,
                             Progress& progress) {
  std::vector<Study> studies;
  for (const Photo& photo : photos) {
    const double share = 0.2 / double(photos.size()), done = double(studies.size());
    progress.begin("Finding the tree in " + photo.name, kStudyRows, 0.1 + share * done,
                   0.1 + share * (done + 1));
    studies.push_back(
        study_photo(photo, strokes_of(photo, scribbles), teachers, options, progress));
    warn_of_fit(photo, studies.back(), progress);
  }
  return studies;
}

std::optional<Ground> ground_of(const Photos& photos, const std::vector<Study>& studies,
                                Progress& progress) {
  std::vector<LabPlanes> samples;
  for (std::size_t i = 0; i < photos.size(); ++i)
    samples.push_back(
        lab_planes(photos[i].srgb, studies[i].lesson.gain, studies[i].step, progress));
  return find_ground(photos, samples, progress);
}

void compare_photos(const Photos& photos, const MatteOptions& options,
                    const std::optional<Ground>& ground, bool settled, std::vector<Study>& studies,
                    Progress& progress) {
  std::vector<Image<float>> outlines;
  outlines.reserve(studies.size());
  for (const Study& study : studies) outlines.push_back(study.outline);
  const auto tilts =
      agreement_tilts(photos, outlines, ground, settled, float(options.hull_weight), progress);
  for (std::size_t i = 0; i < photos.size(); ++i) {
    study_again(photos[i], tilts[i], options, studies[i], progress);
  }
}

void require_pixels(const Photos& photos) {
  for (const Photo& photo : photos) {
    if (photo.srgb.empty())
      throw Error("photo " + photo.name + " has no pixels to matte; add the photo itself");
  }
}

Matte matte_photo(const Photo& photo, const Study& study, const MatteOptions& options,
                  Progress& progress) {
  const Matte matte =
      matte_from_study(photo, linear_light(photo.srgb, progress), study, options, progress);
  warn_of_result(photo, matte, progress);
  return matte;
}

}  // namespace

Mattes matte_photos(const Photos& photos, const Scribbles& scribbles, const MatteOptions& options,
                    Progress& progress) {
  require_pixels(photos);
  progress.begin("Colours of the strokes", rows_of_scribbled(photos, scribbles), 0.0, 0.05);
  auto teachers = learn_from_scribbles(photos, scribbles, options, progress);
  if (teachers.empty()) {
    throw Error("no photo has strokes; draw some over one photo, or import mattes");
  }
  progress.begin("Background of the scribbled photos", kStudyRows * teachers.size(), 0.05, 0.1);
  for (Teacher& teacher : teachers)
    complete(teacher, strokes_of(*teacher.photo, scribbles), options, progress);
  auto studies = study_all(photos, scribbles, teachers, options, progress);
  progress.begin("What all photos agree on", kHullRounds * kStudyRows * photos.size(), 0.3, 0.5);
  const std::optional<Ground> ground = ground_of(photos, studies, progress);
  for (int round = 0; round < kHullRounds; ++round)
    compare_photos(photos, options, ground, round > 0, studies, progress);
  const double share = 0.5 / double(std::max<std::size_t>(1, photos.size()));
  Mattes mattes;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    progress.begin("Matte of " + photos[i].name, kRowSteps * std::size_t(photos[i].srgb.height()),
                   0.5 + share * double(i), 0.5 + share * double(i + 1));
    mattes.push_back(matte_photo(photos[i], studies[i], options, progress));
  }
  return mattes;
}

}  // namespace bosk
