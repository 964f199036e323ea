#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/binary.h"
#include "core/base/options.h"
#include "core/base/progress.h"
#include "core/matte/matte.h"
#include "core/opacity/sparse_grid.h"
#include "core/photo/photo.h"

namespace bosk {

struct OpacityOptions {
  int finest_level = 0;  // 4 to 9; 0: chosen by cell_px
  double cell_px = 3.6;  // size of the finest cells in the photos, the median photo at the crown
  double max_cells = 0;  // thousand in the hull, about: cells grow past cell_px to keep it; 0: any
  int passes = 1;        // of the solver over all rays at the finest level
  int subsets = 8;       // interleaved pixels per pass
  int stop_after = 0;    // iterations, counted over all levels; 0: never
};
Options describe(OpacityOptions& options);

// Where the tree is and how opaque: the cube around the crown, its cells at the finest level that
// may hold something, and each cell's extinction.
struct OpacityTree {
  glm::dvec3 origin{0.0};  // lower corner of the cube, world
  double size_m = 1.0;     // edge of the cube
  SparseGrid grid;         // cells at the finest level
  // Extinction at the centre of each cell, per cell edge: light that crosses one edge's length of
  // medium with value t keeps exp(-t). Between centres it is trilinear, and zero in absent cells.
  std::vector<float> extinction;

  int level() const { return grid.level(); }
  double cell_m() const { return size_m / grid.side(); }
};

// The state after an iteration, for whoever watches. Valid during the call only.
struct OpacityPreview {
  const OpacityTree& tree;
  int iteration = 0;        // from 1, over all levels
  int planned = 0;          // iterations in all; fewer where a pass gains nothing
  double mean_error = 0.0;  // mean |alpha - matte| over the rays of the last pass
  const Photos& photos;     // that it is made from
  const Mattes& mattes;
};
// Returns whether to go on. On false the tree is what estimate_opacity gives with `stop_after` at
// this iteration: that of the level reached, which may be coarser than the finest.
using OpacityWatcher = std::function<bool(const OpacityPreview&)>;

// Finds the crown's box from the mattes, carves it by all mattes, and solves for extinction by
// multiplicative least-squares EM, coarse to fine. Throws Error when fewer than 2 photos have a
// matte, a matte is empty everywhere, or the photos' views have no volume in common (names the
// photos).
OpacityTree estimate_opacity(const Photos& photos, const Mattes& mattes,
                             const OpacityOptions& options, Progress& progress,
                             const OpacityWatcher& watcher = {});

void write(BinaryWriter& writer, const OpacityTree& tree);
OpacityTree read_opacity_tree(BinaryReader& reader);

}  // namespace bosk
