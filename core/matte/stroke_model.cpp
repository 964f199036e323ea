#include "core/matte/stroke_model.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/image/colour.h"
#include "core/matte/distance_map.h"
#include "core/matte/grid.h"
#include "core/matte/scribbles.h"

namespace bosk {
namespace {

constexpr std::size_t kMostSamples =
    20000;  // per kind of stroke; more change the clusters by less than noise
constexpr float kLeastVariance = 4.0f;  // (2 Lab units)^2: noise, JPEG and 8-bit steps
constexpr int kGridSize = 256;          // longer side of the distance maps
constexpr float kSloppyRatio =
    4.0f;  // a foreground sample this much likelier under the background goes
constexpr float kGapNearness =
    0.3f;  // a sample that much nearer to the background than to the tree
constexpr float kGapContrast = 40.0f;  // and this many Lab units from the tree's median goes too
constexpr float kMostDropped = 0.4f;   // if more would go, the colours overlap and none is dropped

glm::vec3 lab_at(const LabPlanes& lab, std::size_t i) {
  return {lab.l.data()[i], lab.a.data()[i], lab.b.data()[i]};
}

std::vector<std::size_t> pixels_under(const Image<std::uint8_t>& strokes, std::uint8_t kind) {
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (strokes.data()[i] == kind) pixels.push_back(i);
  }
  return pixels;
}

std::vector<glm::vec3> colours_of(const LabPlanes& lab, const std::vector<std::size_t>& pixels) {
  const std::size_t step =
      std::max<std::size_t>(1, (pixels.size() + kMostSamples - 1) / kMostSamples);
  std::vector<glm::vec3> colours;
  for (std::size_t i = 0; i < pixels.size(); i += step) colours.push_back(lab_at(lab, pixels[i]));
  return colours;
}

std::size_t nearest_cluster(const std::vector<ColourCluster>& clusters, const glm::vec3& colour) {
  const auto nearer = [&](const ColourCluster& p, const ColourCluster& q) {
    return glm::dot(p.lab - colour, p.lab - colour) < glm::dot(q.lab - colour, q.lab - colour);
  };
  return std::size_t(std::min_element(clusters.begin(), clusters.end(), nearer) - clusters.begin());
}

float density(const std::vector<ColourCluster>& clusters, const glm::vec3& colour) {
  float sum = 1e-20f;
  for (const ColourCluster& cluster : clusters) {
    const glm::vec3 offset = colour - cluster.lab;
    sum += cluster.share * std::exp(-0.5f * glm::dot(offset, offset) / cluster.variance) /
           (cluster.variance * std::sqrt(cluster.variance));
  }
  return sum;
}

glm::vec3 median_of(std::vector<glm::vec3> colours) {
  glm::vec3 median(0.0f);
  const auto middle = colours.begin() + std::ptrdiff_t(colours.size() / 2);
  for (int c = 0; c < 3; ++c) {
    std::nth_element(colours.begin(), middle, colours.end(),
                     [c](const glm::vec3& p, const glm::vec3& q) { return p[c] < q[c]; });
    median[c] = (*middle)[c];
  }
  return median;
}

// Sky in a gap need not have the very colour of the sky under a stroke, which changes over the
// photo; but it is nearer to that than to the tree.
bool is_gap(const glm::vec3& colour, const glm::vec3& tree,
            const std::vector<ColourCluster>& background) {
  const float from_tree = glm::distance(colour, tree);
  const float from_background =
      glm::distance(colour, background[nearest_cluster(background, colour)].lab);
  return from_tree > kGapContrast && from_background < kGapNearness * from_tree;
}

std::vector<std::size_t> without_sloppy(const LabPlanes& lab,
                                        const std::vector<std::size_t>& pixels,
                                        const std::vector<ColourCluster>& foreground,
                                        const std::vector<ColourCluster>& background) {
  const glm::vec3 tree = median_of(colours_of(lab, pixels));
  std::vector<std::size_t> kept;
  for (const std::size_t i : pixels) {
    const glm::vec3 colour = lab_at(lab, i);
    if (is_gap(colour, tree, background)) continue;
    if (density(background, colour) < kSloppyRatio * density(foreground, colour)) kept.push_back(i);
  }
  const bool overlap = float(kept.size()) < (1.0f - kMostDropped) * float(pixels.size());
  return overlap ? pixels : kept;
}

Image<std::uint8_t> empty_grid(int width, int height) {
  const double scale = std::min(1.0, double(kGridSize) / std::max(width, height));
  return {std::max(1, int(std::lround(width * scale))),
          std::max(1, int(std::lround(height * scale)))};
}

std::vector<StrokeCluster> locate(const std::vector<ColourCluster>& clusters, const LabPlanes& lab,
                                  const std::vector<std::size_t>& pixels) {
  const int width = lab.l.width(), height = lab.l.height();
  std::vector<Image<std::uint8_t>> marked(clusters.size(), empty_grid(width, height));
  for (const std::size_t i : pixels) {
    Image<std::uint8_t>& grid = marked[nearest_cluster(clusters, lab_at(lab, i))];
    const int x = int(i % std::size_t(width)), y = int(i / std::size_t(width));
    grid(x * grid.width() / width, y * grid.height() / height) = 1;
  }
  std::vector<StrokeCluster> located(clusters.size());
  tbb::parallel_for(std::size_t(0), clusters.size(), [&](std::size_t c) {
    located[c] = {clusters[c], squared_distance_to(marked[c])};
    Image<float>& squared = located[c].squared_distance;
    const float diagonal = std::hypot(float(squared.width()), float(squared.height()));
    for (float& value : squared.pixels()) value /= diagonal * diagonal;
  });
  return located;
}

}  // namespace

LabPlanes lab_planes(const Image<glm::vec3>& srgb, const glm::vec3& gain, int step,
                     Progress& progress) {
  const int width = (srgb.width() + step - 1) / step, height = (srgb.height() + step - 1) / step;
  LabPlanes planes{{width, height}, {width, height}, {width, height}};
  tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec3 lab = lab_from_linear(linear_from_srgb(srgb(x * step, y * step)) * gain);
      planes.l(x, y) = lab.x;
      planes.a(x, y) = lab.y;
      planes.b(x, y) = lab.z;
    }
    progress.advance();
  });
  return planes;
}

std::vector<StrokeCluster> learn_clusters(const LabPlanes& lab, const Image<std::uint8_t>& strokes,
                                          std::uint8_t kind, int clusters) {
  const auto pixels = pixels_under(strokes, kind);
  return locate(cluster_colours(colours_of(lab, pixels), clusters, kLeastVariance).clusters, lab,
                pixels);
}

StrokeModel learn_strokes(const LabPlanes& lab, const Image<std::uint8_t>& strokes, int clusters) {
  const auto clusters_of = [&](const std::vector<std::size_t>& pixels) {
    return cluster_colours(colours_of(lab, pixels), clusters, kLeastVariance).clusters;
  };
  const auto under_background = pixels_under(strokes, kBackgroundStroke);
  const auto background = clusters_of(under_background);
  const auto all = pixels_under(strokes, kForegroundStroke);
  const auto under_foreground = without_sloppy(lab, all, clusters_of(all), background);
  return {locate(clusters_of(under_foreground), lab, under_foreground),
          locate(background, lab, under_background)};
}

}  // namespace bosk
