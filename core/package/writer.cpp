#include "core/package/writer.h"

#include <tbb/parallel_for.h>
#include <xxhash.h>

#include <algorithm>
#include <functional>

#include "core/base/atomic_file.h"
#include "core/package/byte_sink.h"
#include "core/package/container.h"
#include "core/package/index_encode.h"
#include "core/package/model_check.h"
#include "core/package/section_encode.h"
#include "core/package/zstd_encode.h"

namespace bosk {
namespace {

using Bytes = std::vector<std::byte>;

// Lengths of lists and kinds of statistics to try: more pay off in larger levels. Beyond these the
// tables grow out of a processor's cache for a few tenths of a percent.
struct RankedOptions {
  unsigned ranks, buckets;
};
constexpr RankedOptions kRankedOptions[] = {{64, 1}, {255, 4}};

// One way to say a section, before zstd.
struct Candidate {
  Bytes raw;
  bool is_coded = false;  // zstd would gain nothing
};

struct Section {
  std::uint32_t type = 0, instance = 0;
  std::function<std::vector<Candidate>()> candidates;
};

struct PackedSection {
  std::uint16_t codec = kStored;
  std::uint64_t raw_length = 0;
  Bytes bytes;
};

IndexShape index_shape(const TreeLevel& level) {
  const auto across = std::size_t(level.texels / 4);
  return {level.cells.size(), level.views.size(), across * across};
}

// One level in the order that it is coded in.
struct OrderedLevel {
  IndexShape shape;
  std::vector<std::uint16_t> alpha, colour;
  std::vector<std::uint8_t> live;
};

OrderedLevel order_level(const TreeLevel& level) {
  OrderedLevel ordered{index_shape(level), {}, {}, {}};
  ordered.alpha = view_order(level.alpha_indices, ordered.shape);
  ordered.colour = view_order(level.colour_indices, ordered.shape);
  ordered.live = live_blocks(ordered.alpha);
  return ordered;
}

// Without a view before, ranks have nothing to go by, but direct indices are range coded too.
std::vector<Candidate> index_candidates(const std::vector<std::uint16_t>& indices,
                                        const OrderedLevel& level, std::uint32_t codewords) {
  std::vector<Candidate> candidates{{encode_planes(indices, level.live), false}};
  for (const auto& [ranks, buckets] : kRankedOptions) {
    if (codewords == 0) break;
    candidates.push_back(
        {encode_ranked(indices, level.live, level.shape, codewords, ranks, buckets), true});
  }
  return candidates;
}

// In the order of the file.
std::vector<Section> list_sections(const TreeModel& tree,
                                   const std::vector<OrderedLevel>& ordered) {
  const auto one = [](auto encode) {
    return [=] { return std::vector<Candidate>{{encode(), false}}; };
  };
  std::vector<Section> sections{
      {kMetadataSection, 0, one([&tree] { return encode_metadata(tree.metadata); })},
      {kSceneSection, 0, one([&tree] { return encode_scene(tree); })},
      {kLevelsSection, 0, one([&tree] { return encode_levels(tree); })},
      {kAtlasSection, 0, one([&tree] { return encode_atlas(tree.atlas); })},
      {kBc3Section, 0, one([&tree] { return encode_bc3(tree.atlas); })}};
  for (std::uint32_t i = 0; i < tree.levels.size(); ++i) {
    const TreeLevel& level = tree.levels[i];
    const OrderedLevel& indices = ordered[i];
    sections.push_back({kCellsSection, i, one([&level] { return encode_cells(level); })});
    sections.push_back(
        {kLiveSection, i, one([&indices] { return encode_live(indices.live, indices.shape); })});
    sections.push_back({kAlphaSection, i, [&] {
                          return index_candidates(indices.alpha, indices, level.alpha_codes.count);
                        }});
    sections.push_back(
        {kColourSection, i,
         [&] { return index_candidates(indices.colour, indices, level.colour_codes.count); }});
  }
  return sections;
}

// Stored where zstd gains nothing, or so much that a reader would take it for a bomb.
PackedSection pack(Candidate candidate, const Progress& progress) {
  const std::size_t raw_length = candidate.raw.size();
  if (!candidate.is_coded) {
    Bytes packed = zstd_compress(candidate.raw, progress);
    if (packed.size() < raw_length && raw_length / kMaxRatio <= packed.size()) {
      return {kZstd, raw_length, std::move(packed)};
    }
  }
  return {kStored, raw_length, std::move(candidate.raw)};
}

// Planes are tried where they may win: small levels, and only then is zstd quick to say so.
PackedSection smallest(std::vector<Candidate> candidates, const Progress& progress) {
  constexpr std::size_t kFewBytes = 1 << 15;
  if (candidates.size() > 1 && candidates.front().raw.size() > kFewBytes) {
    candidates.erase(candidates.begin());
  }
  PackedSection best = pack(std::move(candidates.front()), progress);
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    PackedSection other = pack(std::move(candidates[i]), progress);
    if (other.bytes.size() < best.bytes.size()) best = std::move(other);
  }
  return best;
}

void put_entry(ByteSink& table, const Section& section, const PackedSection& packed,
               std::uint64_t offset) {
  table.value(section.type);
  table.value(section.instance);
  table.value(packed.codec);
  table.value(kRequired);
  table.value(std::uint32_t(0));
  table.value(offset);
  table.value(std::uint64_t(packed.bytes.size()));
  table.value(packed.raw_length);
  table.value(std::uint64_t(XXH3_64bits(packed.bytes.data(), packed.bytes.size())));
}

Bytes header(const Bytes& table, std::uint64_t file_length, std::size_t section_count) {
  ByteSink sink;
  for (const std::uint8_t byte : kMagic) sink.value(byte);
  sink.value(kMajorVersion);
  sink.value(kMinorVersion);
  sink.value(kByteOrderMark);
  sink.value(file_length);
  sink.value(std::uint32_t(section_count));
  sink.value(std::uint32_t(0));
  sink.value(std::uint64_t(XXH3_64bits(table.data(), table.size())));
  sink.bytes.resize(56);
  sink.value(std::uint64_t(XXH3_64bits(sink.bytes.data(), sink.bytes.size())));
  return std::move(sink.bytes);
}

Bytes assemble_file(const std::vector<Section>& sections,
                    const std::vector<PackedSection>& packed) {
  ByteSink table, body;
  const std::uint64_t first = kHeaderBytes + sections.size() * kEntryBytes;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    put_entry(table, sections[i], packed[i], first + body.bytes.size());
    body.append(packed[i].bytes);
    body.bytes.resize((body.bytes.size() + kSectionAlignment - 1) / kSectionAlignment *
                      kSectionAlignment);
  }
  ByteSink file{header(table.bytes, first + body.bytes.size(), sections.size())};
  file.append(table.bytes);
  file.append(body.bytes);
  if (file.bytes.size() > kMaxFileBytes) {
    throw Error("the tree is too large for a package; give it fewer levels or fewer views");
  }
  return std::move(file.bytes);
}

}  // namespace

std::vector<std::byte> package_bytes(const TreeModel& tree, Progress& progress) {
  check_tree_model(tree);
  std::vector<OrderedLevel> ordered;
  for (const TreeLevel& level : tree.levels) ordered.push_back(order_level(level));
  const std::vector<Section> sections = list_sections(tree, ordered);
  progress.begin("Packing", sections.size());
  std::vector<PackedSection> packed(sections.size());
  tbb::parallel_for(std::size_t(0), sections.size(), [&](std::size_t i) {
    packed[i] = smallest(sections[i].candidates(), progress);
    progress.advance();
  });
  return assemble_file(sections, packed);
}

void write_package(const std::filesystem::path& path, const TreeModel& tree, Progress& progress) {
  write_file_atomically(path, package_bytes(tree, progress));
}

}  // namespace bosk
