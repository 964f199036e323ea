#include "core/render/gl/forest_renderer.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/render/gl/gl_camera.h"
#include "core/render/gl/gl_object.h"
#include "core/render/gl/gpu_trees.h"
#include "core/render/gl/program.h"

namespace bosk {
namespace {

// shaders/frame.glsl
struct FrameBlock {
  glm::vec2 focal_px, principal_px;
  glm::vec4 distortion_low, distortion_high;
  glm::vec2 picture_px;
  float fold;
  std::int32_t lens_model, blend_rule, colours;
  std::uint32_t range_count, first_cell, cell_count;
  float near_m, wind, widest_focal_px;
};
static_assert(sizeof(FrameBlock) == 96);

// shaders/billboard.comp
struct RangeBlock {
  std::uint32_t start, first, instance, flags;
  float fade;
};
struct InstanceBlock {
  glm::vec4 camera_from_tree[3];
  glm::vec4 eye;
  glm::ivec4 eye_cell;
  glm::vec4 tint, sway;
};
static_assert(sizeof(RangeBlock) == 20 && sizeof(InstanceBlock) == 112);

constexpr std::size_t kRecordBytes = 64;  // shaders/record.glsl
constexpr GLuint kGroupCells = 64;        // local_size_x of billboard.comp
constexpr auto kNotDrawn = std::numeric_limits<std::uint32_t>::max();

struct DrawCommand {
  std::uint32_t vertices, instances, first_vertex, base_instance;
};

std::int32_t lens_model(const Lens& lens) {
  if (is_undistorted(lens)) return 0;
  return lens.model == LensModel::opencv ? 1 : 2;
}

FrameBlock frame_block(const Camera& camera, const ForestLook& look) {
  const Lens& lens = camera.lens;
  FrameBlock frame{};
  frame.focal_px = lens.focal_px;
  frame.principal_px = lens.principal_px;
  for (int i = 0; i < 4; ++i) {
    frame.distortion_low[i] = float(lens.distortion[std::size_t(i)]);
    frame.distortion_high[i] = float(lens.distortion[std::size_t(i) + 4]);
  }
  frame.picture_px = glm::vec2(lens.width_px, lens.height_px);
  frame.fold = float(lens_fold(lens));
  frame.lens_model = lens_model(lens);
  frame.blend_rule = look.blend == BlendRule::fading ? 1 : 0;
  frame.colours = std::int32_t(look.colours);
  frame.near_m = float(kNear_m);
  frame.wind = float(look.wind_m);
  frame.widest_focal_px = float(std::max(lens.focal_px.x, lens.focal_px.y));
  return frame;
}

// Where the wind has moved the top of a tree that stands at `place`: a slow sway, out of step with
// its neighbours. World frame, metres.
glm::dvec3 sway(const ForestLook& look, const glm::dvec3& place) {
  const double phase = 0.31 * place.x + 0.23 * place.y, time = look.wind_time_s;
  const glm::dvec3 direction(0.6 + 0.4 * std::sin(1.3 * time + phase),
                             0.5 * std::sin(0.9 * time + 1.7 * phase), 0.0);
  return look.wind_m * direction;
}

InstanceBlock instance_block(const PreparedTree& tree, const TreeInstance& instance,
                             const Camera& camera, const glm::dvec3& eye_in_world,
                             const ForestLook& look) {
  const double c = std::cos(instance.turn), s = std::sin(instance.turn);
  const glm::dmat3 world_turn(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0);
  const glm::dmat3 turn = camera.camera_from_world.rotation * world_turn;
  const glm::dvec3 middle = cube_middle(tree.model());
  const glm::dvec3 shift =
      (camera.camera_from_world * world_from_tree(instance, middle)) / instance.scale;
  const glm::dvec3 eye = tree_from_world(instance, eye_in_world);
  const glm::dvec3 moved =
      camera.camera_from_world.rotation * sway(look, instance.place) / instance.scale;
  InstanceBlock block{};
  for (int row = 0; row < 3; ++row)
    block.camera_from_tree[row] = glm::dvec4(turn[0][row], turn[1][row], turn[2][row], shift[row]);
  block.eye = glm::vec4(glm::vec3(eye - middle), float(instance.scale));
  block.eye_cell = glm::ivec4(eye_cell(tree, eye), int(instance.tree));
  block.tint = glm::vec4(instance.tint, 1.0f);
  block.sway = glm::vec4(glm::vec3(moved), 0.0f);
  return block;
}

}  // namespace

struct ForestRenderer::State {
  std::vector<std::shared_ptr<const PreparedTree>> trees;
  std::vector<TreeInstance> instances;
  ForestRendererOptions options;
  GpuTrees gpu;
  GlObject expand, paint, no_vertices;
  StreamBuffer frame, ranges, instance_blocks, records, command;
  // Scratch that keeps its memory from frame to frame
  std::vector<std::uint32_t> drawn_as;  // by instance: place among those drawn
  std::vector<RangeBlock> range_blocks;
  std::vector<InstanceBlock> drawn;

  std::uint64_t gather(const ForestDrawList& list, const Camera& camera, const ForestLook& look);
  void bind() const;
  void draw_batch(FrameBlock& block, std::uint32_t first, std::uint32_t count);
};

// Fills range_blocks and drawn; the number of cells in all.
std::uint64_t ForestRenderer::State::gather(const ForestDrawList& list, const Camera& camera,
                                            const ForestLook& look) {
  const glm::dvec3 eye = camera.centre_in_world();
  drawn_as.assign(instances.size(), kNotDrawn);
  range_blocks.clear();
  drawn.clear();
  std::uint64_t cells = 0;
  for (const DrawRange& range : list.ranges) {
    assert(range.instance < instances.size());
    const TreeInstance& instance = instances[range.instance];
    std::uint32_t& place = drawn_as[range.instance];
    if (place == kNotDrawn) {
      place = std::uint32_t(drawn.size());
      drawn.push_back(instance_block(*trees[instance.tree], instance, camera, eye, look));
    }
    const std::uint32_t flags = std::uint32_t(range.backwards) | std::uint32_t(range.split) << 8 |
                                std::uint32_t(range.high) << 16;
    range_blocks.push_back({std::uint32_t(cells), range.first, place, flags, range.fade});
    cells += range.count;
  }
  return std::min<std::uint64_t>(cells, std::numeric_limits<std::uint32_t>::max());
}

void ForestRenderer::State::bind() const {
  const unsigned buffers[] = {
      gpu.trees.object.name(), gpu.levels.object.name(), gpu.order_table.object.name(),
      gpu.cells.object.name(), gpu.views.object.name(),  gpu.pairs.object.name(),
      ranges.name(),           instance_blocks.name(),   records.name()};
  glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, 0, GLsizei(std::size(buffers)), buffers);
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame.name());
  glBindTextureUnit(0, gpu.atlas.name());
  glBindVertexArray(no_vertices.name());
}

void ForestRenderer::State::draw_batch(FrameBlock& block, std::uint32_t first,
                                       std::uint32_t count) {
  block.first_cell = first;
  block.cell_count = count;
  frame.write(std::as_bytes(std::span(&block, 1)));
  const DrawCommand draw{6 * count, 1, 0, 0};
  command.write(std::as_bytes(std::span(&draw, 1)));
  bind();
  glUseProgram(expand.name());
  glDispatchCompute((count + kGroupCells - 1) / kGroupCells, 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  glUseProgram(paint.name());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, command.name());
  glDrawArraysIndirect(GL_TRIANGLES, nullptr);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the next batch writes what this one reads
}

ForestRenderer::ForestRenderer(const Forest& forest, const ForestRendererOptions& options) {
  require_gl_context();
  state_ = std::make_unique<State>();
  state_->trees = forest.trees();
  state_->instances = forest.instances();
  state_->options = options;
  state_->gpu = upload_trees(forest.trees(), options.atlas);
  state_->expand = make_program({"billboard.comp"});
  state_->paint = make_program({"billboard.vert", "billboard.frag"},
                               state_->gpu.bc3 ? "#define BC3_ATLAS 1\n" : "#define BC3_ATLAS 0\n");
  state_->no_vertices = GlObject(GlObject::Kind::vertex_array);
  check_gl("preparing to draw trees");
}

ForestRenderer::~ForestRenderer() = default;

void ForestRenderer::set_instances(const std::vector<TreeInstance>& instances) {
  state_->instances = instances;
}

void ForestRenderer::draw(const ForestDrawList& list, const Camera& camera,
                          const ForestLook& look) {
  require_gl_context();
  if (camera.lens.width_px <= 0 || camera.lens.height_px <= 0) return;
  const std::uint64_t cells = state_->gather(list, camera, look);
  if (cells == 0) return;
  FrameBlock frame = frame_block(camera, look);
  frame.range_count = std::uint32_t(state_->range_blocks.size());
  state_->ranges.write(state_->range_blocks);
  state_->instance_blocks.write(state_->drawn);
  const std::uint64_t batch = std::max(state_->options.batch_billboards, 1u);
  state_->records.reserve(std::size_t(std::min(cells, batch)) * kRecordBytes);

  glViewport(0, 0, camera.lens.width_px, camera.lens.height_px);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  for (std::uint64_t first = 0; first < cells; first += batch)
    state_->draw_batch(frame, std::uint32_t(first), std::uint32_t(std::min(batch, cells - first)));
  glDepthMask(GL_TRUE);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  check_gl("drawing trees");
}

ForestRenderer::Memory ForestRenderer::memory() const {
  const GpuTrees& gpu = state_->gpu;
  return {gpu.atlas_bytes, gpu.pairs.bytes,
          gpu.trees.bytes + gpu.levels.bytes + gpu.order_table.bytes + gpu.cells.bytes +
              gpu.views.bytes,
          state_->frame.bytes() + state_->ranges.bytes() + state_->instance_blocks.bytes() +
              state_->records.bytes() + state_->command.bytes()};
}

bool ForestRenderer::uses_bc3() const { return state_->gpu.bc3; }

}  // namespace bosk
