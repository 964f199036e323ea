#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/matte/matte.h"
#include "core/matte/stroke_model.h"

namespace bosk {

// A scribbled photo and what its strokes teach.
struct Teacher {
  const Photo* photo = nullptr;
  StrokeModel model;
  double likelihood = 0.0;  // mean over its own pixels, natural logarithm
};

std::vector<Teacher> learn_from_scribbles(const Photos& photos, const Scribbles& scribbles,
                                          const MatteOptions& options, Progress& progress);

// What is settled about a photo, on a sample of its pixels, before all of them are matted.
struct Study {
  const Teacher* teacher = nullptr;
  glm::vec3 gain{1.0f};         // brings the photo's linear light to the teacher's exposure
  double likelihood = 0.0;      // how well the teacher's colours explain the photo
  Image<std::uint8_t> strokes;  // of the sample; empty without strokes
  Image<float> mean_alpha;      // coarse
};

// Finds the teacher (a scribbled photo is its own), the gain and, in a few rounds, the region that
// the tree fills. `strokes` is empty for a photo without strokes.
Study study_photo(const Photo& photo, const Image<std::uint8_t>& strokes,
                  const std::vector<Teacher>& teachers, const MatteOptions& options,
                  Progress& progress);

// Rounds again, with what the other photos say, then matts every pixel.
Image<float> alpha_of_photo(const Photo& photo, const Study& study, const Image<float>& hull_tilt,
                            const MatteOptions& options, Progress& progress);

}  // namespace bosk
