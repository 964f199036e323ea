#include "core/package/codebook_curve.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/compress/atlas.h"
#include "core/compress/level_codes.h"
#include "core/compress/rate_distortion.h"
#include "core/package/assemble.h"
#include "core/package/billboard_sample.h"
#include "core/package/container.h"
#include "core/package/writer.h"

namespace bosk {
namespace {

constexpr std::size_t kSampleBlocks = 200'000;
constexpr int kTrainingBlocks = 16'384;  // of a level
constexpr double kCodingShare = 0.85;    // of a point's time

// Kinds of blocks in each level of the sample: more codewords than that are never used.
struct KindCounts {
  std::vector<std::size_t> colours, alphas;
};

KindCounts count_kinds(const Billboards& billboards, Progress& progress) {
  KindCounts counts;
  for (const BillboardLevel& level : billboards.levels) {
    counts.colours.push_back(distinct_colours(level, progress).first_block.size());
    counts.alphas.push_back(distinct_alphas(level, progress).first_block.size());
  }
  return counts;
}

std::size_t tiles_for(const std::vector<std::size_t>& kinds, int codewords) {
  std::size_t tiles = 0;
  for (const std::size_t count : kinds) tiles += std::min(count, std::size_t(codewords));
  return tiles;
}

bool fits(const KindCounts& kinds, int codewords) {
  return std::max(tiles_for(kinds.colours, codewords), tiles_for(kinds.alphas, codewords)) <=
         kMostTiles;
}

// Bytes of the sample's sections, scaled up to the tree.
void add_bytes(const std::vector<std::byte>& package, const std::vector<double>& scale,
               CodebookPoint& point) {
  double colour = 0.0, alpha = 0.0, other = 0.0;
  const Container container = open_container(package);
  for (const SectionEntry& section : container.sections) {
    const auto bytes = double(section.length);
    if (section.type == kAtlasSection) {  // three channels of colour and one of alpha
      colour += 0.75 * bytes, alpha += 0.25 * bytes;
    } else if (section.type == kBc3Section) {  // half of a block each
      colour += 0.5 * bytes, alpha += 0.5 * bytes;
    } else if (section.type == kColourSection) {
      colour += scale[section.instance] * bytes;
    } else if (section.type == kAlphaSection) {
      alpha += scale[section.instance] * bytes;
    } else if (section.type == kCellsSection || section.type == kLiveSection) {
      other += scale[section.instance] * bytes;
    } else {
      other += bytes;
    }
  }
  other += double(kHeaderBytes + kEntryBytes * container.sections.size());
  point.colour_bytes = std::size_t(std::lround(colour));
  point.alpha_bytes = std::size_t(std::lround(alpha));
  point.other_bytes = std::size_t(std::lround(other));
}

void add_quality(const BillboardSample& sample, const CodedTextures& textures, Progress& progress,
                 CodebookPoint& point) {
  auto levels = rate_distortion(sample.billboards, textures, false, progress);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels[i].blocks = std::size_t(double(levels[i].blocks) * sample.scale[i]);
    levels[i].pruned = std::size_t(double(levels[i].pruned) * sample.scale[i]);
  }
  const OverallPsnr psnr = overall_psnr(levels);
  point.colour_psnr_db = psnr.colour_db;
  point.alpha_psnr_db = psnr.alpha_db;
}

CodebookPoint point_of(const BillboardSample& sample, const CompressOptions& options,
                       Progress& progress) {
  CodebookPoint point;
  point.codewords = options.colour_codewords;
  std::optional<ProgressPart> part(std::in_place, progress, 0.0, kCodingShare);
  const CodedTextures textures = compress_billboards(sample.billboards, options, progress);
  part.emplace(progress, kCodingShare, 1.0);
  add_quality(sample, textures, progress, point);
  const TreeModel tree = assemble_tree(sample.billboards, textures, {});
  add_bytes(package_bytes(tree, progress), sample.scale, point);
  return point;
}

}  // namespace

std::vector<int> usual_codeword_counts() {
  std::vector<int> counts;
  for (int count = 16; count <= 4096; count *= 2) counts.push_back(count);
  return counts;
}

std::vector<CodebookPoint> codebook_curve(const Billboards& billboards,
                                          const CompressOptions& options,
                                          std::span<const int> codewords, Progress& progress,
                                          const OnCodebookPoint& on_point) {
  const BillboardSample sample = sample_of(billboards, kSampleBlocks);
  const KindCounts kinds = count_kinds(sample.billboards, progress);
  double all = 0.0, done = 0.0;
  for (const int count : codewords) all += 64.0 + count;  // time grows with the search
  std::vector<CodebookPoint> points;
  for (const int count : codewords) {
    const ProgressPart part(progress, done / all, (done + 64.0 + count) / all);
    done += 64.0 + count;
    if (!fits(kinds, count)) continue;
    CompressOptions at = options;
    at.colour_codewords = at.alpha_codewords = count;
    at.training_blocks = std::min(options.training_blocks, kTrainingBlocks);
    points.push_back(point_of(sample, at, progress));
    if (on_point) on_point(points.back());
  }
  return points;
}

}  // namespace bosk
