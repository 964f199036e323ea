#include "ui/forest_picture.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <chrono>

#include "core/image/image_io.h"
#include "core/render/reference.h"

namespace bosk {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

ForestLook look_of(const ViewOptions& options, double wind_time_s) {
  ForestLook look;
  look.blend = blend_rule(options.blend);
  look.wind_m = options.wind_m;
  look.wind_time_s = wind_time_s;
  using Colours = ForestLook::Colours;
  if (options.colours == "levels") look.colours = Colours::levels;
  if (options.colours == "cells") look.colours = Colours::cells;
  if (options.colours == "pruned") look.colours = Colours::pruned;
  return look;
}

void fill_memory(FrameFigures& figures, const ForestRenderer::Memory& memory) {
  figures.texture_bytes = memory.atlases;
  figures.index_bytes = memory.indices;
  figures.cell_bytes = memory.cells;
  figures.frame_bytes = memory.frame;
}

}  // namespace

ForestPicture::ForestPicture(const ForestScene& scene, std::string driver,
                             OffscreenTarget::Precision precision)
    : scene_(scene),
      driver_(std::move(driver)),
      precision_(precision),
      scenery_(ground_points(scene)),
      renderer_(scene.forest) {}

void ForestPicture::resize(const Lens& lens) {
  if (target_ && target_->width_px() == lens.width_px && target_->height_px() == lens.height_px) {
    return;
  }
  target_.reset();
  target_.emplace(lens.width_px, lens.height_px, precision_);
}

FrameFigures ForestPicture::draw(const Camera& camera, const ViewOptions& options,
                                 std::uint64_t budget, double wind_time_s) {
  FrameFigures figures;
  const auto start = Clock::now();
  scene_.forest.draw_list(viewpoint_of(camera), draw_options(options, half_angle_of(camera)),
                          budget, list_);
  figures.list_ms = ms_since(start);
  resize(camera.lens);
  target_->bind();
  target_->clear(glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
  SceneryLook surroundings;
  // Haze that softens the ground's edge
  surroundings.visibility_m = ground_grid(scene_.terrain, scene_.radius_m).reach_m / 2.0;
  scenery_.draw(camera, surroundings);
  scenery_.draw_shadows(scene_.forest, camera, surroundings);
  glFinish();
  figures.scenery_ms = ms_since(start) - figures.list_ms;
  renderer_.draw(list_, camera, look_of(options, wind_time_s));
  glFinish();
  figures.picture_ms = ms_since(start);
  figures.trees_ms = figures.picture_ms - figures.scenery_ms;

  figures.billboards = list_.billboards;
  figures.by_level = list_.by_level;
  figures.ranges = list_.ranges.size();
  figures.instances = scene_.forest.instances().size();
  figures.instances_drawn = list_.instances.size();
  figures.budget = budget;
  figures.detail = list_.detail;
  figures.overdraw = overdraw_estimate(scene_.forest, list_, camera);
  figures.bc3 = renderer_.uses_bc3();
  figures.driver = driver_;
  fill_memory(figures, renderer_.memory());
  return figures;
}

Image<glm::u8vec3> ForestPicture::read() const {
  const Image<glm::vec4> drawn = target_->read();
  Image<glm::u8vec3> picture(drawn.width(), drawn.height());
  std::transform(drawn.pixels().begin(), drawn.pixels().end(), picture.pixels().begin(),
                 [](const glm::vec4& v) {
                   return glm::u8vec3(byte_from_unit(v.r), byte_from_unit(v.g),
                                      byte_from_unit(v.b));
                 });
  return picture;
}

void ForestPicture::show(unsigned framebuffer) const {
  const int width = target_->width_px(), height = target_->height_px();
  glBlitNamedFramebuffer(target_->framebuffer(), framebuffer, 0, 0, width, height, 0, 0, width,
                         height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace bosk
