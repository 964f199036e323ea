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

struct ForestDrawList {
  std::vector<DrawRange> ranges;         // back to front
  std::vector<std::uint32_t> instances;  // that may be seen, back to front
  std::uint64_t billboards = 0;          // sum of the ranges' counts
  std::vector<std::uint64_t> by_level;   // the same by octree level
  double detail = 1.0;                   // DrawOptions::detail as the budget left it
};

// Trees and where they stand, prepared for drawing from any eye.
class Forest {
 public:
  // Throws Error for an instance of a tree that there is not, a scale that is not
  // above 0, or a place or turn that is not finite.
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
  friend class GroveWalk;
  // A stand of trees, parted by a vertical plane unless it is one tree (or trees in one place).
  struct Grove {
    std::uint32_t first = 0, last = 0;  // into by_place_
    std::int32_t low = -1, high = -1;   // groves on both sides of the plane
    int axis = 0;
    double plane = 0.0;
    glm::dvec3 lower{0.0}, upper{0.0};  // box of the crowns
  };
  struct Stand {             // an instance made ready
    glm::dvec3 centre{0.0};  // of the crown's box, world frame
    double radius = 0.0, cosine = 1.0, sine = 0.0;
  };
  std::int32_t add_grove(std::uint32_t first, std::uint32_t last);
  double affordable_detail(const Viewpoint& viewpoint, const DrawOptions& options,
                           std::uint64_t budget, const std::vector<std::uint32_t>& instances) const;

  std::vector<std::shared_ptr<const PreparedTree>> trees_;
  std::vector<TreeInstance> instances_;
  std::vector<Stand> stands_;
  std::vector<std::uint32_t> by_place_;
  std::vector<Grove> groves_;
};

}  // namespace bosk
