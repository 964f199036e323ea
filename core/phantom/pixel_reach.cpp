#include "core/phantom/pixel_reach.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bosk {
namespace {

// A ray may start a pixel off its pixel's centre, and lenses bend edges a little.
constexpr float kMargin = 1.75f;

void mark(Image<std::uint8_t>& reach, glm::vec2 lower, glm::vec2 upper, std::uint8_t bit) {
  const glm::vec2 last(reach.width() - 1, reach.height() - 1);
  lower = glm::ceil(glm::max(lower - kMargin, 0.0f));
  upper = glm::floor(glm::min(upper + kMargin, last));
  for (int y = int(lower.y); y <= int(upper.y); ++y) {
    for (int x = int(lower.x); x <= int(upper.x); ++x) reach(x, y) |= bit;
  }
}

void mark_everywhere(Image<std::uint8_t>& reach, std::uint8_t bit) {
  for (std::uint8_t& pixel : reach.pixels()) pixel |= bit;
}

std::vector<glm::vec2> projected(const Camera& camera, const std::vector<glm::vec3>& points) {
  std::vector<glm::vec2> pixels(points.size());
  constexpr std::size_t kBlock = 4096;
  tbb::parallel_for(std::size_t(0), (points.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
    const std::size_t last = std::min(points.size(), (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < last; ++i) {
      const auto pixel = project(camera, glm::dvec3(points[i]));
      pixels[i] = pixel ? glm::vec2(*pixel) : glm::vec2(std::numeric_limits<float>::quiet_NaN());
    }
  });
  return pixels;
}

// The box of points on a thing's hull; a thing that is partly out of the lens's reach may be
// anywhere.
void mark_hull(const Camera& camera, const std::vector<glm::vec3>& hull,
               Image<std::uint8_t>& reach) {
  glm::vec2 lower(1e30f), upper(-1e30f);
  for (const glm::vec2& pixel : projected(camera, hull)) {
    if (std::isnan(pixel.x)) return mark_everywhere(reach, kSolidNear);
    lower = glm::min(lower, pixel);
    upper = glm::max(upper, pixel);
  }
  mark(reach, lower, upper, kSolidNear);
}

std::vector<glm::vec3> box_corners(const glm::vec3& lower, const glm::vec3& upper) {
  std::vector<glm::vec3> corners;
  corners.reserve(8);
  for (int k = 0; k < 8; ++k) {
    corners.emplace_back((k & 1) != 0 ? upper.x : lower.x, (k & 2) != 0 ? upper.y : lower.y,
                         (k & 4) != 0 ? upper.z : lower.z);
  }
  return corners;
}

std::vector<glm::vec3> board_corners(const Board& board) {
  std::vector<glm::vec3> corners;
  for (const double x : {-2.0, board.columns * 0.5, board.columns + 0.0}) {
    for (const double y : {-2.0, board.rows * 0.5, board.rows + 0.0}) {
      corners.emplace_back(board.world_from_board * (board.square * glm::dvec3(x, y, 0.0)));
    }
  }
  return corners;
}

}  // namespace

Image<std::uint8_t> pixel_reach(const Camera& camera, const std::vector<glm::vec3>& vertices,
                                const std::vector<glm::uvec3>& triangles, const World& world) {
  Image<std::uint8_t> reach(camera.lens.width_px, camera.lens.height_px);
  const std::vector<glm::vec2> pixels = projected(camera, vertices);
  for (const glm::uvec3& t : triangles) {
    const glm::vec2 a = pixels[t.x], b = pixels[t.y], c = pixels[t.z];
    if (std::isnan(a.x + b.x + c.x)) {
      mark_everywhere(reach, kTreeNear);
      break;
    }
    mark(reach, glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), kTreeNear);
  }
  for (const Marker& marker : world.markers) {
    const glm::vec3 centre(marker.centre), reach_out(float(marker.radius));
    mark_hull(camera, box_corners(centre - reach_out, centre + reach_out), reach);
    const glm::vec3 foot(centre.x, centre.y, 0.0f);
    mark_hull(camera, box_corners(foot - 0.02f, centre + 0.02f), reach);
  }
  for (const Board& board : world.boards) mark_hull(camera, board_corners(board), reach);
  return reach;
}

}  // namespace bosk
