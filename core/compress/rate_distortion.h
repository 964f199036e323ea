#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/compress/blocks.h"
#include "core/compress/compress.h"

namespace bosk {

// What one level costs and how well it is kept.
struct LevelRateDistortion {
  int level = 0;
  std::size_t blocks = 0, pruned = 0;
  // Over the texels of blocks that aren't pruned. Colour counts by alpha. Infinite when exact.
  double colour_psnr_db = 0;  // of encoded sRGB
  double colour_delta_e = 0;  // CIE76, mean
  double alpha_psnr_db = 0;
  // The same of each block's mean: what is left to see when a block is a pixel.
  double block_colour_psnr_db = 0, block_alpha_psnr_db = 0;
  // Mean of the decoded minus the true: a bias adds up where billboards overlap.
  double alpha_bias = 0;      // of alpha, 0 to 1
  double lightness_bias = 0;  // of L*
  // Entropy of one index without regard to its neighbours; pruned counts as an alpha index.
  double colour_entropy_bits = 0, alpha_entropy_bits = 0;
  std::size_t raw_bytes = 0;       // the texture, 4 bytes a texel
  std::size_t index_bytes = 0;     // at the entropies above
  std::size_t codeword_bytes = 0;  // as BC3: half a tile for a colour, half for an alpha
};

// `textures` must be made from `billboards`. With `from_bc3` the distortion is that of the BC3
// atlas.
std::vector<LevelRateDistortion> rate_distortion(const Billboards& billboards,
                                                 const CodedTextures& textures, bool from_bc3,
                                                 Progress& progress);

// One figure for all levels: their mean squared errors, each weighted by the level's blocks that
// aren't pruned. Infinite when exact.
struct OverallPsnr {
  double colour_db = 0.0, alpha_db = 0.0;
};
OverallPsnr overall_psnr(std::span<const LevelRateDistortion> levels);

// Texels of one block of a level as a renderer sees them; all zero where pruned. `atlas` is
// atlas_rgba or what became of it.
BlockTexels decoded_block(const CodedTextures& textures, const std::vector<glm::u8vec4>& atlas,
                          std::size_t level, std::size_t block);

}  // namespace bosk
