#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

namespace bosk {

struct RayHit {
  static constexpr std::uint32_t kMiss = 0xffffffff;
  std::uint32_t triangle = kMiss;
  std::uint32_t copy = 0;  // which copy of the mesh, where there are several
  float distance = 0.0f, u = 0.0f, v = 0.0f;
  glm::vec3 normal{0.0f};  // geometric, of the side that the triangle's order makes the front

  explicit operator bool() const { return triangle != kMiss; }
};

// Eight rays from one point, traced together: they should point nearly the same way.
constexpr int kPacketRays = 8;
using PacketDirections = std::array<glm::vec3, kPacketRays>;
using PacketHits = std::array<RayHit, kPacketRays>;

// A shift and a scale of a mesh.
struct MeshCopy {
  glm::vec3 shift{0.0f};
  float scale = 1.0f;
};

// Triangles that rays can be shot at, through Embree 3. Directions need not be of unit length:
// distances are in units of them. Shooting is safe from any thread; building uses the calling
// thread alone, so that the answer to a ray never depends on how many threads there are.
class RayScene {
 public:
  RayScene(const std::vector<glm::vec3>& vertices, const std::vector<glm::uvec3>& triangles);
  // Copies of a scene of one mesh; keeps it alive.
  RayScene(const RayScene& mesh, const std::vector<MeshCopy>& copies);

  RayHit first_hit(const glm::vec3& origin, const glm::vec3& direction) const;
  PacketHits first_hits(const glm::vec3& origin, const PacketDirections& directions) const;
  bool blocked(const glm::vec3& origin, const glm::vec3& direction, float far = 1e30f) const;

 private:
  struct Handles;
  std::shared_ptr<const Handles> handles_;
};

}  // namespace bosk
