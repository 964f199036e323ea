#include "core/matte/matte_doubt.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/image/colour.h"
#include "core/matte/colour_cells.h"
#include "core/matte/hull.h"
#include "core/matte/photo_matte.h"
#include "core/matte/teacher.h"

namespace bosk {
namespace {

constexpr double kSample = 50000.0;  // pixels of each photo
constexpr std::size_t kFewest = 3;   // mattes
constexpr double kSmaller = 0.9;     // of the median size: trees differ that much from side to side
constexpr double kMissing = 2.0;     // what is missing spoils a hull more than what is too much
constexpr double kStandsOut = 1.3;   // of the median
constexpr double kWorthAWord = 0.01;  // share of the photo

// Shares of a photo by colour.
struct ColourShares {
  std::vector<double> tree, background;
  double cover = 0.0;  // mean alpha
};

ColourShares shares_of(const Photo& photo, const Matte& matte) {
  ColourShares shares{std::vector<double>(kAllColourCells), std::vector<double>(kAllColourCells),
                      0.0};
  const int step = step_for(matte.rgba.size(), kSample);
  const int columns = (matte.rgba.width() + step - 1) / step;
  const int rows = (matte.rgba.height() + step - 1) / step;
  const double weight = 1.0 / (double(columns) * rows);
  for (int y = 0; y < matte.rgba.height(); y += step) {
    for (int x = 0; x < matte.rgba.width(); x += step) {
      const double alpha = matte.rgba(x, y).a;
      shares.cover += weight * alpha;
      if (photo.srgb.empty()) continue;
      const std::size_t cell = colour_cell(lab_from_srgb(photo.srgb(x, y)));
      shares.tree[cell] += weight * alpha;
      shares.background[cell] += weight * (1.0 - alpha);
    }
  }
  return shares;
}

// The share of the photo that is held for tree although the other photos hold its colours for
// background.
double strange_share(const ColourShares& own, const std::vector<double>& all_tree,
                     const std::vector<double>& all_background) {
  double strange = 0.0;
  for (std::size_t c = 0; c < own.tree.size(); ++c) {
    const double tree = all_tree[c] - own.tree[c];
    const double background = all_background[c] - own.background[c];
    if (tree + background > 1e-6) strange += own.tree[c] * background / (tree + background);
  }
  return strange;
}

std::vector<double> strange_shares(const std::vector<ColourShares>& shares) {
  std::vector<double> tree(shares.front().tree.size()), background(tree.size());
  for (const ColourShares& one : shares) {
    for (std::size_t c = 0; c < tree.size(); ++c) {
      tree[c] += one.tree[c];
      background[c] += one.background[c];
    }
  }
  std::vector<double> strange;
  for (const ColourShares& one : shares) strange.push_back(strange_share(one, tree, background));
  return strange;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// How large the tree is in each photo, whatever its distance and lens, against the median: 1 for
// all where the cameras don't tell.
std::vector<double> relative_sizes(const Photos& photos, const std::vector<ColourShares>& shares) {
  std::vector<double> sizes(photos.size(), 1.0);
  const auto centre = place_seen_by_all(photos);
  if (!centre) return sizes;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const Camera& camera = photos[i].camera;
    const double distance = glm::distance(camera.centre_in_world(), *centre);
    sizes[i] = shares[i].cover * double(photos[i].camera.lens.width_px) *
               photos[i].camera.lens.height_px * distance * distance /
               (camera.lens.focal_px.x * camera.lens.focal_px.y);
  }
  const double median = std::max(median_of(sizes), 1e-12);
  for (double& size : sizes) size = std::max(size / median, 1e-3);
  return sizes;
}

std::string percent(double share) { return std::to_string(int(std::lround(100.0 * share))) + " %"; }

// What was found out about one matte.
struct Findings {
  double cover = 0.0;    // mean alpha
  double strange = 0.0;  // share of the photo (strange_share)
  double usual = 0.0;    // the same in most photos, had they this cover
  double size = 1.0;     // of the tree, against most photos
};

MatteDoubt weighed(const std::string& photo, const Findings& found) {
  const double excess = found.cover * std::max(0.0, std::log(found.size));
  const double missing = kMissing * found.cover * std::max(0.0, std::log(kSmaller / found.size));
  const double unusual = found.strange - found.usual;
  MatteDoubt doubt{photo, found.strange + excess + missing, {}};
  const double most = std::max({unusual, excess, missing});
  if (most < kWorthAWord) return doubt;
  if (most == missing) {
    doubt.reason = "the tree is " + percent(1.0 - found.size) + " smaller than in most photos";
  } else if (most == excess) {
    doubt.reason = "the tree is " + percent(found.size - 1.0) + " larger than in most photos";
  } else {
    doubt.reason = percent(found.strange / found.cover) +
                   " of the tree has colours that are background in other photos; " +
                   percent(found.usual / found.cover) + " is usual";
  }
  return doubt;
}

MatteDoubt weighed_alone(const std::string& photo, double cover) {
  if (cover < kNothing) return {photo, 1.0, "the matte is clear everywhere"};
  if (cover > kAll) return {photo, 1.0, "the matte is opaque everywhere"};
  return {photo, 0.0, {}};
}

}  // namespace

std::vector<MatteDoubt> doubt_mattes(const Photos& photos, const Mattes& mattes,
                                     Progress& progress) {
  std::vector<ColourShares> shares(mattes.size());
  progress.begin("Comparing mattes", mattes.size());
  tbb::parallel_for(std::size_t(0), mattes.size(), [&](std::size_t i) {
    shares[i] = shares_of(photos[i], mattes[i]);
    progress.advance();
  });
  std::vector<MatteDoubt> doubts;
  for (std::size_t i = 0; i < mattes.size(); ++i) {
    doubts.push_back(weighed_alone(mattes[i].name, shares[i].cover));
  }
  if (mattes.size() < kFewest) return doubts;
  const std::vector<double> strange = strange_shares(shares);
  std::vector<double> of_tree;
  for (std::size_t i = 0; i < mattes.size(); ++i) {
    of_tree.push_back(strange[i] / std::max(shares[i].cover, kNothing));
  }
  const double usual = median_of(of_tree);
  const std::vector<double> sizes = relative_sizes(photos, shares);
  for (std::size_t i = 0; i < mattes.size(); ++i) {
    if (doubts[i].doubt > 0.0) continue;
    const double cover = shares[i].cover;
    doubts[i] = weighed(mattes[i].name, {cover, strange[i], usual * cover, sizes[i]});
  }
  return doubts;
}

double median_doubt(const std::vector<MatteDoubt>& doubts) {
  if (doubts.empty()) return 0.0;
  std::vector<double> values;
  for (const MatteDoubt& doubt : doubts) values.push_back(doubt.doubt);
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool stands_out(const MatteDoubt& doubt, double median) {
  return doubt.doubt > kStandsOut * median;
}

}  // namespace bosk
