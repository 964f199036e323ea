#include "core/render/gl/scenery_renderer.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/render/gl/crown_shadow.h"
#include "core/render/gl/gl_camera.h"
#include "core/render/gl/gl_object.h"
#include "core/render/gl/program.h"

namespace bosk {
namespace {

// shaders/scenery.glsl
struct SceneryBlock {
  glm::mat4 clip_from_ground;
  glm::vec4 world_from_camera[3];
  glm::vec4 lens, picture_px, eye, to_sun, zenith, horizon, ground;
  glm::ivec4 grid;
};
static_assert(sizeof(SceneryBlock) == 240);

struct GroundPoint {  // ground.vert
  glm::vec4 place, normal;
};

struct ShadowBlock {  // shadow.frag
  glm::vec4 across, down, along;
  glm::ivec4 layer;
};

constexpr int kMapSide_px = 128;
// Trees cast the shadow that they have at the nearest of so many turns.
constexpr int kTurns = 8;
constexpr double kLowestSun = 0.1;  // sine of its height; lower, shadows would have no end

glm::dvec3 turned(const glm::dvec3& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

glm::dvec3 sun_of(const SceneryLook& look) {
  glm::dvec3 sun = glm::normalize(look.to_sun);
  sun.z = std::max(sun.z, kLowestSun);
  return glm::normalize(sun);
}

glm::vec3 normal_at(const Image<glm::vec3>& grid, int x, int y) {
  const int right = std::min(x + 1, grid.width() - 1), left = std::max(x - 1, 0);
  const int below = std::min(y + 1, grid.height() - 1), above = std::max(y - 1, 0);
  const glm::vec3 normal =
      glm::cross(grid(right, y) - grid(left, y), grid(x, below) - grid(x, above));
  return glm::normalize(normal.z < 0.0f ? -normal : normal);
}

// Meshes of the grid: the first, and how many, across and down.
struct Rectangle {
  glm::ivec2 first{0}, count{0};
};

}  // namespace

struct SceneryRenderer::State {
  glm::ivec2 points{0};
  glm::dvec3 middle{0.0};
  glm::dvec3 corner{0.0};  // first point, from the middle
  glm::dvec2 step{1.0};
  double lowest = 0.0, highest = 0.0;  // from the middle
  FixedBuffer ground;
  GlObject sky, surface, shade, no_vertices;
  StreamBuffer frame, shadow_blocks;
  // Shadows, of what they were made
  GlObject maps;
  std::vector<CrownShadow> shadows;  // [tree][turn], in the turned tree's frame
  std::vector<std::shared_ptr<const PreparedTree>> trees;
  glm::dvec3 sun{0.0};

  void set_ground(const Image<glm::vec3>& grid);
  void write_frame(const Camera& camera, const SceneryLook& look);
  void draw_meshes(const Rectangle& rectangle) const;
  void make_maps(const Forest& forest, const glm::dvec3& to_sun);
  const CrownShadow& shadow_of(const TreeInstance& instance, int& layer) const;
  ShadowBlock shadow_block(const TreeInstance& instance) const;
  Rectangle footprint(const TreeInstance& instance) const;
};

void SceneryRenderer::State::set_ground(const Image<glm::vec3>& grid) {
  points = {grid.width(), grid.height()};
  const glm::dvec3 first = grid(0, 0), last = grid(grid.width() - 1, grid.height() - 1);
  middle = 0.5 * (first + last);
  corner = first - middle;
  step = glm::dvec2(last - first) / glm::dvec2(points - 1);
  lowest = highest = corner.z;
  std::vector<GroundPoint> blocks;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const glm::dvec3 place = glm::dvec3(grid(x, y)) - middle;
      lowest = std::min(lowest, place.z);
      highest = std::max(highest, place.z);
      blocks.push_back({glm::vec4(glm::vec3(place), 1.0f), glm::vec4(normal_at(grid, x, y), 0.0f)});
    }
  }
  ground = make_buffer(blocks);
}

void SceneryRenderer::State::write_frame(const Camera& camera, const SceneryLook& look) {
  const RigidTransform& camera_from_world = camera.camera_from_world;
  const RigidTransform camera_from_ground =
      camera_from_world * RigidTransform{glm::dmat3(1.0), middle};
  glm::dmat4 matrix(camera_from_ground.rotation);
  matrix[3] = glm::dvec4(camera_from_ground.translation, 1.0);
  SceneryBlock block{};
  block.clip_from_ground = gl_clip_from_camera(camera.lens) * matrix;
  for (int row = 0; row < 3; ++row)  // the inverse rotation's rows are the rotation's columns
    block.world_from_camera[row] = glm::vec4(glm::vec3(camera_from_world.rotation[row]), 0.0f);
  block.lens = glm::dvec4(camera.lens.focal_px, camera.lens.principal_px);
  block.picture_px = glm::vec4(camera.lens.width_px, camera.lens.height_px, 0, 0);
  block.eye = glm::dvec4(camera.centre_in_world() - middle, look.visibility_m);
  block.to_sun = glm::dvec4(sun_of(look), look.shade);
  block.zenith = glm::vec4(look.zenith, 1.0f);
  block.horizon = glm::vec4(look.horizon, 1.0f);
  block.ground = glm::vec4(look.ground, 1.0f);
  block.grid = glm::ivec4(points, 0, 0);
  frame.write(std::as_bytes(std::span(&block, 1)));
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame.name());
  glBindVertexArray(no_vertices.name());
  glViewport(0, 0, camera.lens.width_px, camera.lens.height_px);
  glDisable(GL_CULL_FACE);
}

void SceneryRenderer::State::draw_meshes(const Rectangle& rectangle) const {
  if (rectangle.count.x <= 0 || rectangle.count.y <= 0) return;
  glUniform4i(0, rectangle.first.x, rectangle.first.y, rectangle.count.x, rectangle.count.y);
  glDrawArrays(GL_TRIANGLES, 0, 6 * rectangle.count.x * rectangle.count.y);
}

void SceneryRenderer::State::make_maps(const Forest& forest, const glm::dvec3& to_sun) {
  if (trees == forest.trees() && sun == to_sun) return;
  trees = forest.trees();
  sun = to_sun;
  shadows.clear();
  maps = GlObject(GlObject::Kind::texture_array);
  const GLuint texture = maps.name();
  const auto layers = GLsizei(std::max<std::size_t>(trees.size() * kTurns, 1));
  glTextureStorage3D(texture, 1, GL_R8, kMapSide_px, kMapSide_px, layers);
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  for (const auto& tree : trees) {
    for (int turn = 0; turn < kTurns; ++turn) {
      const double angle = 2.0 * std::numbers::pi * turn / kTurns;
      CrownShadow shadow = crown_shadow(tree->model(), turned(to_sun, -angle), kMapSide_px);
      glTextureSubImage3D(texture, 0, 0, 0, GLint(shadows.size()), kMapSide_px, kMapSide_px, 1,
                          GL_RED, GL_FLOAT, shadow.transmittance.data());
      shadow.centre = turned(shadow.centre, angle);
      shadow.across = turned(shadow.across, angle);
      shadow.down = turned(shadow.down, angle);
      shadow.transmittance = {};
      shadows.push_back(std::move(shadow));
    }
  }
}

const CrownShadow& SceneryRenderer::State::shadow_of(const TreeInstance& instance,
                                                     int& layer) const {
  const double turns = instance.turn / (2.0 * std::numbers::pi) * kTurns;
  const int turn = (int(std::lround(std::remainder(turns, kTurns))) + kTurns) % kTurns;
  layer = int(instance.tree) * kTurns + turn;
  return shadows[std::size_t(layer)];
}

ShadowBlock SceneryRenderer::State::shadow_block(const TreeInstance& instance) const {
  int layer = 0;
  const CrownShadow& shadow = shadow_of(instance, layer);
  const double radius = shadow.radius_m * instance.scale;
  const glm::dvec3 centre = instance.place + instance.scale * shadow.centre - middle;
  const auto plane = [&](const glm::dvec3& axis, double scale, double shift) {
    return glm::vec4(glm::dvec4(axis * scale, shift - glm::dot(axis * scale, centre)));
  };
  return {plane(shadow.across, 0.5 / radius, 0.5), plane(shadow.down, 0.5 / radius, 0.5),
          plane(sun, 1.0 / radius, 0.0), glm::ivec4(layer, 0, 0, 0)};
}

// Meshes that the shadow of the crown's sphere can fall on, from the highest ground to the lowest.
Rectangle SceneryRenderer::State::footprint(const TreeInstance& instance) const {
  int layer = 0;
  const CrownShadow& shadow = shadow_of(instance, layer);
  const double radius = shadow.radius_m * instance.scale;
  const glm::dvec3 centre = instance.place + instance.scale * shadow.centre - middle;
  glm::dvec2 low(1e300), high(-1e300);
  for (const double height : {lowest, highest}) {
    const glm::dvec2 at = glm::dvec2(centre) - glm::dvec2(sun) * ((centre.z - height) / sun.z);
    low = glm::min(low, at - radius / sun.z);
    high = glm::max(high, at + radius / sun.z);
  }
  const glm::dvec2 a = (low - glm::dvec2(corner)) / step, b = (high - glm::dvec2(corner)) / step;
  const glm::dvec2 most(points - 1);
  Rectangle rectangle;
  rectangle.first = glm::ivec2(glm::floor(glm::clamp(glm::min(a, b), glm::dvec2(0.0), most)));
  rectangle.count =
      glm::ivec2(glm::ceil(glm::clamp(glm::max(a, b), glm::dvec2(0.0), most))) - rectangle.first;
  return rectangle;
}

SceneryRenderer::SceneryRenderer(const Image<glm::vec3>& ground) {
  require_gl_context();
  state_ = std::make_unique<State>();
  state_->sky = make_program({"sky.vert", "sky.frag"});
  state_->surface = make_program({"ground.vert", "ground.frag"});
  state_->shade = make_program({"ground.vert", "shadow.frag"});
  state_->no_vertices = GlObject(GlObject::Kind::vertex_array);
  if (ground.width() >= 2 && ground.height() >= 2) state_->set_ground(ground);
  check_gl("preparing the ground");
}

SceneryRenderer::~SceneryRenderer() = default;

void SceneryRenderer::draw(const Camera& camera, const SceneryLook& look) {
  require_gl_context();
  if (camera.lens.width_px <= 0 || camera.lens.height_px <= 0) return;
  state_->write_frame(camera, look);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(state_->sky.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  if (state_->ground.object) {
    glUseProgram(state_->surface.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, state_->ground.object.name());
    state_->draw_meshes({glm::ivec2(0), state_->points - 1});
  }
  glDisable(GL_DEPTH_TEST);
  check_gl("drawing the ground");
}

void SceneryRenderer::draw_shadows(const Forest& forest, const Camera& camera,
                                   const SceneryLook& look) {
  require_gl_context();
  if (camera.lens.width_px <= 0 || camera.lens.height_px <= 0) return;
  if (!state_->ground.object || forest.instances().empty()) return;
  state_->make_maps(forest, sun_of(look));
  std::vector<ShadowBlock> blocks;
  for (const TreeInstance& instance : forest.instances())
    blocks.push_back(state_->shadow_block(instance));
  state_->shadow_blocks.write(blocks);
  state_->write_frame(camera, look);
  glUseProgram(state_->shade.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, state_->ground.object.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, state_->shadow_blocks.name());
  glBindTextureUnit(0, state_->maps.name());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    glUniform1i(1, GLint(i));
    state_->draw_meshes(state_->footprint(forest.instances()[i]));
  }
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  check_gl("drawing shadows");
}

}  // namespace bosk
