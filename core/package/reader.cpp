#include "core/package/reader.h"

#include <fstream>
#include <functional>
#include <new>
#include <optional>

#include "core/package/container.h"
#include "core/package/index_decode.h"
#include "core/package/model_check.h"
#include "core/package/parallel.h"
#include "core/package/section_decode.h"

namespace bosk {
namespace {

IndexShape index_shape(const LevelFrame& frame) {
  const auto across = std::size_t(frame.level.texels / 4);
  return {frame.cell_count, frame.level.views.size(), across * across};
}

using Tasks = std::vector<std::function<void()>>;

// Before memory is asked for: numbers that follow from the table, not from the bytes there are.
void check_counts(const Container& container, const std::vector<LevelFrame>& frames) {
  std::uint64_t indices = 0, all_cells = 0;
  for (std::uint32_t i = 0; i < frames.size(); ++i) {
    const LevelFrame& frame = frames[i];
    const SectionEntry* cells = find_section(container, kCellsSection, i);
    if (frame.cell_count > kMaxCells - all_cells ||
        (cells && frame.cell_count / 8 > cells->raw_length)) {
      damaged("levels: too many cells");
    }
    all_cells += frame.cell_count;
    if (i > 0 && frame.level.level <= frames[i - 1].level.level) {
      damaged("levels out of order");
    }
    indices += index_shape(frame).count();
  }
  if (indices > kMaxIndices) damaged("levels: too many indices");
}

// Each level's cells build on those of the level before.
void read_cells(const Container& container, const std::vector<LevelFrame>& frames,
                std::vector<TreeLevel>& levels) {
  for (std::uint32_t i = 0; i < levels.size(); ++i) {
    std::span<const std::uint64_t> parents;
    if (i > 0 && levels[i - 1].level + 1 == levels[i].level) parents = levels[i - 1].cells;
    levels[i].cells = decode_cells(section_bytes(container, kCellsSection, i), frames[i], parents);
  }
}

// Alpha or colour of one level, in chunks.
struct IndexReading {
  CodedIndices coded;
  std::vector<std::uint16_t>* indices = nullptr;
  std::optional<ParentIndices> parents;
  std::uint32_t parent_codewords = 0;

  void add_tasks(const std::vector<std::vector<std::uint8_t>>& live, std::uint16_t pruned_value,
                 Tasks& tasks) {
    for (std::size_t chunk = 0; chunk < coded.chunks.size(); ++chunk) {
      tasks.push_back([this, &live, pruned_value, chunk] {
        decode_indices(coded, chunk, live[chunk], pruned_value, parents ? &*parents : nullptr,
                       parent_codewords, *indices);
      });
    }
  }
};

IndexReading open_reading(const Container& container, const std::vector<LevelFrame>& frames,
                          std::vector<TreeLevel>& levels, std::uint32_t i, std::uint32_t type,
                          std::vector<std::uint16_t> TreeLevel::*indices,
                          CodeRange TreeLevel::*codes) {
  const std::string name = section_name(type, i);
  IndexReading reading{open_indices(section_bytes(container, type, i), index_shape(frames[i]),
                                    (levels[i].*codes).count, name),
                       &(levels[i].*indices),
                       {},
                       0};
  if (!reading.coded.goes_by_parents) return reading;
  if (i == 0) damaged(name + ": there is no level before");
  const TreeLevel& before = levels[i - 1];
  reading.parents = parent_indices(levels[i], before, before.*indices);
  reading.parent_codewords = (before.*codes).count;
  return reading;
}

// For each level and chunk, which blocks are live.
using LiveBlocks = std::vector<std::vector<std::vector<std::uint8_t>>>;

std::vector<CodedIndices> open_all_live(const Container& container,
                                        const std::vector<LevelFrame>& frames) {
  std::vector<CodedIndices> coded;
  for (std::uint32_t i = 0; i < frames.size(); ++i) {
    coded.push_back(open_live(section_bytes(container, kLiveSection, i), index_shape(frames[i]),
                              section_name(kLiveSection, i)));
  }
  return coded;
}

// Cells and live blocks of all levels, and memory for the indices; the longest go first.
LiveBlocks read_cells_and_live(const Container& container, const std::vector<LevelFrame>& frames,
                               std::vector<TreeLevel>& levels, unsigned threads) {
  const std::vector<CodedIndices> coded = open_all_live(container, frames);
  LiveBlocks live(frames.size());
  Tasks tasks{[&] { read_cells(container, frames, levels); }};
  for (std::size_t i = frames.size(); i-- > 0;) {
    live[i].resize(coded[i].chunks.size());
    for (std::size_t chunk = 0; chunk < live[i].size(); ++chunk) {
      tasks.push_back([&, i, chunk] { live[i][chunk] = decode_live(coded[i], chunk); });
    }
    const std::size_t count = index_shape(frames[i]).count();
    tasks.push_back([&, i, count] { levels[i].alpha_indices.resize(count); });
    tasks.push_back([&, i, count] { levels[i].colour_indices.resize(count); });
  }
  run_parallel(tasks, threads);
  return live;
}

// Indices need to know which blocks are live, and may need the level before. Within a level alpha,
// colour and chunks of cells are independent.
std::vector<TreeLevel> read_levels(const Container& container,
                                   const std::vector<LevelFrame>& frames, unsigned threads) {
  std::vector<TreeLevel> levels;
  levels.reserve(frames.size());
  for (const LevelFrame& frame : frames) levels.push_back(frame.level);
  const LiveBlocks live = read_cells_and_live(container, frames, levels, threads);
  for (std::uint32_t i = 0; i < frames.size(); ++i) {
    auto colour = open_reading(container, frames, levels, i, kColourSection,
                               &TreeLevel::colour_indices, &TreeLevel::colour_codes);
    auto alpha = open_reading(container, frames, levels, i, kAlphaSection,
                              &TreeLevel::alpha_indices, &TreeLevel::alpha_codes);
    Tasks tasks;
    colour.add_tasks(live[i], 0, tasks);
    alpha.add_tasks(live[i], kPruned, tasks);
    run_parallel(tasks, threads);
  }
  return levels;
}

TreeModel read_sections(const Container& container, unsigned threads) {
  TreeModel tree;
  tree.metadata = decode_metadata(section_bytes(container, kMetadataSection));
  decode_scene(section_bytes(container, kSceneSection), tree);
  tree.atlas =
      decode_atlas(section_bytes(container, kAtlasSection), section_bytes(container, kBc3Section));
  const auto frames = decode_levels(section_bytes(container, kLevelsSection));
  for (const LevelFrame& frame : frames) check_level_frame(frame.level, tree);
  check_counts(container, frames);
  tree.levels = read_levels(container, frames, threads);
  check_tree_model(tree);
  return tree;
}

}  // namespace

TreeModel read_tree(std::span<const std::byte> package, const std::string& name, unsigned threads) {
  try {
    return read_sections(open_container(package), threads);
  } catch (const Error& error) {
    throw Error(name + ": " + error.what(), error.kind());
  } catch (const std::bad_alloc&) {
    throw Error(name + ": not enough memory to open the tree package", ErrorKind::resource);
  }
}

TreeModel load_tree(const std::filesystem::path& path, unsigned threads) {
  return read_tree(load_package_bytes(path), path.string(), threads);
}

std::vector<std::byte> load_package_bytes(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw Error(path.string() + ": there is no such file; name a .bosk package");
  }
  const auto size = std::filesystem::file_size(path, error);
  if (error) throw Error(path.string() + ": cannot be read: " + error.message());
  if (size > kMaxFileBytes) throw Error(path.string() + ": larger than any tree package may be");
  std::vector<std::byte> bytes(size);
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size))) {
    throw Error(path.string() + ": cannot be read; check that you may open it");
  }
  return bytes;
}

}  // namespace bosk
