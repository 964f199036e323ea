#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "core/image/image.h"
#include "core/photo/camera.h"
#include "core/render/forest.h"

namespace bosk {

// Light and colours of sky and ground; sRGB-encoded.
struct SceneryLook {
  glm::dvec3 to_sun{0.45, -0.55, 0.7};  // world frame, any length, above the horizon
  glm::vec3 zenith{0.33f, 0.53f, 0.80f}, horizon{0.80f, 0.88f, 0.94f};
  glm::vec3 ground{0.40f, 0.45f, 0.24f};
  double shade = 0.4;           // share of the light that comes from the sky: full shadow keeps it
  double visibility_m = 600.0;  // haze takes all but 1/e of the ground's contrast there
};

// What trees stand in: sky, ground and the shade of crowns on it, drawn through OpenGL 4.5 in that
// order and before the trees. The lens's distortion is left out. Needs a current context during
// every call, the destructor included.
class SceneryRenderer {
 public:
  // `ground`: points of a grid, world frame; x is the same down each column and grows to the right,
  // y along each row and grows or falls downwards, both in even steps. Less than 2 x 2 points: no
  // ground.
  explicit SceneryRenderer(const Image<glm::vec3>& ground);
  ~SceneryRenderer();
  SceneryRenderer(const SceneryRenderer&) = delete;
  SceneryRenderer& operator=(const SceneryRenderer&) = delete;

  // Sky over the whole picture, depth untouched; then the ground, which writes depth (gl_camera.h).
  // Opaque; over the bound framebuffer, the camera's size becomes the viewport.
  void draw(const Camera& camera, const SceneryLook& look);

  // Darkens the ground where crowns of the forest stand in the sun. Maps of transmittance are made
  // on the CPU when trees or sun change: 10 to 50 ms a tree. Where several crowns shade a place,
  // the sky's share of the light is weakened too.
  void draw_shadows(const Forest& forest, const Camera& camera, const SceneryLook& look);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bosk
