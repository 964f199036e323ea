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
  std::uint64_t billboards = 0;          // cells of the ranges, each once
  std::vector<std::uint64_t> by_level;   // the same by octree level
  double detail = 1.0;                   // DrawOptions::detail as the budget left it

  // Working memory, kept from frame to frame
  std::vector<std::uint64_t> keys, spare_keys;
  std::vector<std::uint32_t> depths;  // how many trees of each kind at about each depth
};

// Trees and where they stand, prepared for drawing from any eye.
class Forest {
 public:
  // Throws Error for an instance of a tree that there is not, a scale that is not above 0, or a
  // place or turn that is not finite.
  Forest(std::vector<std::shared_ptr<const PreparedTree>> trees,
         std::vector<TreeInstance> instances);

  const std::vector<std::shared_ptr<const PreparedTree>>& trees() const { return trees_; }
  const std::vector<TreeInstance>& instances() const { return instances_; }

  // Trees back to front, each exact in itself. Trees are taken as upright cylinders around their
  // crowns and ordered by their power to the eye, horizontal distance^2 - radius^2: that is on
  // which side of the plane between two disjoint cylinders the eye lies (Aurenhammer 1987, "Power
  // diagrams"), so it is exact where crowns do not meet. `budget` bounds the billboards, to a
  // tenth, by lowering the detail of all trees alike down to a 1024th (0: no bound). Takes time
  // linear in the number of instances; `list` keeps its memory from frame to frame.
  void draw_list(const Viewpoint& viewpoint, const DrawOptions& options, std::uint64_t budget,
                 ForestDrawList& list) const;

 private:
  struct Stand {             // an instance made ready
    glm::dvec3 centre{0.0};  // of the crown's box, world frame
    double reach_m = 0.0;    // of the crown and its billboards from there
    double crown_radius_m = 0.0;
    glm::dvec3 place{0.0};  // from here on as in TreeInstance
    double scale = 1.0;
    double cosine = 1.0, sine = 0.0;  // of its turn
    std::uint32_t tree = 0;
  };
  void list_instances(const Viewpoint& viewpoint, double half_angle, ForestDrawList& list) const;
  void list_ranges(const Viewpoint& viewpoint, const DrawOptions& options, double detail,
                   ForestDrawList& list) const;
  double affordable_detail(const Viewpoint& viewpoint, const DrawOptions& options,
                           std::uint64_t budget, const ForestDrawList& list) const;

  std::vector<std::shared_ptr<const PreparedTree>> trees_;
  std::vector<TreeInstance> instances_;
  std::vector<Stand> stands_;
  double largest_radius_m_ = 0.0;
};

}  // namespace bosk
