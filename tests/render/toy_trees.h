#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "core/package/tree_model.h"
#include "core/photo/camera.h"
#include "core/render/billboard_geometry.h"

namespace bosk::toy {

inline std::uint64_t morton(glm::uvec3 cell) {
  std::uint64_t code = 0;
  for (int bit = 0; bit < 21; ++bit)
    for (int axis = 0; axis < 3; ++axis)
      code |= std::uint64_t((cell[axis] >> bit) & 1) << (3 * bit + axis);
  return code;
}

// An atlas of 16 x 16 tiles. Tile t is plain: colour palette[t], alpha alphas[t].
inline CodeAtlas plain_atlas(const std::vector<glm::u8vec4>& palette) {
  CodeAtlas atlas;
  atlas.width_px = atlas.height_px = 64;
  atlas.rgba.resize(std::size_t(64) * 64, glm::u8vec4(0));
  for (std::size_t tile = 0; tile < palette.size(); ++tile)
    for (std::size_t y = 0; y < 4; ++y)
      for (std::size_t x = 0; x < 4; ++x)
        atlas.rgba[(4 * (tile / 16) + y) * 64 + 4 * (tile % 16) + x] = palette[tile];
  return atlas;
}

inline CodeAtlas noise_atlas(unsigned seed) {
  CodeAtlas atlas = plain_atlas({});
  std::mt19937 random(seed);
  for (glm::u8vec4& texel : atlas.rgba)
    for (int channel = 0; channel < 4; ++channel) texel[channel] = std::uint8_t(random() % 256);
  return atlas;
}

// A level whose every block shows codeword `code(cell, view, block)`.
template <class Code>
TreeLevel make_level(int level, int texels, float side_factor, std::vector<std::uint64_t> cells,
                     std::uint32_t views, const Code& code) {
  TreeLevel result;
  result.level = level;
  result.texels = texels;
  result.side_factor = side_factor;
  result.cells = std::move(cells);
  for (std::uint32_t view = 0; view < views; ++view) result.views.push_back(view);
  const int blocks = (texels / 4) * (texels / 4);
  for (std::size_t cell = 0; cell < result.cells.size(); ++cell)
    for (std::uint32_t view = 0; view < views; ++view)
      for (int block = 0; block < blocks; ++block) {
        const std::uint16_t index = code(cell, view, block);
        result.alpha_indices.push_back(index);
        result.colour_indices.push_back(index == kPruned ? std::uint16_t(0) : index);
      }
  result.alpha_codes = result.colour_codes = {0, 256};
  return result;
}

// Views in a ring around the middle of the cube.
inline std::vector<glm::dvec3> ring(int count, double radius, double height) {
  std::vector<glm::dvec3> positions;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
  }
  return positions;
}

// Cube from -1 to 1 in x and y, 0 to 2 in z; one opaque white billboard of the root's size, one
// view.
inline TreeModel one_billboard(int texels = 4) {
  TreeModel model;
  model.origin = {-1.0, -1.0, 0.0};
  model.size_m = 2.0;
  model.view_positions = {{0.0, -10.0, 1.0}};
  model.atlas = plain_atlas({glm::u8vec4(255)});
  model.levels = {make_level(0, texels, 1.0f, {0}, 1, [](auto...) { return std::uint16_t(0); })};
  return model;
}

// Three levels, `finest` and the two above, of random cells in a ball, one in `rarity`; every
// parent of a cell is there.
inline TreeModel random_ball_of(unsigned seed, int texels, int views, int finest, unsigned rarity) {
  TreeModel model;
  model.origin = {-1.0, -1.0, 0.0};
  model.size_m = 2.0;
  model.view_positions = ring(views, 6.0, 1.5);
  model.atlas = noise_atlas(seed);
  std::mt19937 random(seed);
  std::vector<std::uint64_t> cells;
  for (std::uint64_t code = 0; code < std::uint64_t(1) << (3 * finest); ++code) {
    const glm::dvec3 at =
        std::ldexp(1.0, 1 - finest) * (glm::dvec3(cell_from_morton(code)) + 0.5) - 1.0;
    if (glm::length(at) < 0.9 && random() % rarity == 0) cells.push_back(code);
  }
  for (int level = finest; level > finest - 3; --level) {
    auto code = [&](auto...) { return std::uint16_t(random() % 256); };
    model.levels.insert(model.levels.begin(),
                        make_level(level, texels, 1.3f, cells, std::uint32_t(views), code));
    for (std::uint64_t& cell : cells) cell >>= 3;
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  }
  return model;
}

// Levels 3, 4 and 5, thousands of finest cells.
inline TreeModel random_ball(unsigned seed, int texels = 4, int views = 8) {
  return random_ball_of(seed, texels, views, 5, 4);
}

// Levels 3, 4 and 5, about 100 finest cells.
inline TreeModel sparse_ball(unsigned seed) { return random_ball_of(seed, 4, 8, 5, 128); }

// Levels 5, 6 and 7, about 3,000 finest cells: levels are chosen for an eighth of its width at
// once.
inline TreeModel fine_ball(unsigned seed) { return random_ball_of(seed, 4, 8, 7, 256); }

// A pinhole at `eye` that looks at `target`, upright unless rolled about its axis.
inline Camera look_at(const glm::dvec3& eye, const glm::dvec3& target, double focal_px, int width,
                      int height, double roll = 0.0) {
  Camera camera;
  camera.name = "toy";
  camera.lens.width_px = width;
  camera.lens.height_px = height;
  camera.lens.focal_px = glm::dvec2(focal_px);
  camera.lens.principal_px = {0.5 * width - 0.5, 0.5 * height - 0.5};
  const glm::dvec3 z = glm::normalize(target - eye);
  const glm::dvec3 level_x = glm::normalize(glm::cross(z, glm::dvec3(0, 0, 1)));
  const glm::dvec3 level_y = glm::cross(z, level_x);
  const glm::dvec3 x = std::cos(roll) * level_x + std::sin(roll) * level_y;
  camera.camera_from_world.rotation = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
  camera.camera_from_world.translation = -(camera.camera_from_world.rotation * eye);
  return camera;
}

}  // namespace bosk::toy
