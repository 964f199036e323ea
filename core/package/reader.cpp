#include "core/package/reader.h"

#include <fstream>
#include <new>

#include "core/package/container.h"
#include "core/package/index_decode.h"
#include "core/package/model_check.h"
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

TreeLevel read_level(const Container& container, std::uint32_t position, const LevelFrame& frame,
                     const CodeAtlas& atlas) {
  TreeLevel level = frame.level;
  level.cells = decode_cells(section_bytes(container, kCellsSection, position), frame);
  LevelIndices indices = decode_level_indices(section_bytes(container, kAlphaSection, position),
                                              section_bytes(container, kColourSection, position),
                                              index_shape(frame), atlas, frame.level);
  level.alpha_indices = std::move(indices.alpha);
  level.colour_indices = std::move(indices.colour);
  return level;
}

TreeModel read_sections(const Container& container) {
  TreeModel tree;
  tree.metadata = decode_metadata(section_bytes(container, kMetadataSection));
  decode_scene(section_bytes(container, kSceneSection), tree);
  tree.atlas =
      decode_atlas(section_bytes(container, kAtlasSection), section_bytes(container, kBc3Section));
  const auto frames = decode_levels(section_bytes(container, kLevelsSection));
  for (const LevelFrame& frame : frames) check_level_frame(frame.level, tree);
  check_index_total(frames);
  for (std::uint32_t i = 0; i < frames.size(); ++i) {
    tree.levels.push_back(read_level(container, i, frames[i], tree.atlas));
  }
  check_tree_model(tree);
  return tree;
}

}  // namespace

TreeModel read_tree(std::span<const std::byte> package, const std::string& name) {
  try {
    return read_sections(open_container(package));
  } catch (const Error& error) {
    throw Error(name + ": " + error.what(), error.kind());
  } catch (const std::bad_alloc&) {
    throw Error(name + ": not enough memory to open the tree package", ErrorKind::resource);
  }
}

TreeModel load_tree(const std::filesystem::path& path) {
  return read_tree(load_package_bytes(path), path.string());
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
