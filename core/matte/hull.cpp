#include "core/matte/hull.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/matte/grid.h"

namespace bosk {
namespace {

constexpr int kVoxels = 64;           // along each edge of the cube
constexpr int kGridSize = 64;         // cells along the longer side of a photo
constexpr std::size_t kFewest = 4;    // photos
constexpr double kForgiven = 0.1;     // share of the photos that may miss the tree at a place
constexpr float kThinTree = 0.1f;     // mean alpha that thin outer twigs still reach
constexpr float kLeastMean = 0.004f;  // bounds the doubt: log(kLeastMean / kThinTree) = -3.2
constexpr double kLeastSpread =
    0.05;  // smallest eigenvalue of how the view axes spread; about 18 degrees

struct Cube {
  glm::dvec3 centre{0.0};
  double half_edge = 0.0;  // metres
};

glm::dvec3 axis_in_world(const Camera& camera) {
  return glm::transpose(camera.camera_from_world.rotation) * glm::dvec3(0.0, 0.0, 1.0);
}

// Out to where the photos end.
std::optional<Cube> cube_seen_by_all(const Photos& photos) {
  const auto centre = place_seen_by_all(photos);
  if (!centre) return std::nullopt;
  Cube cube{*centre, 0.0};
  for (const Photo& photo : photos) {
    const Lens& lens = photo.camera.lens;
    const double distance = glm::distance(photo.camera.centre_in_world(), cube.centre);
    const double slope =
        0.5 * std::max(lens.width_px / lens.focal_px.x, lens.height_px / lens.focal_px.y);
    cube.half_edge += distance * std::min(slope, 0.9) / double(photos.size());
  }
  return cube;
}

glm::dvec3 voxel_centre(const Cube& cube, int x, int y, int z) {
  return cube.centre + cube.half_edge * ((2.0 * glm::dvec3(x, y, z) + 1.0) / double(kVoxels) - 1.0);
}

struct GridPixel {
  int x = 0, y = 0;
};

// The grid cell that shows the point; none outside the photo or behind the camera.
std::optional<GridPixel> cell_of(const Photo& photo, const glm::dvec3& point, int width,
                                 int height) {
  const glm::dvec3 seen = photo.camera.camera_from_world * point;
  if (seen.z <= 0.0) return std::nullopt;
  const Lens& lens = photo.camera.lens;
  const glm::dvec2 pixel = lens.focal_px * glm::dvec2(seen) / seen.z + lens.principal_px;
  const double u = (pixel.x + 0.5) / lens.width_px * width,
               v = (pixel.y + 0.5) / lens.height_px * height;
  if (u < 0.0 || v < 0.0 || u >= width || v >= height) return std::nullopt;
  return GridPixel{int(u), int(v)};
}

// What nearly all photos that show a place agree on at least; 0 where fewer than half show it.
float agreed_alpha(const Photos& photos, const std::vector<Image<float>>& mean_alpha,
                   const glm::dvec3& point, std::vector<float>& seen) {
  seen.clear();
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const auto cell = cell_of(photos[i], point, mean_alpha[i].width(), mean_alpha[i].height());
    if (cell) seen.push_back(mean_alpha[i](cell->x, cell->y));
  }
  if (2 * seen.size() < photos.size()) return 0.0f;
  const auto rank = seen.begin() + std::ptrdiff_t(kForgiven * double(seen.size()));
  std::nth_element(seen.begin(), rank, seen.end());
  return *rank;
}

std::vector<float> voxels_of(const Photos& photos, const std::vector<Image<float>>& mean_alpha,
                             const Cube& cube, Progress& progress) {
  std::vector<float> voxels(std::size_t(kVoxels) * kVoxels * kVoxels);
  tbb::parallel_for(0, kVoxels * kVoxels, [&](int row) {
    std::vector<float> seen;
    for (int x = 0; x < kVoxels; ++x) {
      const glm::dvec3 point = voxel_centre(cube, x, row % kVoxels, row / kVoxels);
      voxels[std::size_t(row) * kVoxels + std::size_t(x)] =
          agreed_alpha(photos, mean_alpha, point, seen);
    }
    progress.check();
  });
  return voxels;
}

// The most that any place along each cell's ray reaches. A voxel marks its cell's neighbours too:
// voxels are about as far apart as cells, and the outline of the tree is not known better.
Image<float> most_along_rays(const Photo& photo, const std::vector<float>& voxels,
                             const Cube& cube) {
  const double scale =
      double(kGridSize) / std::max(photo.camera.lens.width_px, photo.camera.lens.height_px);
  const int width = std::max(1, int(photo.camera.lens.width_px * scale));
  const int height = std::max(1, int(photo.camera.lens.height_px * scale));
  Image<float> most(width, height);
  for (int i = 0; i < kVoxels * kVoxels * kVoxels; ++i) {
    const glm::dvec3 point =
        voxel_centre(cube, i % kVoxels, i / kVoxels % kVoxels, i / kVoxels / kVoxels);
    const auto cell = cell_of(photo, point, width, height);
    if (!cell) continue;
    for (int y = std::max(0, cell->y - 1); y <= std::min(height - 1, cell->y + 1); ++y) {
      for (int x = std::max(0, cell->x - 1); x <= std::min(width - 1, cell->x + 1); ++x) {
        most(x, y) = std::max(most(x, y), voxels[std::size_t(i)]);
      }
    }
  }
  return most;
}

}  // namespace

std::optional<glm::dvec3> place_seen_by_all(const Photos& photos) {
  glm::dmat3 normal(0.0);
  glm::dvec3 right(0.0);
  for (const Photo& photo : photos) {
    const glm::dvec3 axis = axis_in_world(photo.camera);
    const glm::dmat3 across = glm::dmat3(1.0) - glm::outerProduct(axis, axis);
    normal += across;
    right += across * photo.camera.centre_in_world();
  }
  // The two large eigenvalues of normal / count are at most 1, so the smallest is at least this
  if (!(glm::determinant(normal / double(photos.size())) > kLeastSpread)) return std::nullopt;
  return glm::inverse(normal) * right;
}

std::vector<Image<float>> hull_tilts(const Photos& photos,
                                     const std::vector<Image<float>>& mean_alpha, float weight,
                                     Progress& progress) {
  if (photos.size() < kFewest || weight <= 0.0f) return {};
  const auto cube = cube_seen_by_all(photos);
  if (!cube) return {};
  const std::vector<float> voxels = voxels_of(photos, mean_alpha, *cube, progress);
  std::vector<Image<float>> tilts(photos.size());
  tbb::parallel_for(std::size_t(0), photos.size(), [&](std::size_t i) {
    progress.check();
    tilts[i] = most_along_rays(photos[i], voxels, *cube);
    for (float& value : tilts[i].pixels()) {
      value = weight * std::min(0.0f, std::log(std::max(value, kLeastMean) / kThinTree));
    }
  });
  return tilts;
}

}  // namespace bosk
