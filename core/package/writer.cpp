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

// A level beside the one before it.
struct LevelPair {
  const TreeLevel& level;
  const TreeLevel* before = nullptr;

  std::span<const std::uint64_t> parents() const {
    if (!before || before->level + 1 != level.level) return {};
    return before->cells;
  }
};

// The smaller of two ways counts: each cell on its own, or from its parent's index.
std::vector<Candidate> index_candidates(const LevelPair& pair,
                                        std::vector<std::uint16_t> TreeLevel::*indices,
                                        CodeRange TreeLevel::*codes) {
  const TreeLevel& level = pair.level;
  const IndexShape shape = index_shape(level);
  const auto encode = [&](const ParentIndices* parents, std::uint32_t parent_codewords) {
    return Candidate{encode_indices(level.*indices, level.alpha_indices, shape,
                                    (level.*codes).count, parents, parent_codewords),
                     true};
  };
  std::vector<Candidate> candidates{encode(nullptr, 0)};
  if (pair.before) {
    const ParentIndices parents = parent_indices(level, *pair.before, (*pair.before).*indices);
    candidates.push_back(encode(&parents, ((*pair.before).*codes).count));
  }
  return candidates;
}

// In the order of the file.
std::vector<Section> list_sections(const TreeModel& tree) {
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
    const LevelPair pair{tree.levels[i], i > 0 ? &tree.levels[i - 1] : nullptr};
    sections.push_back(
        {kCellsSection, i, one([pair] { return encode_cells(pair.level.cells, pair.parents()); })});
    sections.push_back({kLiveSection, i, one([pair] {
                          return encode_live(pair.level.alpha_indices, index_shape(pair.level));
                        })});
    sections.push_back({kAlphaSection, i, [pair] {
                          return index_candidates(pair, &TreeLevel::alpha_indices,
                                                  &TreeLevel::alpha_codes);
                        }});
    sections.push_back({kColourSection, i, [pair] {
                          return index_candidates(pair, &TreeLevel::colour_indices,
                                                  &TreeLevel::colour_codes);
                        }});
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

PackedSection smallest(std::vector<Candidate> candidates, const Progress& progress) {
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
  const std::vector<Section> sections = list_sections(tree);
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
