#include "core/matte/ground.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/matte/blur.h"

namespace bosk {
namespace {

constexpr int kGridSize = 128;            // cells along the longer side of a photo
constexpr std::size_t kFewest = 4;        // photos
constexpr int kRings = 12, kSpokes = 48;  // of places on the ground that find its height
constexpr double kInnermost = 0.1, kOutermost = 0.7;  // rings, of the cameras' distance
constexpr int kHeights = 48;                          // tried, twice
constexpr double kHighest = 0.02, kLowest = 0.6;      // below the lowest camera, of their distance
constexpr double kEnoughPlaces = 0.5;  // share of the places that enough photos must show
constexpr float kMostSpread = 20.0f;   // Lab; one strange place counts no more than this
constexpr float kStandsOut = 0.8f;     // the best height's spread against the median height's
constexpr float kLeastTolerance = 3.0f, kSpreads = 1.5f;  // Lab; multiples of the places' spread
constexpr float kMostOff = 9.0f;                          // squared, in tolerances
constexpr float kBlurCells = 1.2f;  // grass, leaves and specks of light are finer than cells
constexpr float kAlike = 0.6f, kUnlike = 0.2f;  // exp(1 - mean square): likeness 1 and 0
constexpr float kFewestKnown = 0.3f;            // of the cells close by
constexpr int kStandsFrom = 2, kStandsTo = 3;   // cells of the volume above the ground
constexpr float kStandsSurely = 0.33f;          // alpha agreed on there

// A photo's mean colours on a coarse grid, and its camera in cells of that.
struct View {
  LabPlanes lab;
  glm::dmat3 camera_from_world{1.0};
  glm::dvec3 translation{0.0}, centre{0.0};
  glm::dvec2 focal_cells{1.0}, principal_cells{0.0};  // a cell covers [i, i + 1]

  int width() const { return lab.l.width(); }
  int height() const { return lab.l.height(); }
  glm::vec3 colour(int x, int y) const { return {lab.l(x, y), lab.a(x, y), lab.b(x, y)}; }
};

glm::ivec2 grid_size_of(int width, int height) {
  const double scale = std::min(1.0, double(kGridSize) / std::max(width, height));
  return {std::max(1, int(std::lround(width * scale))),
          std::max(1, int(std::lround(height * scale)))};
}

Image<float> coarse(const Image<float>& plane, const glm::ivec2& size) {
  Image<float> sum(size.x, size.y), count(size.x, size.y);
  for (int y = 0; y < plane.height(); ++y) {
    for (int x = 0; x < plane.width(); ++x) {
      const int u = x * size.x / plane.width(), v = y * size.y / plane.height();
      sum(u, v) += plane(x, y);
      count(u, v) += 1.0f;
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum.data()[i] /= count.data()[i];
  return sum;
}

View empty_view(const Photo& photo, const glm::ivec2& size) {
  View view;
  const RigidTransform& pose = photo.camera.camera_from_world;
  view.camera_from_world = pose.rotation;
  view.translation = pose.translation;
  view.centre = photo.camera.centre_in_world();
  const Lens& lens = photo.camera.lens;
  const glm::dvec2 scale = glm::dvec2(size) / glm::dvec2(lens.width_px, lens.height_px);
  view.focal_cells = lens.focal_px * scale;
  view.principal_cells = (lens.principal_px + 0.5) * scale;
  return view;
}

View view_of(const Photo& photo, const LabPlanes& sample) {
  const glm::ivec2 size = grid_size_of(sample.l.width(), sample.l.height());
  View view = empty_view(photo, size);
  view.lab = {coarse(sample.l, size), coarse(sample.a, size), coarse(sample.b, size)};
  return view;
}

std::optional<glm::vec3> colour_seen(const View& view, const glm::dvec3& place) {
  const glm::dvec3 seen = view.camera_from_world * place + view.translation;
  if (seen.z <= 0.0) return std::nullopt;
  const glm::dvec2 cell = view.focal_cells * glm::dvec2(seen) / seen.z + view.principal_cells;
  if (!(cell.x >= 0.0 && cell.y >= 0.0 && cell.x < view.width() && cell.y < view.height()))
    return std::nullopt;
  return view.colour(int(cell.x), int(cell.y));
}

// The place on the ground that the centre of a cell shows; none at or above the horizon.
std::optional<glm::dvec3> place_shown(const View& view, int x, int y, double ground_m) {
  const glm::dvec2 slope = (glm::dvec2(x, y) + 0.5 - view.principal_cells) / view.focal_cells;
  const glm::dvec3 ray = glm::transpose(view.camera_from_world) * glm::dvec3(slope, 1.0);
  if (!(ray.z < 0.0 && view.centre.z > ground_m)) return std::nullopt;
  return view.centre + ray * ((ground_m - view.centre.z) / ray.z);
}

float median(std::vector<float>& values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct AgreedColour {
  glm::vec3 lab{0.0f};  // median of the photos
  float spread = 0.0f;  // median distance from it
};

// Buffers of one thread.
struct Workspace {
  std::vector<glm::vec3> colours;
  std::vector<float> values;
};

// What all photos but `left_out` (may be none: views.size()) show at the place; none where too few
// see it. What hides it in fewer than half of them changes little.
std::optional<AgreedColour> agreed_colour(const std::vector<View>& views, std::size_t left_out,
                                          const glm::dvec3& place, Workspace& work) {
  work.colours.clear();
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (i == left_out) continue;
    if (const auto colour = colour_seen(views[i], place)) work.colours.push_back(*colour);
  }
  const std::size_t count = work.colours.size();
  if (count + 1 < kFewest || 3 * count < views.size()) return std::nullopt;
  AgreedColour agreed;
  work.values.resize(count);
  for (int c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < count; ++k) work.values[k] = work.colours[k][c];
    agreed.lab[c] = median(work.values);
  }
  for (std::size_t k = 0; k < count; ++k)
    work.values[k] = glm::distance(work.colours[k], agreed.lab);
  agreed.spread = median(work.values);
  return agreed;
}

// Mean over places around the foot; the most possible where too few can be seen.
float spread_around(const std::vector<View>& views, const glm::dvec3& foot, double distance) {
  Workspace work;
  float sum = 0.0f;
  int count = 0;
  for (int i = 0; i < kRings * kSpokes; ++i) {
    const double ring = double(i / kSpokes) / (kRings - 1);
    const double radius = distance * std::lerp(kInnermost, kOutermost, ring);
    const double angle = 2.0 * std::numbers::pi * (i % kSpokes) / kSpokes;
    const glm::dvec3 offset(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    const auto agreed = agreed_colour(views, views.size(), foot + offset, work);
    if (!agreed) continue;
    sum += std::min(agreed->spread, kMostSpread);
    ++count;
  }
  return count < kEnoughPlaces * kRings * kSpokes ? kMostSpread : sum / float(count);
}

struct Heights {
  std::vector<double> below_eye_m;  // growing by a constant factor
  std::vector<float> spread;
  std::size_t best = 0;
};

Heights try_heights(const std::vector<View>& views, const glm::dvec3& eye, double distance,
                    double highest, double lowest, Progress& progress) {
  Heights heights{std::vector<double>(kHeights), std::vector<float>(kHeights), 0};
  tbb::parallel_for(std::size_t(0), std::size_t(kHeights), [&](std::size_t k) {
    const double below = highest * std::pow(lowest / highest, double(k) / (kHeights - 1));
    heights.below_eye_m[k] = below;
    heights.spread[k] = spread_around(views, eye - glm::dvec3(0.0, 0.0, below), distance);
    progress.check();
  });
  const auto least = std::min_element(heights.spread.begin(), heights.spread.end());
  heights.best = std::size_t(least - heights.spread.begin());
  return heights;
}

bool stands_out(const Heights& heights) {
  if (heights.best == 0 || heights.best + 1 == heights.spread.size()) return false;
  std::vector<float> spreads = heights.spread;
  return heights.spread[heights.best] < kStandsOut * median(spreads);
}

// World z; `axis` is where the optical axes meet.
std::optional<double> ground_height(const std::vector<View>& views, const glm::dvec3& axis,
                                    Progress& progress) {
  double distance = 0.0;
  glm::dvec3 eye(axis.x, axis.y, views.front().centre.z);
  for (const View& view : views) {
    distance += glm::distance(glm::dvec2(view.centre), glm::dvec2(axis)) / double(views.size());
    eye.z = std::min(eye.z, view.centre.z);
  }
  const Heights rough =
      try_heights(views, eye, distance, kHighest * distance, kLowest * distance, progress);
  if (!stands_out(rough)) return std::nullopt;
  const Heights fine = try_heights(views, eye, distance, rough.below_eye_m[rough.best - 1],
                                   rough.below_eye_m[rough.best + 1], progress);
  return eye.z - fine.below_eye_m[fine.best];
}

Image<float> likeness_of(const std::vector<View>& views, std::size_t i, double ground_m,
                         const Progress& progress) {
  const View& view = views[i];
  Image<float> off(view.width(), view.height()), known(view.width(), view.height());
  tbb::parallel_for(0, view.height(), [&](int y) {
    Workspace work;
    progress.check();
    for (int x = 0; x < view.width(); ++x) {
      const auto place = place_shown(view, x, y, ground_m);
      const auto agreed = place ? agreed_colour(views, i, *place, work) : std::nullopt;
      if (!agreed) continue;
      const float tolerance = std::max(kLeastTolerance, kSpreads * agreed->spread);
      const glm::vec3 offset = (view.colour(x, y) - agreed->lab) / tolerance;
      off(x, y) = std::min(glm::dot(offset, offset), kMostOff);
      known(x, y) = 1.0f;
    }
  });
  off = blurred(off, kBlurCells);
  known = blurred(known, kBlurCells);
  for (std::size_t k = 0; k < off.size(); ++k) {
    const float share = known.data()[k], mean = off.data()[k] / std::max(share, kFewestKnown);
    const float alike = (std::exp(1.0f - mean) - kUnlike) / (kAlike - kUnlike);
    off.data()[k] = share < kFewestKnown ? 0.0f : std::clamp(alike, 0.0f, 1.0f);
  }
  return off;
}

// The most that the volume holds a little above the place or beside that.
float alpha_standing_on(const AgreedVolume& volume, const glm::dvec3& place) {
  const glm::ivec3 cell = volume.cell_of(place);
  float most = 0.0f;
  for (int z = cell.z + kStandsFrom; z <= cell.z + kStandsTo; ++z) {
    for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
      for (int x = cell.x - 1; x <= cell.x + 1; ++x) most = std::max(most, volume.at({x, y, z}));
    }
  }
  return most;
}

}  // namespace

std::optional<Ground> find_ground(const Photos& photos, const std::vector<LabPlanes>& samples,
                                  Progress& progress) {
  if (photos.size() < kFewest) return std::nullopt;
  const auto axis = place_seen_by_all(photos);
  if (!axis) return std::nullopt;
  std::vector<View> views;
  for (std::size_t i = 0; i < photos.size(); ++i) views.push_back(view_of(photos[i], samples[i]));
  const auto height = ground_height(views, *axis, progress);
  if (!height) return std::nullopt;
  Ground ground{*height, {}};
  for (std::size_t i = 0; i < photos.size(); ++i)
    ground.likeness.push_back(likeness_of(views, i, *height, progress));
  return ground;
}

std::vector<Image<float>> ground_tilts(const Photos& photos, const Ground& ground,
                                       const std::optional<AgreedVolume>& volume, float weight,
                                       Progress& progress) {
  std::vector<Image<float>> tilts = ground.likeness;
  tbb::parallel_for(std::size_t(0), photos.size(), [&](std::size_t i) {
    progress.check();
    Image<float>& tilt = tilts[i];
    const View view = empty_view(photos[i], {tilt.width(), tilt.height()});
    for (int y = 0; y < tilt.height(); ++y) {
      for (int x = 0; x < tilt.width(); ++x) {
        const auto place = place_shown(view, x, y, ground.height_m);
        const float standing = volume && place ? alpha_standing_on(*volume, *place) : 0.0f;
        tilt(x, y) *= kMostDoubt * weight * std::max(0.0f, 1.0f - standing / kStandsSurely);
      }
    }
  });
  return tilts;
}

}  // namespace bosk
