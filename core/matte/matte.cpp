#include "core/matte/matte.h"

#include <tbb/parallel_for.h>

#include "core/image/colour.h"
#include "core/matte/alpha.h"
#include "core/matte/clean_alpha.h"
#include "core/matte/exposure.h"
#include "core/matte/foreground.h"

namespace bosk {
namespace {

constexpr std::size_t kRowSteps = 3;  // Lab, alpha and foreground each count the rows of a photo

struct ScribbledPhoto {
  const Photo* photo = nullptr;
  StrokeModel model;
};

Image<glm::vec3> linear_light(const Image<glm::vec3>& srgb) {
  Image<glm::vec3> linear(srgb.width(), srgb.height());
  tbb::parallel_for(std::size_t(0), srgb.size(),
                    [&](std::size_t i) { linear.data()[i] = linear_from_srgb(srgb.data()[i]); });
  return linear;
}

Matte with_foreground(const Photo& photo, const Image<float>& alpha, Progress& progress) {
  const Image<glm::vec3> front = estimate_foreground(linear_light(photo.srgb), alpha, progress);
  Matte matte{photo.name, {alpha.width(), alpha.height()}};
  tbb::parallel_for(std::size_t(0), alpha.size(), [&](std::size_t i) {
    matte.rgba.data()[i] = glm::vec4(srgb_from_linear(front.data()[i]), alpha.data()[i]);
  });
  return matte;
}

std::vector<ScribbledPhoto> learn(const Photos& photos, const Scribbles& scribbles,
                                  const MatteOptions& options, Progress& progress) {
  std::vector<ScribbledPhoto> learnt;
  for (const Photo& photo : photos) {
    const auto strokes = scribbles.find(photo.name);
    if (strokes == scribbles.end()) continue;
    require_both_kinds(strokes->second, "strokes for " + photo.name);
    const LabPlanes lab = lab_planes(photo.srgb, glm::vec3(1.0f), progress);
    learnt.push_back({&photo, learn_strokes(lab, strokes->second, options)});
  }
  if (learnt.empty())
    throw Error("no photo has strokes; draw some over one photo, or import mattes");
  return learnt;
}

Matte matte_photo(const Photo& photo, const ScribbledPhoto& teacher, const MatteOptions& options,
                  Progress& progress) {
  const bool own = teacher.photo == &photo;
  const glm::vec3 gain = own ? glm::vec3(1.0f) : exposure_gain(photo.srgb, teacher.photo->srgb);
  const LabPlanes lab = lab_planes(photo.srgb, gain, progress);
  const double sigma = own ? options.position_sigma : options.transfer_sigma;
  AlphaEstimate estimate =
      estimate_alpha(lab, teacher.model, {}, {options.mixing, float(sigma)}, progress);
  stretch_ends(estimate.alpha, float(options.clear_below), float(options.opaque_above));
  return with_foreground(photo, estimate.alpha, progress);
}

}  // namespace

Mattes matte_photos(const Photos& photos, const Scribbles& scribbles, const MatteOptions& options,
                    Progress& progress) {
  const auto learnt = learn(photos, scribbles, options, progress);
  Mattes mattes;
  for (const Photo& photo : photos) {
    const ScribbledPhoto* teacher = &learnt.front();
    for (const ScribbledPhoto& candidate : learnt) {
      if (candidate.photo == &photo) teacher = &candidate;
    }
    progress.begin("Matte of " + photo.name, kRowSteps * std::size_t(photo.srgb.height()),
                   double(mattes.size()) / double(photos.size()),
                   double(mattes.size() + 1) / double(photos.size()));
    mattes.push_back(matte_photo(photo, *teacher, options, progress));
  }
  return mattes;
}

}  // namespace bosk
