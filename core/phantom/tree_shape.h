#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace bosk {

enum class LeafKind { lobed, ovate, needle };

// What makes one species of made-up tree: its envelope, how it branches, its leaves. Metres.
struct TreeShape {
  // Crown envelope, a surface of revolution: radius at heights spread evenly from base to top.
  double crown_base = 1.5, height = 9.6;
  std::vector<double> radius_profile;
  double envelope_lumps = 0.3;  // how far noise pushes the envelope in and out, relative

  // Space colonisation
  int attractors = 5000;
  double step = 0.15, influence = 1.6, kill = 0.35;
  double leader_height = 1.5;  // the trunk is given up to here
  double rind = 0.5;           // share of attractors drawn towards the surface of the crown
  glm::dvec3 tropism{0.0, 0.0, 0.1};
  double wobble = 0.2;  // random turn of each step

  // Pipe model
  double pipe_exponent = 2.12, twig_radius = 0.004, trunk_flare = 0.6;

  // Leaves on short shoots along the thin branches
  LeafKind leaf_kind = LeafKind::lobed;
  double leaf_bearing_radius = 0.009;
  double shoots_per_node = 1.15, shoot_length = 0.22, leaf_length = 0.13, leaf_width = 0.085;
  int leaves_per_shoot = 7;
  double leaf_droop = 0.35;

  // Linear RGB
  glm::vec3 bark_albedo{0.11f, 0.085f, 0.065f};
  glm::vec3 leaf_albedo{0.055f, 0.105f, 0.022f};
  glm::vec3 leaf_transmission{0.075f, 0.135f, 0.014f};
};

// `preset`: dense, sparse or conical (Error otherwise). `detail` scales the number of branches and
// leaves, which grow larger in turn so that the crown stays about as closed; 1 is a full tree.
// `height` scales the whole tree; 0 keeps the preset's own.
TreeShape tree_shape(const std::string& preset, double detail, double height);

// Crown radius at a height; 0 outside the crown.
double envelope_radius(const TreeShape& shape, double z);

}  // namespace bosk
