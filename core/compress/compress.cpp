#include "core/compress/compress.h"

#include <string>

#include "core/base/error.h"
#include "core/compress/atlas.h"
#include "core/compress/level_codes.h"

namespace bosk {
namespace {

constexpr double kBc3Share = 0.1;  // of the stage's time

void check_level(const BillboardLevel& level) {
  const std::size_t textures = level.cells.size() * level.views.size();
  const bool whole_blocks = level.texels > 0 && level.texels % 4 == 0;
  if (!whole_blocks || level.texture.size() != textures * level.texture_size()) {
    throw Error("billboard level " + std::to_string(level.level) +
                " has textures of a size that isn't whole 4x4 blocks; make the billboards again");
  }
}

// Share of the work that lies before each level and at the end, by blocks.
std::vector<double> shares(const Billboards& billboards) {
  std::vector<double> done{0.0};
  for (const BillboardLevel& level : billboards.levels) {
    done.push_back(done.back() + double(block_count(level)) + 1.0);
  }
  for (double& share : done) share *= (1.0 - kBc3Share) / done.back();
  return done;
}

}  // namespace

Options describe(CompressOptions& options) {
  return {
      {"colour_codewords",
       "",
       "4x4 colour patterns that stand for all blocks of a level",
       &options.colour_codewords,
       1,
       4096,
       {}},
      {"alpha_codewords",
       "",
       "4x4 alpha patterns that stand for all blocks of a level",
       &options.alpha_codewords,
       1,
       4096,
       {}},
      {"colour_space",
       "",
       "Where colours are compared; log chroma judges vivid colours as eyes do",
       &options.colour_space,
       0,
       0,
       {"lab", "lab_log_chroma", "srgb"}},
      {"codeword_rule",
       "",
       "What stands for similar colour blocks: their mean, or (Linz et al.) the block closest to "
       "it",
       &options.codeword_rule,
       0,
       0,
       {"centroid", "closest_block"}},
      {"block_mean_weight",
       "",
       "How much a block's mean counts next to its texels; more looks better from afar",
       &options.block_mean_weight,
       0.0,
       64.0,
       {}},
      {"training_blocks",
       "",
       "Codewords are found on at most so many blocks of a level; more is slower",
       &options.training_blocks,
       1000,
       1000000,
       {}},
  };
}

CodedTextures compress_billboards(const Billboards& billboards, const CompressOptions& options,
                                  Progress& progress, const CompressWatcher& watcher) {
  for (const BillboardLevel& level : billboards.levels) check_level(level);
  std::vector<LevelColours> colours;
  std::vector<LevelAlphas> alphas;
  const std::vector<double> share = shares(billboards);
  for (std::size_t i = 0; i < billboards.levels.size(); ++i) {
    const BillboardLevel& level = billboards.levels[i];
    const double middle = 0.3 * share[i] + 0.7 * share[i + 1];
    const std::string name = " of level " + std::to_string(level.level);
    progress.begin("Colour codewords" + name, code_units(level), share[i], middle);
    colours.push_back(code_colours(level, options, progress));
    progress.begin("Alpha codewords" + name, code_units(level), middle, share[i + 1]);
    alphas.push_back(code_alphas(level, options, progress));
    if (watcher) {
      watcher({level, colours[i], alphas[i], int(i + 1), int(billboards.levels.size())});
    }
  }
  CodedTextures textures;
  lay_out_atlas(colours, alphas, textures);
  for (std::size_t i = 0; i < textures.levels.size(); ++i) {
    textures.levels[i].colour_indices = std::move(colours[i].indices);
    textures.levels[i].alpha_indices = std::move(alphas[i].indices);
  }
  progress.begin("Compressing the atlas", textures.atlas_rgba.size() / 16, share.back(), 1.0);
  textures.atlas_bc3 = bc3_from_atlas(textures, progress);
  return textures;
}

void write(BinaryWriter& writer, const CodedTextures& textures) {
  writer.value(std::uint64_t(textures.levels.size()));
  for (const CodedLevel& level : textures.levels) {
    writer.array(level.alpha_indices);
    writer.array(level.colour_indices);
    writer.value(level.first_alpha_tile);
    writer.value(level.alpha_codewords);
    writer.value(level.first_colour_tile);
    writer.value(level.colour_codewords);
  }
  writer.value(textures.atlas_width_px);
  writer.value(textures.atlas_height_px);
  writer.array(textures.atlas_rgba);
  writer.array(textures.atlas_bc3);
}

CodedTextures read_coded_textures(BinaryReader& reader) {
  CodedTextures textures;
  const auto levels = reader.value<std::uint64_t>();
  if (levels > 64) throw Error("stored result has more levels than an octree can have");
  for (std::uint64_t i = 0; i < levels; ++i) {
    CodedLevel& level = textures.levels.emplace_back();
    level.alpha_indices = reader.array<std::uint16_t>();
    level.colour_indices = reader.array<std::uint16_t>();
    level.first_alpha_tile = reader.value<std::uint32_t>();
    level.alpha_codewords = reader.value<std::uint32_t>();
    level.first_colour_tile = reader.value<std::uint32_t>();
    level.colour_codewords = reader.value<std::uint32_t>();
  }
  textures.atlas_width_px = reader.value<int>();
  textures.atlas_height_px = reader.value<int>();
  textures.atlas_rgba = reader.array<glm::u8vec4>();
  textures.atlas_bc3 = reader.array<std::uint8_t>();
  return textures;
}

}  // namespace bosk
