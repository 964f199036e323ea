#pragma once

#include <vector>

#include "core/matte/alpha.h"
#include "core/matte/matte.h"
#include "core/matte/stroke_model.h"

namespace bosk {

// A scribbled photo and what its strokes teach.
struct Teacher {
  const Photo* photo = nullptr;
  StrokeModel strokes;      // what was drawn
  StrokeModel model;        // later with the background that the rest of the photo shows
  double likelihood = 0.0;  // mean over its own pixels, natural logarithm
};

// In the order of the photos; those with strokes of one kind teach nothing. Throws Error for
// strokes of another size than the photo, and where all strokes are of one kind.
std::vector<Teacher> learn_from_scribbles(const Photos& photos, const Scribbles& scribbles,
                                          const MatteOptions& options, Progress& progress);

// How well the teacher's model explains its own photo.
double own_likelihood(const Teacher& teacher, const MatteOptions& options, Progress& progress);

// Whose colours explain the photo best, and the gain that brings its linear light to their
// exposure.
struct Lesson {
  const Teacher* teacher = nullptr;
  glm::vec3 gain{1.0f};
  double likelihood = 0.0;  // mean over the photo's pixels, natural logarithm
};

// A scribbled photo is its own teacher. `teachers` is not empty.
Lesson choose_teacher(const Photo& photo, const std::vector<Teacher>& teachers,
                      const MatteOptions& options, Progress& progress);

AlphaSettings alpha_settings(bool own_strokes, const MatteOptions& options);

// The step at which about `sample` of so many pixels are visited.
int step_for(std::size_t pixels, double sample);

}  // namespace bosk
