#include "core/matte/study.h"

#include <algorithm>

#include "core/matte/grid.h"
#include "core/matte/surroundings.h"

namespace bosk {
namespace {

constexpr int kRounds = 4;  // region and alpha settle each other
constexpr float kSamplePurity =
    4.0f;  // while the region settles, haze does more harm than hard edges
constexpr float kTransferredPlace = 0.5f;  // strokes of another photo say less of places
constexpr float kSurelyClear = 0.01f;      // mean alpha of the surroundings
constexpr float kMaybeClear = 0.4f;        // alpha itself: a lone stem is opaque amid the clear
constexpr float kMuchNearer = 4.0f;        // squared, in Lab: a tree colour, not one between
constexpr float kRareColour =
    0.02f;  // share; rarer colours nearer to the tree's are overlooked stems
constexpr double kEnoughBackground = 0.1;  // share of a photo that shows its background's colours

Image<std::uint8_t> every_nth(const Image<std::uint8_t>& full, int step) {
  if (full.empty()) return full;
  Image<std::uint8_t> small((full.width() + step - 1) / step, (full.height() + step - 1) / step);
  for (int y = 0; y < small.height(); ++y) {
    for (int x = 0; x < small.width(); ++x) small(x, y) = full(x * step, y * step);
  }
  return small;
}

LabPlanes sampled(const Photo& photo, const Study& study, Progress& progress) {
  return lab_planes(photo.srgb, study.lesson.gain, study.step, progress);
}

Image<float> place_tilt(const Study& study, const MatteOptions& options) {
  const float trust = study.own_teacher ? 1.0f : kTransferredPlace;
  Image<float> tilt = position_tilt(study.drawn, trust * float(options.position_weight));
  if (study.own_teacher || study.strokes.empty()) return tilt;
  return sum_of_grids(tilt, correction_tilt(study.strokes, float(options.position_weight)));
}

// Strokes of one kind teach their colours beside the teacher's.
void add_corrections(const LabPlanes& sample, const MatteOptions& options, Study& study) {
  const Image<float>& map = study.drawn.foreground.front().squared_distance;
  const int width = map.width(), height = map.height();
  const auto add = [&](std::uint8_t kind, std::vector<StrokeCluster> StrokeModel::*side) {
    for (StrokeCluster& cluster : learn_clusters(sample, study.strokes, kind, options.clusters)) {
      cluster.squared_distance = stretched(cluster.squared_distance, width, height);
      (study.drawn.*side).push_back(cluster);
      (study.model.*side).push_back(std::move(cluster));
    }
  };
  add(kForegroundStroke, &StrokeModel::foreground);
  add(kBackgroundStroke, &StrokeModel::background);
}

Image<float> whole_tilt(const Study& study, const MatteOptions& options) {
  return sum_of_grids(region_tilt(study.mean_alpha, float(options.region_weight)),
                      study.place_tilt);
}

void settle_region(const LabPlanes& sample, const MatteOptions& options, Study& study,
                   Progress& progress) {
  AlphaSettings settings = alpha_settings(study.own_teacher, options);
  settings.purity = kSamplePurity;
  Image<float> tilt = study.place_tilt;
  for (int round = 0; round < kRounds; ++round) {
    study.alpha = estimate_alpha(sample, study.model, tilt, settings, progress).alpha;
    study.mean_alpha = mean_alpha(study.alpha, study.strokes, float(options.region_sigma));
    study.outline = mean_alpha(study.alpha, study.strokes, kOutlineSigma);
    tilt = whole_tilt(study, options);
  }
}

float squared_to_nearest(const std::vector<StrokeCluster>& clusters, const glm::vec3& lab) {
  float least = 1e12f;
  for (const StrokeCluster& cluster : clusters) {
    const glm::vec3 offset = lab - cluster.colour.lab;
    least = std::min(least, glm::dot(offset, offset));
  }
  return least;
}

// Background strokes wherever the surroundings or the other photos leave no doubt, beside those
// drawn.
Image<std::uint8_t> sure_background(const LabPlanes& sample, const Image<float>& hull_tilt,
                                    const Study& study) {
  const int width = sample.l.width(), height = sample.l.height();
  const float ruled_out =
      0.9f * *std::min_element(hull_tilt.pixels().begin(), hull_tilt.pixels().end());
  Image<std::uint8_t> strokes = study.strokes;
  if (strokes.empty()) strokes = Image<std::uint8_t>(width, height, kNoStroke);
  const auto value = [&](const Image<float>& grid, int x, int y) {
    return grid(x * grid.width() / width, y * grid.height() / height);
  };
  const auto like_the_tree = [&](int x, int y) {
    const glm::vec3 lab(sample.l(x, y), sample.a(x, y), sample.b(x, y));
    const StrokeModel& drawn = study.drawn;
    return kMuchNearer * squared_to_nearest(drawn.foreground, lab) <
           squared_to_nearest(drawn.background, lab);
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float hull = value(hull_tilt, x, y);
      const bool clear = (value(study.mean_alpha, x, y) < kSurelyClear &&
                          study.alpha(x, y) < kMaybeClear && !like_the_tree(x, y)) ||
                         (hull < 0.0f && hull <= ruled_out);
      if (clear && strokes(x, y) == kNoStroke) strokes(x, y) = kBackgroundStroke;
    }
  }
  return strokes;
}

// Strokes show a few of a background's colours; where the tree surely isn't, the photo shows the
// others.
void learn_own_background(const LabPlanes& sample, const Image<float>& hull_tilt,
                          const MatteOptions& options, Study& study) {
  const Image<std::uint8_t> strokes = sure_background(sample, hull_tilt, study);
  const auto count =
      std::count(strokes.pixels().begin(), strokes.pixels().end(), kBackgroundStroke);
  if (double(count) < kEnoughBackground * double(strokes.size())) return;
  study.model.background = learn_clusters(sample, strokes, kBackgroundStroke, options.clusters);
  const StrokeModel& drawn = study.drawn;
  std::erase_if(study.model.background, [&](const StrokeCluster& cluster) {
    const glm::vec3& lab = cluster.colour.lab;
    return cluster.colour.share < kRareColour &&
           squared_to_nearest(drawn.foreground, lab) < squared_to_nearest(drawn.background, lab);
  });
  if (study.model.background.empty()) study.model.background = drawn.background;
  const Image<float>& like = study.model.foreground.front().squared_distance;
  for (StrokeCluster& cluster : study.model.background) {
    cluster.squared_distance = stretched(cluster.squared_distance, like.width(), like.height());
  }
}

}  // namespace

Study study_photo(const Photo& photo, const Image<std::uint8_t>& strokes,
                  const std::vector<Teacher>& teachers, const MatteOptions& options,
                  Progress& progress, double sample) {
  Study study;
  study.step = step_for(photo.srgb.size(), sample);
  study.lesson = choose_teacher(photo, teachers, options, progress);
  study.strokes = every_nth(strokes, study.step);
  study.own_teacher = study.lesson.teacher->photo == &photo;
  study.drawn = study.lesson.teacher->strokes;
  study.model = study.lesson.teacher->model;
  const LabPlanes planes = sampled(photo, study, progress);
  if (!study.own_teacher && !study.strokes.empty()) add_corrections(planes, options, study);
  study.place_tilt = place_tilt(study, options);
  settle_region(planes, options, study, progress);
  return study;
}

void complete(Teacher& teacher, const Image<std::uint8_t>& strokes, const MatteOptions& options,
              Progress& progress, double sample) {
  const std::vector<Teacher> alone{teacher};
  Study study = study_photo(*teacher.photo, strokes, alone, options, progress, sample);
  learn_own_background(sampled(*teacher.photo, study, progress), Image<float>(1, 1), options,
                       study);
  teacher.model = study.model;
  teacher.likelihood = own_likelihood(teacher, options, progress);
}

void study_again(const Photo& photo, const Image<float>& hull_tilt, const MatteOptions& options,
                 Study& study, Progress& progress) {
  const LabPlanes sample = sampled(photo, study, progress);
  study.place_tilt = sum_of_grids(place_tilt(study, options), hull_tilt);
  learn_own_background(sample, hull_tilt, options, study);
  settle_region(sample, options, study, progress);
}

Image<float> alpha_of_photo(const Photo& photo, const Study& study, const MatteOptions& options,
                            Progress& progress) {
  const LabPlanes lab = lab_planes(photo.srgb, study.lesson.gain, 1, progress);
  const AlphaSettings settings = alpha_settings(study.own_teacher, options);
  return estimate_alpha(lab, study.model, whole_tilt(study, options), settings, progress).alpha;
}

}  // namespace bosk
