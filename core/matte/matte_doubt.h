#pragma once

#include <string>
#include <vector>

#include "core/matte/matte.h"

namespace bosk {

// How likely a matte is to need strokes of its own: for a list to look through from the top.
struct MatteDoubt {
  std::string photo;
  double doubt = 0.0;  // about the share of the photo that may be wrong; for ordering only
  std::string reason;  // a clause; empty where nothing stands out
};

// One per matte, in their order. Compares each with the others: colours that are background there,
// and, where cameras look at the tree from around, how large the tree is. Fewer than three mattes
// cannot be compared: then doubt is 0 unless a matte is clear or opaque everywhere. `photos` are
// those of the mattes, in the same order.
std::vector<MatteDoubt> doubt_mattes(const Photos& photos, const Mattes& mattes,
                                     Progress& progress);

// Of the doubts; 0 for none.
double median_doubt(const std::vector<MatteDoubt>& doubts);
// Whether this one is to be looked at first, among others of this median.
bool stands_out(const MatteDoubt& doubt, double median);

}  // namespace bosk
