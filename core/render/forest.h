#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/render/draw_list.h"

namespace bosk {

// One tree of a forest: turned about +z through its own origin, scaled, moved.
struct TreeInstance {
  std::uint32_t tree = 0;  // into Forest::trees()
  glm::dvec3 place{0.0};   // of the tree's origin, world frame
  double turn = 0.0;       // radians, from +x towards +y
  double scale = 1.0;      // above 0
  glm::vec3 tint{1.0f};    // its sRGB-encoded colours are multiplied by it
};

glm::dvec3 tree_from_world(const TreeInstance& instance, const glm::dvec3& point_in_world);
glm::dvec3 world_from_tree(const TreeInstance& instance, const glm::dvec3& point_in_tree);
// The viewpoint as the instance's own tree sees it: lengths are divided by its scale.
Viewpoint viewpoint_in_tree(const TreeInstance& instance, const Viewpoint& viewpoint_in_world);

struct ForestDrawList {
  std::vector<DrawRange> ranges;         // back to front
  std::vector<std::uint32_t> instances;  // that are drawn, back to front
  std::uint64_t billboards = 0;          // sum of the ranges' counts
  std::vector<std::uint64_t> by_level;   // the same by octree level
  double detail = 1.0;                   // that the budget left of DrawOptions::detail
};

// Trees and where they stand, prepared for drawing from any eye.
class Forest {
 public:
  // Throws std::invalid_argument for an instance of a tree that there is not, or a scale that is
  // not above 0.
  Forest(std::vector<std::shared_ptr<const PreparedTree>> trees,
         std::vector<TreeInstance> instances);

  const std::vector<std::shared_ptr<const PreparedTree>>& trees() const { return trees_; }
  const std::vector<TreeInstance>& instances() const { return instances_; }

  // Trees back to front, each exact in itself. Between trees the order is that of vertical planes
  // midway between their trunks: exact where crowns do not reach across. `budget` bounds the
  // billboards, about, by lowering the detail of all trees alike (0: no bound). Nothing is sorted;
  // `list` keeps its memory from frame to frame.
  void draw_list(const Viewpoint& viewpoint, const DrawOptions& options, std::uint64_t budget,
                 ForestDrawList& list) const;

 private:
  struct Node;  // of a tree of planes over the instances' places
  std::vector<std::shared_ptr<const PreparedTree>> trees_;
  std::vector<TreeInstance> instances_;
  std::vector<Node> nodes_;
};

}  // namespace bosk
