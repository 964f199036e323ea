#pragma once

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
  enum class Colours { tree, levels, cells, pruned } colours = Colours::tree;
};

// Draws forests through OpenGL 4.5: each list is one dispatch that turns cells into billboards on
// the screen and one indirect draw of all of them, in the list's order. Owns the trees' buffers and
// atlases. Needs a current context during every call, the destructor included.
class ForestRenderer {
 public:
  // Uploads each tree once. Throws Error, with what to do, when the context is older than 4.5 or a
  // tree does not fit its buffers. Atlases are BC3 where the driver has S3TC, else RGBA8.
  explicit ForestRenderer(const Forest& forest);
  ~ForestRenderer();
  ForestRenderer(const ForestRenderer&) = delete;
  ForestRenderer& operator=(const ForestRenderer&) = delete;

  // Composites the list over the bound framebuffer, premultiplied and sRGB-encoded (its colour
  // buffer should be RGBA16F: 8 bits lose faint billboards), behind what its depth buffer holds;
  // depth is not written. The picture has the camera's size and lens.
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
