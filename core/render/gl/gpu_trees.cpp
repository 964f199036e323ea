#include "core/render/gl/gpu_trees.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/render/billboard_geometry.h"

namespace bosk {
namespace {

using Trees = std::vector<std::shared_ptr<const PreparedTree>>;

constexpr GLenum kDxt5 = 0x83f3;  // GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, not in the core header
constexpr std::uint32_t kOutside = 0xfffe;  // shaders/pairs.glsl

// shaders/tree.glsl
struct TreeBlock {
  std::uint32_t first_level, level_count, first_order, layer;
  float corner_m, foot_m, inverse_height;
  std::int32_t finest_level;
};
struct LevelBlock {
  std::uint32_t first_cell, first_pair, first_view, view_count;
  std::int32_t level, texels;
  float cell_m, half_m;
};
static_assert(sizeof(TreeBlock) == 32 && sizeof(LevelBlock) == 32);

struct Blocks {
  std::vector<TreeBlock> trees;
  std::vector<LevelBlock> levels;
  std::vector<std::uint32_t> order_table, pairs;
  std::vector<glm::uvec2> cells;
  std::vector<glm::vec4> views;
};

// Where the next value goes; places have 32 bits in shaders.
template <class T>
std::uint32_t next_index(const std::vector<T>& values) {
  return std::uint32_t(values.size());
}

glm::uvec2 packed_cell(std::uint64_t morton) {
  const glm::uvec3 cell = cell_from_morton(morton);
  return {cell.x | cell.y << 21, cell.y >> 11 | cell.z << 10};
}

// Where a codeword stands in the atlas; pruned and stray ones stay apart.
class TilePlaces {
 public:
  explicit TilePlaces(const CodeAtlas& atlas)
      : across_(std::uint32_t(atlas.width_px / 4)),
        count_(across_ * std::uint32_t(atlas.height_px / 4)) {}

  std::uint32_t pair(const TreeLevel& level, std::size_t block) const {
    const std::uint16_t alpha = level.alpha_indices[block];
    if (alpha == kPruned) return kPruned;
    const std::uint32_t alpha_tile = level.alpha_codes.first + alpha;
    const std::uint32_t colour_tile = level.colour_codes.first + level.colour_indices[block];
    if (alpha_tile >= count_ || colour_tile >= count_) return kOutside;
    return place(alpha_tile) | place(colour_tile) << 16;
  }

 private:
  std::uint32_t place(std::uint32_t tile) const { return tile % across_ | tile / across_ << 7; }

  std::uint32_t across_, count_;
};

void append_level(const TreeModel& model, const TreeLevel& level, std::uint32_t first_cell,
                  Blocks& blocks) {
  const double cell_m = cell_size_m(model, level.level);
  blocks.levels.push_back({first_cell, next_index(blocks.pairs), next_index(blocks.views),
                           std::uint32_t(level.views.size()), level.level, level.texels,
                           float(cell_m), float(0.5 * cell_m * double(level.side_factor))});
  for (const std::uint32_t view : level.views)
    blocks.views.push_back(
        glm::vec4(glm::vec3(model.view_positions[view] - cube_middle(model)), 0.0f));
  for (const std::uint64_t cell : level.cells) blocks.cells.push_back(packed_cell(cell));
  const TilePlaces places(model.atlas);
  for (std::size_t block = 0; block < level.alpha_indices.size(); ++block)
    blocks.pairs.push_back(places.pair(level, block));
}

// Upper side of the highest cell above the foot of the trunk.
double top_m(const TreeModel& model) {
  double top = 0.0;
  for (const TreeLevel& level : model.levels)
    for (const std::uint64_t cell : level.cells)
      top = std::max(top, cell_centre_in_world(model, level.level, cell).z +
                              0.5 * cell_size_m(model, level.level));
  return top;
}

void append_tree(const PreparedTree& tree, std::uint32_t layer, Blocks& blocks) {
  const TreeModel& model = tree.model();
  const double top = top_m(model);
  const auto first_level = next_index(blocks.levels);
  const auto first_cell = next_index(blocks.cells);
  const auto first_order = next_index(blocks.order_table);
  blocks.trees.push_back({first_level, std::uint32_t(model.levels.size()), first_order, layer,
                          float(-0.5 * model.size_m), float(cube_middle(model).z),
                          top > 0.0 ? float(1.0 / top) : 0.0f, tree.finest_level()});
  for (const TreeLevel& level : model.levels)
    append_level(model, level, next_index(blocks.cells), blocks);
  for (const std::uint32_t cell : tree.order_table())
    blocks.order_table.push_back(first_cell + cell);
}

template <class T>
FixedBuffer upload(const std::vector<T>& data) {
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  const std::size_t bytes = data.size() * sizeof(T);
  if (bytes > std::size_t(most))
    throw Error("the trees need a buffer of " + std::to_string(bytes >> 20) +
                    " MiB and this OpenGL allows " + std::to_string(most >> 20) +
                    " MiB; draw fewer or smaller trees",
                ErrorKind::resource);
  return make_buffer(data);
}

bool has_s3tc() {
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const auto* name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, GLuint(i)));
    if (name && std::strcmp(name, "GL_EXT_texture_compression_s3tc") == 0) return true;
  }
  return false;
}

bool has_whole_bc3(const CodeAtlas& atlas) {
  return atlas.bc3.size() == std::size_t(atlas.width_px) * std::size_t(atlas.height_px);
}

bool draws_on_cpu() {
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (!renderer) return false;
  const std::string_view name(renderer);
  return name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos ||
         name.find("SWR") != name.npos;
}

bool want_bc3(const Trees& trees, AtlasTexels texels) {
  if (texels == AtlasTexels::plain || !has_s3tc()) return false;
  if (texels == AtlasTexels::automatic && draws_on_cpu()) return false;
  return std::all_of(trees.begin(), trees.end(),
                     [](const auto& tree) { return has_whole_bc3(tree->model().atlas); });
}

// An array of pages, one a tree; each holds an atlas in its corner.
GLsizei start_atlas(const Trees& trees, GLenum format, const glm::ivec2& page_px, GpuTrees& gpu) {
  GLint most_layers = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most_layers);
  if (trees.size() > std::size_t(most_layers))
    throw Error("a forest of " + std::to_string(trees.size()) +
                " different trees is more than this OpenGL draws: at most " +
                std::to_string(most_layers));
  const auto layers = GLsizei(std::max<std::size_t>(trees.size(), 1));
  gpu.atlas = GlObject(GlObject::Kind::texture_array);
  glTextureStorage3D(gpu.atlas.name(), 1, format, page_px.x, page_px.y, layers);
  glTextureParameteri(gpu.atlas.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(gpu.atlas.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return layers;
}

// Of the largest atlas, in tiles.
glm::ivec2 page_tiles(const Trees& trees) {
  glm::ivec2 page(1);
  for (const auto& tree : trees)
    page = glm::max(
        page, glm::ivec2(tree->model().atlas.width_px / 4, tree->model().atlas.height_px / 4));
  return page;
}

void upload_bc3(const Trees& trees, GpuTrees& gpu) {
  const glm::ivec2 page_px = 4 * page_tiles(trees);
  const GLsizei layers = start_atlas(trees, kDxt5, page_px, gpu);
  for (std::size_t layer = 0; layer < trees.size(); ++layer) {
    const CodeAtlas& atlas = trees[layer]->model().atlas;
    if (!atlas.bc3.empty())
      glCompressedTextureSubImage3D(gpu.atlas.name(), 0, 0, 0, GLint(layer), atlas.width_px,
                                    atlas.height_px, 1, kDxt5, GLsizei(atlas.bc3.size()),
                                    atlas.bc3.data());
  }
  gpu.atlas_bytes = std::size_t(page_px.x * page_px.y) * std::size_t(layers);
}

// Each tile's 16 alphas, reds, greens and blues, row by row.
std::vector<std::uint8_t> sorted_by_channel(const CodeAtlas& atlas) {
  const auto width = std::size_t(atlas.width_px), height = std::size_t(atlas.height_px);
  std::vector<std::uint8_t> tiles(4 * width * height);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const glm::u8vec4 texel = atlas.rgba[y * width + x];
      std::uint8_t* tile = &tiles[64 * (y / 4 * (width / 4) + x / 4) + y % 4 * 4 + x % 4];
      tile[0] = texel.a;
      tile[16] = texel.r;
      tile[32] = texel.g;
      tile[48] = texel.b;
    }
  }
  return tiles;
}

void upload_plain(const Trees& trees, GpuTrees& gpu) {
  const glm::ivec2 page_px = glm::ivec2(4, 1) * page_tiles(trees);
  const GLsizei layers = start_atlas(trees, GL_RGBA32UI, page_px, gpu);
  for (std::size_t layer = 0; layer < trees.size(); ++layer) {
    const CodeAtlas& atlas = trees[layer]->model().atlas;
    if (!atlas.rgba.empty())
      glTextureSubImage3D(gpu.atlas.name(), 0, 0, 0, GLint(layer), atlas.width_px,
                          atlas.height_px / 4, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                          sorted_by_channel(atlas).data());
  }
  gpu.atlas_bytes = 16 * std::size_t(page_px.x * page_px.y) * std::size_t(layers);
}

}  // namespace

glm::dvec3 cube_middle(const TreeModel& model) { return model.origin + 0.5 * model.size_m; }

GpuTrees upload_trees(const Trees& trees, AtlasTexels texels) {
  Blocks blocks;
  for (std::size_t tree = 0; tree < trees.size(); ++tree)
    append_tree(*trees[tree], std::uint32_t(tree), blocks);
  GpuTrees gpu;
  gpu.trees = upload(blocks.trees);
  gpu.levels = upload(blocks.levels);
  gpu.order_table = upload(blocks.order_table);
  gpu.cells = upload(blocks.cells);
  gpu.views = upload(blocks.views);
  gpu.pairs = upload(blocks.pairs);
  gpu.bc3 = want_bc3(trees, texels);
  if (gpu.bc3)
    upload_bc3(trees, gpu);
  else
    upload_plain(trees, gpu);
  check_gl("uploading trees");
  return gpu;
}

}  // namespace bosk
