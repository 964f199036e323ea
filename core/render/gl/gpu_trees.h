#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/render/gl/forest_renderer.h"
#include "core/render/gl/gl_object.h"
#include "core/render/prepared_tree.h"

namespace bosk {

// shaders/tree.glsl and pairs.glsl: all trees' buffers, one after the other. Coordinates are floats
// from the middle of each tree's cube.
struct GpuTrees {
  FixedBuffer trees, levels, order_table, cells, views, pairs;
  GlObject
      atlas;  // one layer a tree: BC3, or RGBA8 sorted by channel within tiles (billboard.frag)
  std::size_t atlas_bytes = 0;
  bool bc3 = false;
};

// The middle of the octree's cube, tree frame: what floats on the GPU count from.
glm::dvec3 cube_middle(const TreeModel& model);

// Throws Error when a tree does not fit the driver's buffers.
GpuTrees upload_trees(const std::vector<std::shared_ptr<const PreparedTree>>& trees,
                      AtlasTexels texels);

}  // namespace bosk
