#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/base/binary.h"
#include "core/base/options.h"
#include "core/base/progress.h"
#include "core/billboard/billboard.h"

namespace bosk {

struct CompressOptions {
  int colour_codewords = 1024;  // per level, 1 to 4096
  int alpha_codewords = 512;    // per level, 1 to 4096
  // Where colours are compared: lab, lab_log_chroma (see colour_space.h) or srgb.
  std::string colour_space = "lab_log_chroma";
  // What stands for similar colour blocks: centroid, or closest_block as in the paper.
  std::string codeword_rule = "centroid";
  // How much the error of a block's mean colour or opacity counts, next to that of its 16 texels
  // together: from afar a billboard is a pixel or two, and what the mean is off by is all that
  // shows.
  double block_mean_weight = 4.0;
  int training_blocks = 131072;  // codewords are found on at most so many blocks of a level
};
Options describe(CompressOptions& options);

inline constexpr std::uint16_t kPrunedIndex = 0xffff;

// Textures of one billboard level as indices, in the order [cell][view][block row][block column].
// A block of the texture whose alpha is 0 everywhere has alpha index kPrunedIndex and colour index
// 0. Codewords are numbered so that near numbers look alike: indices of neighbours then pack well.
struct CodedLevel {
  std::vector<std::uint16_t> alpha_indices, colour_indices;
  std::uint32_t first_alpha_tile = 0, alpha_codewords = 0;  // into the atlas
  std::uint32_t first_colour_tile = 0, colour_codewords = 0;
};

// All codewords in one picture; layout as CodeAtlas in package/tree_model.h.
struct CodedTextures {
  std::vector<CodedLevel> levels;  // as Billboards::levels
  int atlas_width_px = 0, atlas_height_px = 0;
  std::vector<glm::u8vec4> atlas_rgba;
  std::vector<std::uint8_t> atlas_bc3;
};

// A level that has just been coded, for whoever watches. Valid during the call only.
struct LevelColours;  // level_codes.h
struct LevelAlphas;
struct CompressPreview {
  const BillboardLevel& level;
  const LevelColours& colours;
  const LevelAlphas& alphas;
  int levels_done = 0, levels = 0;
};
using CompressWatcher = std::function<void(const CompressPreview&)>;

// Vector quantisation of every level's 4x4 blocks, colour and alpha apart (Linz et al. 2006,
// section 4).
CodedTextures compress_billboards(const Billboards& billboards, const CompressOptions& options,
                                  Progress& progress, const CompressWatcher& watcher = {});

void write(BinaryWriter& writer, const CodedTextures& textures);
CodedTextures read_coded_textures(BinaryReader& reader);

}  // namespace bosk
