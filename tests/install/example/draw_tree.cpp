// draw_tree TREE.bosk PICTURE.ppm: the least that a program does with Bosk's runtime. It loads a
// package, asks what to draw for one eye, and draws each billboard as a square of its mean colour.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <vector>

#include "core/package/reader.h"
#include "core/render/billboard_geometry.h"
#include "core/render/draw_list.h"

namespace {

constexpr int kSize = 256;          // of the picture, pixels
constexpr double kFocalPx = 300.0;  // so it sees 46 degrees

// A camera south of the tree, level with its middle, that looks north.
struct Camera {
  glm::dvec3 eye{0.0};
  // x to the right and y down in pixels, z is the depth.
  glm::dvec3 pixel(const glm::dvec3& point) const {
    const glm::dvec3 away = point - eye;
    return {0.5 * kSize + kFocalPx * away.x / away.y, 0.5 * kSize - kFocalPx * away.z / away.y,
            away.y};
  }
};

// Mean premultiplied colour of one view's texture: colour and alpha codewords are tiles of 4 x 4
// texels in the atlas.
glm::vec4 mean_colour(const bosk::TreeModel& tree, const bosk::DrawItem& item, std::uint32_t view) {
  const bosk::TreeLevel& level = tree.levels[item.level_slot];
  const int blocks = level.texels / 4 * (level.texels / 4);
  const int across = tree.atlas.width_px / 4;
  glm::vec4 sum(0.0f);
  for (int block = 0; block < blocks; ++block) {
    const std::size_t at =
        (item.cell * level.views.size() + view) * std::size_t(blocks) + std::size_t(block);
    if (level.alpha_indices[at] == bosk::kPruned) continue;
    const int alpha = int(level.alpha_codes.first + level.alpha_indices[at]);
    const int colour = int(level.colour_codes.first + level.colour_indices[at]);
    for (int texel = 0; texel < 16; ++texel) {
      const auto of_tile = [&](int tile) {
        const int x = tile % across * 4 + texel % 4, y = tile / across * 4 + texel / 4;
        return glm::vec4(tree.atlas.rgba[std::size_t(y * tree.atlas.width_px + x)]) / 255.0f;
      };
      const float a = of_tile(alpha).a;
      sum += glm::vec4(glm::vec3(of_tile(colour)) * a, a) / float(16 * blocks);
    }
  }
  return sum;
}

void draw_item(const bosk::TreeModel& tree, const Camera& camera, const bosk::DrawItem& item,
               std::vector<glm::vec4>& picture) {
  const bosk::TreeLevel& level = tree.levels[item.level_slot];
  const glm::dvec3 centre =
      camera.pixel(bosk::cell_centre_in_world(tree, level.level, level.cells[item.cell]));
  const double half_px =
      0.5 * kFocalPx / centre.z * double(level.side_factor) * bosk::cell_size_m(tree, level.level);
  const glm::vec4 colour = glm::mix(mean_colour(tree, item, item.view_a),
                                    mean_colour(tree, item, item.view_b), item.weight_b);
  const auto first = [&](double at) { return std::max(0, int(std::ceil(at - half_px))); };
  const auto last = [&](double at) { return std::min(kSize - 1, int(std::floor(at + half_px))); };
  for (int y = first(centre.y); y <= last(centre.y); ++y) {
    for (int x = first(centre.x); x <= last(centre.x); ++x) {
      glm::vec4& pixel = picture[std::size_t(y * kSize + x)];
      pixel = colour + (1.0f - colour.a) * pixel;
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "usage: draw_tree TREE.bosk PICTURE.ppm\n";
    return 2;
  }
  try {
    const bosk::TreeModel tree = bosk::load_tree(arguments[1]);
    const bosk::PreparedTree prepared(tree);
    Camera camera;
    camera.eye = 0.5 * (prepared.lower() + prepared.upper());
    camera.eye.y -= 2.0 * tree.size_m;
    const std::vector<bosk::DrawRange> ranges =
        bosk::make_draw_list(prepared, {camera.eye, {0.0, 1.0, 0.0}, kFocalPx}, {});
    const std::vector<bosk::DrawItem> items =
        bosk::draw_items(prepared, ranges, camera.eye, bosk::BlendRule::fading);

    std::vector<glm::vec4> picture(std::size_t(kSize) * kSize);
    for (const bosk::DrawItem& item : items) draw_item(tree, camera, item, picture);

    std::ofstream file(arguments[2], std::ios::binary);
    file << "P6\n" << kSize << " " << kSize << "\n255\n";
    std::size_t covered = 0;
    for (const glm::vec4& pixel : picture) {
      const glm::vec3 over_white = glm::vec3(pixel) + (1.0f - pixel.a);
      for (int i = 0; i < 3; ++i) file.put(char(int(255.0f * over_white[i] + 0.5f)));
      covered += pixel.a > 0.5f ? 1 : 0;
    }
    std::cout << items.size() << " billboards, " << 100 * covered / picture.size()
              << " % of the picture\n";
    return file.flush() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
