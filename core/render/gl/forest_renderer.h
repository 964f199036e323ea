#pragma once

#include <cstdint>
#include <memory>

#include "core/photo/camera.h"
#include "core/render/forest.h"
#include "core/render/view_blend.h"

namespace bosk {

// How a forest is drawn; none of it changes what is in a draw list.
struct ForestLook {
  BlendRule blend = BlendRule::fading;
  double wind_m = 0.0;  // how far the crown's top sways; 0: still, to the bit
  double wind_time_s = 0.0;
  // levels, cells: one colour for each octree level, each cell. pruned: red where both of a cell's
  // textures were pruned and nothing would be drawn, orange where one of them was.
  enum class Colours { tree, levels, cells, pruned } colours = Colours::tree;
};

enum class AtlasTexels {
  // bc3 on graphics cards, plain on drivers that draw on the CPU, which decode BC3 slowly.
  automatic,
  bc3,    // where the driver has S3TC and every tree its blocks, else plain
  plain,  // RGBA8, exact
};

struct ForestRendererOptions {
  AtlasTexels atlas = AtlasTexels::automatic;
  std::uint32_t batch_billboards = 1u << 20;  // drawn at a time; 64 bytes each
};

// Draws forests through OpenGL 4.5: each list is one dispatch that turns cells into billboards on
// the screen and one indirect draw of all of them, in the list's order (one of each a batch). Owns
// the trees' buffers and atlases. Needs a current context during every call, the destructor
// included.
class ForestRenderer {
 public:
  // Uploads each tree once. Throws Error, with what to do, when the context is missing or older
  // than 4.5, or a tree does not fit its buffers.
  explicit ForestRenderer(const Forest& forest, const ForestRendererOptions& options = {});
  ~ForestRenderer();
  ForestRenderer(const ForestRenderer&) = delete;
  ForestRenderer& operator=(const ForestRenderer&) = delete;

  // The same trees standing elsewhere; nothing is uploaded. Its trees() must be those of the
  // constructor.
  void set_instances(const std::vector<TreeInstance>& instances);

  // Composites the list over the bound framebuffer, premultiplied and sRGB-encoded (its colour
  // buffer should be RGBA16F: 8 bits lose faint billboards), behind what its depth buffer holds
  // (gl_camera.h has the mapping); depth is not written. The picture has the camera's size and
  // lens and becomes the viewport. Leaves blending and the depth test off. Throws Error when the
  // context was lost.
  void draw(const ForestDrawList& list, const Camera& camera, const ForestLook& look);

  // Bytes on the GPU.
  struct Memory {
    std::size_t atlases = 0, indices = 0, cells = 0, frame = 0;
  };
  Memory memory() const;
  bool uses_bc3() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bosk
