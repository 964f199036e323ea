#pragma once

#include <cstdint>
#include <vector>

#include "core/matte/teacher.h"

namespace bosk {

// Pixels of a photo that settle where the tree is; fewer are quicker and a little less sure.
constexpr double kStudySample = 50000.0;

// What is settled about a photo, on a sample of its pixels, before all of them are matted.
struct Study {
  Lesson lesson;
  int step = 1;                 // every step-th pixel of every step-th row is in the sample
  Image<std::uint8_t> strokes;  // of the sample; empty for a photo without strokes of its own
  bool own_teacher = false;     // else strokes of its own are of one kind and correct the teacher's
  StrokeModel drawn;            // the teacher's strokes, and those that correct them
  StrokeModel model;            // the same, later with the photo's own background
  Image<float> place_tilt;  // coarse: what is believed of each place before any colour is looked at
  Image<float> mean_alpha;  // coarse: of the surroundings
  Image<float> outline;     // coarse: of the near surroundings
  Image<float> alpha;       // of the sample
};

// Adds to the teacher's model what the photo shows of the background where the tree surely isn't:
// strokes show only some of its colours, and other photos show the others too. `strokes` are the
// teacher's own.
void complete(Teacher& teacher, const Image<std::uint8_t>& strokes, const MatteOptions& options,
              Progress& progress, double sample = kStudySample);

// Finds the teacher, the gain and, in a few rounds, the region that the tree fills. `strokes` is
// empty for a photo without strokes.
Study study_photo(const Photo& photo, const Image<std::uint8_t>& strokes,
                  const std::vector<Teacher>& teachers, const MatteOptions& options,
                  Progress& progress, double sample = kStudySample);

// Finds the region again with what the other photos say of each place (hull.h). A photo without
// strokes of its own now learns its background's colours from where they all see background.
void study_again(const Photo& photo, const Image<float>& hull_tilt, const MatteOptions& options,
                 Study& study, Progress& progress);

// Opacity of every pixel.
Image<float> alpha_of_photo(const Photo& photo, const Study& study, const MatteOptions& options,
                            Progress& progress);

}  // namespace bosk
