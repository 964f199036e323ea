#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "core/image/image.h"
#include "core/render/code_texture.h"
#include "core/render/draw_list.h"
#include "core/render/reference.h"
#include "core/render/splat.h"
#include "tests/render/toy_trees.h"

namespace bosk::toy {

// The texture at (u, v) in texels: linear between texel centres, held beyond the outer ones,
// nothing outside the square.
inline glm::dvec4 texture_at(const std::vector<Float4>& texture, int texels, double u, double v) {
  if (!(u >= 0.0 && u < texels && v >= 0.0 && v < texels)) return glm::dvec4(0.0);
  const double x = std::clamp(u - 0.5, 0.0, texels - 1.0),
               y = std::clamp(v - 0.5, 0.0, texels - 1.0);
  const int i = std::min(int(x), texels - 2), j = std::min(int(y), texels - 2);
  const auto texel = [&](int row, int column) {
    const Float4 t = texture[std::size_t(row) * std::size_t(texels) + std::size_t(column)];
    return glm::dvec4(t[0], t[1], t[2], t[3]);
  };
  return glm::mix(glm::mix(texel(j, i), texel(j, i + 1), x - i),
                  glm::mix(texel(j + 1, i), texel(j + 1, i + 1), x - i), y - j);
}

// Plain loops: the mean over a pixel's area of samples x samples point samples, composited over.
inline void slow_splat(const Splat& splat, const std::vector<Float4>& texture, int texels,
                       int samples, Image<glm::vec4>& image) {
  const glm::dmat2 pixel_from_square(glm::dvec2(splat.across_px), glm::dvec2(splat.down_px));
  const glm::dmat2 square_from_pixel = glm::inverse(pixel_from_square);
  const glm::vec2 reach = half_extent_px(splat) + 1.0f;
  const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(splat.centre_px - reach)), 0);
  const glm::ivec2 last = glm::min(glm::ivec2(glm::ceil(splat.centre_px + reach)),
                                   glm::ivec2(image.width() - 1, image.height() - 1));
  for (int y = first.y; y <= last.y; ++y)
    for (int x = first.x; x <= last.x; ++x) {
      glm::dvec4 sum(0.0);
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
          const glm::dvec2 at(x - 0.5 + (i + 0.5) / samples, y - 0.5 + (j + 0.5) / samples);
          const glm::dvec2 st = square_from_pixel * (at - glm::dvec2(splat.centre_px));
          sum +=
              texture_at(texture, texels, 0.5 * texels * (st.x + 1.0), 0.5 * texels * (st.y + 1.0));
        }
      const glm::vec4 mean(sum / double(samples * samples));
      image(x, y) = mean + (1.0f - mean.a) * image(x, y);
    }
}

// One level of the tree, premultiplied. The squares' edges go through the lens themselves, so that
// the renderer's local affine map is judged too.
inline Image<glm::vec4> slow_render(const TreeModel& model, const Camera& camera, int only_level) {
  Image<glm::vec4> image(camera.lens.width_px, camera.lens.height_px, glm::vec4(0.0f));
  DrawOptions options;
  options.only_level = only_level;
  const TileTexels tiles = exact_tiles(model.atlas);
  const PreparedTree tree(model);
  const Viewpoint viewpoint = viewpoint_of(camera);
  for (const DrawItem& item : draw_items(tree, make_draw_list(tree, viewpoint, options),
                                         viewpoint.eye, BlendRule::fading)) {
    const TreeLevel& level = model.levels[item.level_slot];
    const glm::dvec3 centre = cell_centre_in_world(model, level.level, level.cells[item.cell]);
    const BillboardAxes axes = billboard_axes(centre, camera.centre_in_world());
    const double half_m = 0.5 * cell_size_m(model, level.level) * double(level.side_factor);
    const glm::dvec2 middle = project(camera, centre).value();
    const glm::dvec2 right = project(camera, centre + half_m * axes.right).value();
    const glm::dvec2 left = project(camera, centre - half_m * axes.right).value();
    const glm::dvec2 top = project(camera, centre + half_m * axes.up).value();
    const glm::dvec2 bottom = project(camera, centre - half_m * axes.up).value();
    std::vector<Float4> texture(std::size_t(level.texels * level.texels));
    decode_item(model, tiles, item, texture.data());
    slow_splat({middle, 0.5 * (right - left), 0.5 * (bottom - top), 0}, texture, level.texels, 8,
               image);
  }
  return image;
}

}  // namespace bosk::toy
