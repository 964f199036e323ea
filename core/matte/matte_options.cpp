#include "core/matte/matte.h"

namespace bosk {

Options describe(MatteOptions& options) {
  return {
      {"clusters", "", "colours learnt per kind of stroke", &options.clusters, 1, 32, {}},
      {"mixing",
       "",
       "where leaf and background mix: curve is linear light seen in CIELab",
       &options.mixing,
       0,
       0,
       {"curve", "lab", "srgb", "linear"}},
      {"position_sigma",
       "diagonals",
       "how far a stroke speaks for its surroundings",
       &options.position_sigma,
       0.005,
       10.0,
       {}},
      {"transfer_sigma",
       "diagonals",
       "the same, in photos without strokes of their own",
       &options.transfer_sigma,
       0.005,
       10.0,
       {}},
      {"clear_below", "", "alpha that counts as background", &options.clear_below, 0.0, 0.4, {}},
      {"opaque_above", "", "alpha that counts as tree", &options.opaque_above, 0.6, 1.0, {}},
  };
}

}  // namespace bosk
