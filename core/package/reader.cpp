#include "core/package/reader.h"

#include <fstream>
#include <functional>
#include <new>

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

// Before any index is decoded: their number follows from the table, not from the bytes there are.
void check_index_total(const std::vector<LevelFrame>& frames) {
  std::uint64_t total = 0;
  for (const LevelFrame& frame : frames) {
    if (frame.cell_count > kMaxCells) damaged("levels: too many cells");
    total += index_shape(frame).count();
  }
  if (total > kMaxIndices) damaged("levels: too many indices");
}

// Two rounds, since indices need to know which blocks are live. Levels are independent, and the
// alpha and colour of one too; the finest and so longest go first.
std::vector<TreeLevel> read_levels(const Container& container,
                                   const std::vector<LevelFrame>& frames, unsigned threads) {
  std::vector<TreeLevel> levels(frames.size());
  std::vector<std::vector<std::uint8_t>> live(frames.size());
  std::vector<std::function<void()>> first, second;
  for (std::uint32_t i = std::uint32_t(frames.size()); i-- > 0;) {
    first.push_back([&, i] {
      levels[i] = frames[i].level;
      levels[i].cells = decode_cells(section_bytes(container, kCellsSection, i), frames[i]);
      live[i] = decode_live(section_bytes(container, kLiveSection, i), index_shape(frames[i]),
                            section_name(kLiveSection, i));
    });
    const auto read = [&, i](std::uint32_t type, const CodeRange& codes,
                             std::uint16_t pruned_value) {
      return decode_indices(section_bytes(container, type, i), index_shape(frames[i]), live[i],
                            codes.count, pruned_value, section_name(type, i));
    };
    second.push_back([&, i, read] {
      levels[i].alpha_indices = read(kAlphaSection, frames[i].level.alpha_codes, kPruned);
    });
    second.push_back([&, i, read] {
      levels[i].colour_indices = read(kColourSection, frames[i].level.colour_codes, 0);
    });
  }
  run_parallel(first, threads);
  run_parallel(second, threads);
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
  check_index_total(frames);
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
