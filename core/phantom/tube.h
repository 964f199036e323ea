#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace bosk {

struct TubePoint {
  glm::dvec3 position{0.0};
  double radius = 0.0;
};

struct TubeMesh {
  std::vector<glm::vec3> vertices, normals, anchors;  // anchor: the point of the axis
  std::vector<glm::uvec3> triangles;                  // front side outwards
};

// Appends the tube along the line (two points or more), open where it starts, pointed where it
// ends. Thick tubes get more sides: 3 to 14.
void add_tube(const std::vector<TubePoint>& line, TubeMesh& mesh);

}  // namespace bosk
