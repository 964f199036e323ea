#include "core/render/gl/crown_shadow.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/render/billboard_geometry.h"

namespace bosk {
namespace {

const TreeLevel* shadow_level(const TreeModel& model, std::size_t most_cells) {
  const TreeLevel* chosen = nullptr;
  for (const TreeLevel& level : model.levels)
    if (!level.cells.empty() && (!chosen || level.cells.size() <= most_cells)) chosen = &level;
  return chosen;
}

// Mean opacity of every tile of the atlas.
std::vector<float> tile_opacities(const CodeAtlas& atlas) {
  const auto width = std::size_t(atlas.width_px), height = std::size_t(atlas.height_px);
  std::vector<float> means(width / 4 * (height / 4), 0.0f);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x)
      means[y / 4 * (width / 4) + x / 4] += float(atlas.rgba[y * width + x].a) / (16.0f * 255.0f);
  return means;
}

// Of one cell's billboards, over the views that were not pruned.
float cell_opacity(const TreeLevel& level, std::size_t cell, const std::vector<float>& tiles) {
  const std::size_t blocks =
      level.views.size() * std::size_t(level.texels / 4) * std::size_t(level.texels / 4);
  float sum = 0.0f;
  int count = 0;
  for (std::size_t block = cell * blocks; block < (cell + 1) * blocks; ++block) {
    const std::uint16_t code = level.alpha_indices[block];
    if (code == kPruned || level.alpha_codes.first + code >= tiles.size()) continue;
    sum += tiles[level.alpha_codes.first + code];
    ++count;
  }
  return count > 0 ? sum / float(count) : 0.0f;
}

// Share of pixel `at` that an interval of half width `half_px` around `centre_px` covers.
float covered(int at, double centre_px, double half_px) {
  const double low = std::max(double(at) - 0.5, centre_px - half_px);
  const double high = std::min(double(at) + 0.5, centre_px + half_px);
  return float(std::max(0.0, high - low));
}

// The innermost pixels only: the border stays clear, so that a sampler may clamp to it.
void darken(Image<float>& map, const glm::dvec2& centre_px, double half_px, float opacity) {
  const auto first = [&](double centre) { return std::max(1, int(std::floor(centre - half_px))); };
  const auto last = [&](double centre, int size) {
    return std::min(size - 2, int(std::ceil(centre + half_px)));
  };
  for (int y = first(centre_px.y); y <= last(centre_px.y, map.height()); ++y)
    for (int x = first(centre_px.x); x <= last(centre_px.x, map.width()); ++x)
      map(x, y) *=
          1.0f - opacity * covered(x, centre_px.x, half_px) * covered(y, centre_px.y, half_px);
}

struct CellBox {
  glm::dvec3 lower, upper;
};

CellBox box_of(const TreeModel& model, const TreeLevel& level) {
  CellBox box{glm::dvec3(1e300), glm::dvec3(-1e300)};
  for (const std::uint64_t cell : level.cells) {
    const glm::dvec3 centre = cell_centre_in_world(model, level.level, cell);
    box.lower = glm::min(box.lower, centre);
    box.upper = glm::max(box.upper, centre);
  }
  return box;
}

}  // namespace

CrownShadow crown_shadow(const TreeModel& model, const glm::dvec3& to_sun, int side_px,
                         std::size_t most_cells) {
  CrownShadow shadow;
  shadow.transmittance = Image<float>(side_px, side_px, 1.0f);
  const glm::dvec3 aside = std::abs(to_sun.z) < 0.999 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  shadow.across = glm::normalize(glm::cross(aside, to_sun));
  shadow.down = glm::cross(shadow.across, to_sun);
  const TreeLevel* level = shadow_level(model, most_cells);
  if (!level) return shadow;
  const double side_m = cell_size_m(model, level->level) * double(level->side_factor);
  const CellBox box = box_of(model, *level);
  shadow.centre = 0.5 * (box.lower + box.upper);
  shadow.radius_m = (0.5 * glm::length(box.upper - box.lower) + side_m) / (1.0 - 4.0 / side_px);
  const double px_per_m = 0.5 * side_px / shadow.radius_m;
  const std::vector<float> tiles = tile_opacities(model.atlas);
  for (std::size_t cell = 0; cell < level->cells.size(); ++cell) {
    const glm::dvec3 from_centre =
        cell_centre_in_world(model, level->level, level->cells[cell]) - shadow.centre;
    const glm::dvec2 at(glm::dot(from_centre, shadow.across), glm::dot(from_centre, shadow.down));
    darken(shadow.transmittance, at * px_per_m + 0.5 * side_px - 0.5, 0.5 * side_m * px_per_m,
           cell_opacity(*level, cell, tiles));
  }
  return shadow;
}

}  // namespace bosk
