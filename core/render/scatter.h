#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/options.h"
#include "core/image/image.h"
#include "core/render/forest.h"
#include "core/render/terrain.h"

namespace bosk {

// Where the trees of a forest stand.
struct ScatterOptions {
  int trees = 0;         // 0: one of each package, side by side
  double area_m = 0.0;   // west to east; 0: as small as the trees need
  double spacing = 1.0;  // least distance between trunks, in sums of the two crowns' radii
  double smallest_scale = 0.8, largest_scale = 1.2;
  double tint_spread = 0.06;  // trees are brighter or darker, redder or bluer by this share at most
  double terrain_m = 0.0;     // relief of the ground; 0: flat
  double hill_m = 80.0;       // from hill to hill
  int seed = 1;
};
Options describe(ScatterOptions& options);

Terrain terrain_of(const ScatterOptions& options);

// Radius of the upright cylinder around the tree's own z axis that holds 95 in 100 of its finest
// cells; 0 for a tree without cells.
double crown_radius(const TreeModel& tree);

// Blue noise: `options.trees` trunks, no two nearer than `spacing` times the sum of their crowns'
// radii, in a rectangle around (0, 0). Kinds, turns, scales and tints are drawn at random, with the
// same chance each; `crown_radii` has one entry a kind. In a given area the trees spread all over
// it.
//
// `density` (0 to 1; empty: 1 all over) thins them: north is its top row, its width is the area's,
// and the share of trunks that stay is its value there. Grey of 0 stays clear.
//
// All on z = 0. Throws Error when the area is too small, or the map too dark, for so many trees.
// Poisson-disk sampling after Bridson 2007; differs: discs have sizes of their own, and an area
// that trees do not fill is filled with larger discs, so that its trees stay evenly spread.
std::vector<TreeInstance> scatter_trees(std::span<const double> crown_radii,
                                        const Image<float>& density, const ScatterOptions& options);

// One of each kind, unturned and unscaled, in a row from west to east around (0, 0).
std::vector<TreeInstance> line_up(std::span<const double> crown_radii);

// Puts every trunk on the ground.
void stand_on(const Terrain& terrain, std::span<TreeInstance> instances);

}  // namespace bosk
