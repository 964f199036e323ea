#include "core/matte/hull.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/matte/grid.h"

namespace bosk {
namespace {

constexpr int kVoxels = AgreedVolume::kSide;
constexpr int kGridSize = 64;       // cells along the longer side of a photo
constexpr std::size_t kFewest = 4;  // photos
constexpr double kForgiven = 0.1;   // share of the photos that may miss the tree at a place
constexpr float kThinTree = 0.1f;   // mean alpha that thin outer twigs still reach
constexpr double kLeastSpread =
    0.05;  // smallest eigenvalue of how the view axes spread; about 18 degrees

glm::dvec3 axis_in_world(const Camera& camera) {
  return glm::transpose(camera.camera_from_world.rotation) * glm::dvec3(0.0, 0.0, 1.0);
}

// Out to where the photos end.
std::optional<AgreedVolume> cube_seen_by_all(const Photos& photos) {
  const auto centre = place_seen_by_all(photos);
  if (!centre) return std::nullopt;
  AgreedVolume cube{*centre, 0.0, {}};
  for (const Photo& photo : photos) {
    const Lens& lens = photo.camera.lens;
    const double distance = glm::distance(photo.camera.centre_in_world(), cube.centre_in_world);
    const double slope =
        0.5 * std::max(lens.width_px / lens.focal_px.x, lens.height_px / lens.focal_px.y);
    cube.half_edge_m += distance * std::min(slope, 0.9) / double(photos.size());
  }
  return cube;
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

// The most that any place along each cell's ray reaches. A voxel marks its cell's neighbours too:
// voxels are about as far apart as cells, and the outline of the tree is not known better.
Image<float> most_along_rays(const Photo& photo, const AgreedVolume& volume) {
  const double scale =
      double(kGridSize) / std::max(photo.camera.lens.width_px, photo.camera.lens.height_px);
  const int width = std::max(1, int(photo.camera.lens.width_px * scale));
  const int height = std::max(1, int(photo.camera.lens.height_px * scale));
  Image<float> most(width, height);
  for (int i = 0; i < kVoxels * kVoxels * kVoxels; ++i) {
    const glm::ivec3 place(i % kVoxels, i / kVoxels % kVoxels, i / kVoxels / kVoxels);
    const auto cell = cell_of(photo, volume.cell_centre(place), width, height);
    if (!cell) continue;
    for (int y = std::max(0, cell->y - 1); y <= std::min(height - 1, cell->y + 1); ++y) {
      for (int x = std::max(0, cell->x - 1); x <= std::min(width - 1, cell->x + 1); ++x) {
        most(x, y) = std::max(most(x, y), volume.alpha[std::size_t(i)]);
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

glm::dvec3 AgreedVolume::cell_centre(const glm::ivec3& cell) const {
  return centre_in_world + half_edge_m * ((2.0 * glm::dvec3(cell) + 1.0) / double(kSide) - 1.0);
}

glm::ivec3 AgreedVolume::cell_of(const glm::dvec3& point_in_world) const {
  const glm::dvec3 share = 0.5 + 0.5 * (point_in_world - centre_in_world) / half_edge_m;
  return glm::ivec3(glm::floor(glm::clamp(share, -1.0, 2.0) * double(kSide)));
}

float AgreedVolume::at(const glm::ivec3& cell) const {
  for (int k = 0; k < 3; ++k) {
    if (cell[k] < 0 || cell[k] >= kSide) return 0.0f;
  }
  return alpha[std::size_t((cell.z * kSide + cell.y) * kSide + cell.x)];
}

std::optional<AgreedVolume> agreed_volume(const Photos& photos,
                                          const std::vector<Image<float>>& mean_alpha,
                                          Progress& progress) {
  if (photos.size() < kFewest) return std::nullopt;
  auto volume = cube_seen_by_all(photos);
  if (!volume) return std::nullopt;
  volume->alpha.resize(std::size_t(kVoxels) * kVoxels * kVoxels);
  tbb::parallel_for(0, kVoxels * kVoxels, [&](int row) {
    std::vector<float> seen;
    for (int x = 0; x < kVoxels; ++x) {
      const glm::dvec3 point = volume->cell_centre({x, row % kVoxels, row / kVoxels});
      volume->alpha[std::size_t(row) * kVoxels + std::size_t(x)] =
          agreed_alpha(photos, mean_alpha, point, seen);
    }
    progress.check();
  });
  return volume;
}

std::vector<Image<float>> hull_tilts(const Photos& photos, const AgreedVolume& volume, float weight,
                                     Progress& progress) {
  std::vector<Image<float>> tilts(photos.size());
  tbb::parallel_for(std::size_t(0), photos.size(), [&](std::size_t i) {
    progress.check();
    tilts[i] = most_along_rays(photos[i], volume);
    for (float& value : tilts[i].pixels()) {
      const float doubt = std::log(std::max(value, 1e-6f) / kThinTree);
      value = weight * std::clamp(doubt, kMostDoubt, 0.0f);
    }
  });
  return tilts;
}

}  // namespace bosk
