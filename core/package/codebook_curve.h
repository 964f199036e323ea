#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/billboard/billboard.h"
#include "core/compress/compress.h"

namespace bosk {

// What a number of codewords costs and keeps: colours and alphas apart, since their numbers may
// differ.
struct CodebookPoint {
  int codewords = 0;            // of each of the two codebooks of a level
  double colour_psnr_db = 0.0;  // over all levels: see overall_psnr
  double alpha_psnr_db = 0.0;
  std::size_t colour_bytes = 0, alpha_bytes = 0;  // of the package, about: indices and codewords
  std::size_t other_bytes = 0;                    // cells and whatever else there is

  std::size_t package_bytes() const { return colour_bytes + alpha_bytes + other_bytes; }
};
using OnCodebookPoint = std::function<void(const CodebookPoint&)>;

// 16, 32, ... 4096.
std::vector<int> usual_codeword_counts();

// The curve between its points, straight over the logarithm of `codewords`; its ends beyond them.
// Needs a point or more, in ascending order.
CodebookPoint at_codewords(std::span<const CodebookPoint> curve, int codewords);

// Rate against distortion for each of `codewords`, in that order, each told as soon as it is known;
// numbers whose codewords don't fit into the atlas are left out. Codes and packs a sample of the
// tree (whole subtrees from all over it) with both codebooks of that size, by all other options,
// and scales the sample's indices up to the tree. The README says how near that comes. Throws Error
// where the billboards are damaged.
std::vector<CodebookPoint> codebook_curve(const Billboards& billboards,
                                          const CompressOptions& options,
                                          std::span<const int> codewords, Progress& progress,
                                          const OnCodebookPoint& on_point = {});

}  // namespace bosk
