#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace bosk {

// What a game holds of a captured tree: billboards at every level of an octree, their textures as
// indices into codebooks. Plain data; standard library and GLM alone.
//
// Octree: the cube `origin` .. `origin + size_m`; level L has 2^L cells a side. A cell's centre is
// origin + (xyz + 0.5) * size_m / 2^L. Billboard of a cell towards a viewpoint: a square of side
// `side_factor` * cell size around the cell's centre, perpendicular to the line from viewpoint to
// centre; its texture's x axis is `right`, its y axis (rows downwards) is -`up`:
//   forward = normalize(centre - viewpoint), right = normalize(cross(forward, +z)),
//   up = cross(right, forward)        (where forward is within 1e-6 of +-z, right = +x).
struct CodeRange {
  std::uint32_t first = 0;  // tile of the atlas, counted row by row, 4x4 texels a tile
  std::uint32_t count = 0;
};

struct TreeLevel {
  int level = 0;          // 0 is the root
  int texels = 4;         // M: texels along a billboard's edge, 4 or 8
  float side_factor = 1;  // billboard side / cell side
  // Largest angle of a texel at which this level still looks like the finest one, measured when
  // packed: the level serves cells whose size on screen is at most this many pixels. 0: never
  // chosen.
  float max_cell_px = 0;
  std::vector<std::uint32_t>
      views;  // into TreeModel::view_positions: the directions textures exist for
  std::vector<std::uint64_t> cells;  // Morton codes (x lowest bit), ascending
  // [cell][view][block row][block column]; (texels/4)^2 blocks. An alpha index of kPruned draws
  // nothing and its colour index is 0. Colour and alpha indices count from the ranges below.
  std::vector<std::uint16_t> alpha_indices, colour_indices;
  CodeRange alpha_codes, colour_codes;
};
inline constexpr std::uint16_t kPruned = 0xffff;

// Codewords, side by side. Tile t is texels [4 (t % tiles_across), 4 (t / tiles_across)] ...; the
// tile's rgb is colour codeword t (sRGB-encoded, straight), its a is alpha codeword t. `rgba` is
// exact; `bc3` is the same compressed for GPUs, one 16-byte block a tile, in the same order.
struct CodeAtlas {
  int width_px = 0, height_px = 0;  // multiples of 4, at most 512
  std::vector<glm::u8vec4> rgba;    // row-major
  std::vector<std::uint8_t> bc3;
};

struct TreeMetadata {
  std::string name, licence, credit, generator;
  std::string units = "m";
  double height_m = 0;  // of the highest cell above the origin of the world
  std::uint32_t photo_count = 0;
};

struct TreeModel {
  glm::dvec3 origin{0.0};  // lower corner of the octree's cube, world frame (+z up)
  double size_m = 1.0;
  std::vector<glm::dvec3> view_positions;  // where textures were baked towards, world frame
  std::vector<TreeLevel> levels;           // coarse to fine
  CodeAtlas atlas;
  TreeMetadata metadata;
};

}  // namespace bosk
