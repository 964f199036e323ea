#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/binary.h"
#include "core/base/options.h"
#include "core/base/progress.h"
#include "core/photo/camera.h"
#include "core/radiance/radiance.h"

namespace bosk {

struct BillboardOptions {
  int coarsest_level = 0;  // octree level of the coarsest billboards
  int views = 12;          // directions that coarse levels have textures for
  int texels = 4;          // M: texels along the edge of a coarse billboard, 4 or 8
  int kernel_levels = 2;   // finest levels drawn as one soft kernel a cell, the same from all sides
  double prune = 0.01;     // a billboard is dropped when less than this share of light shows it
};
Options describe(BillboardOptions& options);

// View-dependent textures of one octree level.
struct BillboardLevel {
  int level = 0;
  int texels = 4;                    // M, texels along an edge: 4 or 8
  float side_factor = 1;             // billboard side / cell side
  float max_cell_px = 0;             // see TreeLevel in package/tree_model.h
  std::vector<std::uint32_t> views;  // into Billboards::view_positions
  std::vector<std::uint64_t> cells;  // Morton codes (x lowest bit), ascending
  // [cell][view][row][column], straight sRGB-encoded colour and alpha; alpha 0 everywhere where
  // pruned.
  std::vector<glm::u8vec4> texture;

  std::size_t texture_size() const { return std::size_t(texels) * std::size_t(texels); }
};

// Billboard geometry (axes, side) is that of package/tree_model.h.
struct Billboards {
  glm::dvec3 origin{0.0};
  double size_m = 1.0;
  std::vector<glm::dvec3> view_positions;
  std::vector<BillboardLevel> levels;  // coarse to fine
};

// Bakes textures of every level from the volume, towards viewpoints spread over the hemisphere.
// Throws Error when the volume is empty.
Billboards bake_billboards(const RadianceVolume& volume, const std::vector<Camera>& cameras,
                           const BillboardOptions& options, Progress& progress);

void write(BinaryWriter& writer, const Billboards& billboards);
Billboards read_billboards(BinaryReader& reader);

}  // namespace bosk
