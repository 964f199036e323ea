#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/billboard/billboard.h"
#include "core/compress/compress.h"

namespace bosk {

// What a number of codewords costs and keeps.
struct CodebookPoint {
  int codewords = 0;            // of each of the two codebooks of a level
  double colour_psnr_db = 0.0;  // as LevelRateDistortion's, over all levels
  double alpha_psnr_db = 0.0;
  std::size_t package_bytes = 0;  // about
};
using OnCodebookPoint = std::function<void(const CodebookPoint&)>;

// 16, 32, ... 4096.
std::vector<int> usual_codeword_counts();

// Rate against distortion for each of `codewords`, in that order, each told as soon as it is known.
// Codes and packs a sample of the tree (whole subtrees from all over it) with both codebooks of
// that size, by all other options, and scales the sample's indices up to the tree. The README says
// how near that comes. Throws Error as compress_billboards.
std::vector<CodebookPoint> codebook_curve(const Billboards& billboards,
                                          const CompressOptions& options,
                                          std::span<const int> codewords, Progress& progress,
                                          const OnCodebookPoint& on_point = {});

}  // namespace bosk
