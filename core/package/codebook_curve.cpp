#include "core/package/codebook_curve.h"

#include <algorithm>
#include <cassert>
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

struct SectionBytes {
  double colour = 0.0, alpha = 0.0, other = 0.0;
};
struct PackedBytes {
  SectionBytes fixed;                // that every part of the tree needs: codewords, header
  std::vector<SectionBytes> levels;  // indices and cells
};

PackedBytes packed_bytes(const Billboards& billboards, const CodedTextures& textures,
                         Progress& progress) {
  const std::vector<std::byte> package =
      package_bytes(assemble_tree(billboards, textures, {}), progress);
  const Container container = open_container(package);
  PackedBytes bytes;
  bytes.levels.resize(billboards.levels.size());
  for (const SectionEntry& section : container.sections) {
    const auto length = double(section.length + kEntryBytes);
    if (section.type == kAtlasSection) {  // three channels of colour and one of alpha
      bytes.fixed.colour += 0.75 * length, bytes.fixed.alpha += 0.25 * length;
    } else if (section.type == kBc3Section) {  // half of a block each
      bytes.fixed.colour += 0.5 * length, bytes.fixed.alpha += 0.5 * length;
    } else if (section.type == kColourSection) {
      bytes.levels[section.instance].colour += length;
    } else if (section.type == kAlphaSection) {
      bytes.levels[section.instance].alpha += length;
    } else if (section.type == kCellsSection || section.type == kLiveSection) {
      bytes.levels[section.instance].other += length;
    } else {
      bytes.fixed.other += length;
    }
  }
  return bytes;
}

// The indices of those cells of `whole` that `part` has too.
CodedTextures part_of(const CodedTextures& textures, const Billboards& whole,
                      const Billboards& part) {
  CodedTextures result = textures;
  for (std::size_t i = 0; i < part.levels.size(); ++i) {
    const auto& cells = whole.levels[i].cells;
    const CodedLevel& from = textures.levels[i];
    CodedLevel& to = result.levels[i];
    to.alpha_indices.clear();
    to.colour_indices.clear();
    if (cells.empty()) continue;
    const auto blocks = std::ptrdiff_t(from.alpha_indices.size() / cells.size());
    for (const std::uint64_t cell : part.levels[i].cells) {
      const auto first =
          blocks * (std::lower_bound(cells.begin(), cells.end(), cell) - cells.begin());
      const auto copy = [&](const std::vector<std::uint16_t>& all,
                            std::vector<std::uint16_t>& some) {
        some.insert(some.end(), all.begin() + first, all.begin() + first + blocks);
      };
      copy(from.alpha_indices, to.alpha_indices);
      copy(from.colour_indices, to.colour_indices);
    }
  }
  return result;
}

// Bytes of all cells by those of some and of half of the same. The coder learns as it goes, so that
// further cells cost what the second half cost and not what the first did.
double bytes_of_all(double some, double half, double scale, double scale_of_half) {
  const double further = scale - 1.0, second = 1.0 - 1.0 / scale_of_half;
  return second > 0.0 ? some + further * (some - half) / second : scale * some;
}

// Scales the sample's bytes up to the tree.
void add_bytes(const BillboardSample& sample, const CodedTextures& textures, Progress& progress,
               CodebookPoint& point) {
  const BillboardSample half = sample_of(sample.billboards, block_count(sample.billboards) / 2);
  const PackedBytes some = packed_bytes(sample.billboards, textures, progress);
  const PackedBytes fewer = packed_bytes(
      half.billboards, part_of(textures, sample.billboards, half.billboards), progress);
  SectionBytes all = some.fixed;
  for (std::size_t i = 0; i < some.levels.size(); ++i) {
    const auto add = [&](double SectionBytes::*kind) {
      all.*kind +=
          bytes_of_all(some.levels[i].*kind, fewer.levels[i].*kind, sample.scale[i], half.scale[i]);
    };
    add(&SectionBytes::colour);
    add(&SectionBytes::alpha);
    add(&SectionBytes::other);
  }
  point.colour_bytes = std::size_t(std::lround(all.colour));
  point.alpha_bytes = std::size_t(std::lround(all.alpha));
  point.other_bytes = kHeaderBytes + std::size_t(std::lround(all.other));
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
  add_bytes(sample, textures, progress, point);
  return point;
}

}  // namespace

std::vector<int> usual_codeword_counts() {
  std::vector<int> counts;
  for (int count = 16; count <= 4096; count *= 2) counts.push_back(count);
  return counts;
}

CodebookPoint at_codewords(std::span<const CodebookPoint> curve, int codewords) {
  assert(!curve.empty());
  const auto after = std::find_if(curve.begin(), curve.end(), [&](const CodebookPoint& point) {
    return point.codewords >= codewords;
  });
  if (after == curve.begin()) return curve.front();
  if (after == curve.end()) return curve.back();
  const CodebookPoint &a = *(after - 1), &b = *after;
  const double part =
      std::log(double(codewords) / a.codewords) / std::log(double(b.codewords) / a.codewords);
  const auto bytes = [&](std::size_t from, std::size_t to) {
    return std::size_t(std::lround(std::lerp(double(from), double(to), part)));
  };
  return {codewords,
          std::lerp(a.colour_psnr_db, b.colour_psnr_db, part),
          std::lerp(a.alpha_psnr_db, b.alpha_psnr_db, part),
          bytes(a.colour_bytes, b.colour_bytes),
          bytes(a.alpha_bytes, b.alpha_bytes),
          bytes(a.other_bytes, b.other_bytes)};
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
