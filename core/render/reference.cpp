#include "core/render/reference.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/render/billboard_geometry.h"
#include "core/render/code_texture.h"
#include "core/render/splat.h"

namespace bosk {
namespace {

// How far the picture moves per metre along `axis` at the point; by central differences.
std::optional<glm::dvec2> pixels_per_metre(const Lens& lens, const glm::dvec3& point_in_camera,
                                           const glm::dvec3& axis_in_camera) {
  const double step_m = 1e-4 * glm::length(point_in_camera);
  const auto before = pixel_from_camera(lens, point_in_camera - step_m * axis_in_camera);
  const auto after = pixel_from_camera(lens, point_in_camera + step_m * axis_in_camera);
  if (!before || !after) return std::nullopt;
  return (*after - *before) / (2.0 * step_m);
}

// One draw list and one camera: where every item falls in the picture.
class Projector {
 public:
  Projector(const TreeModel& model, const Camera& camera)
      : model_(model), camera_(camera), eye_(camera.centre_in_world()) {}

  std::optional<Splat> splat(const DrawItem& item, std::uint32_t position) const {
    const TreeLevel& level = model_.levels[item.level_slot];
    const glm::dvec3 centre = cell_centre_in_world(model_, level.level, level.cells[item.cell]);
    const glm::dvec3 centre_in_camera = camera_.camera_from_world * centre;
    const double half_m = 0.5 * cell_size_m(model_, level.level) * double(level.side_factor);
    const auto pixel = pixel_from_camera(camera_.lens, centre_in_camera);
    if (!pixel || !may_reach(*pixel, half_m, centre_in_camera)) return std::nullopt;
    const BillboardAxes axes = billboard_axes(centre, eye_);
    const glm::dmat3& rotation = camera_.camera_from_world.rotation;
    const auto across = pixels_per_metre(camera_.lens, centre_in_camera, rotation * axes.right);
    const auto up = pixels_per_metre(camera_.lens, centre_in_camera, rotation * axes.up);
    if (!across || !up) return std::nullopt;
    const Splat splat{*pixel, *across * half_m, *up * -half_m, position};
    if (!inside(splat)) return std::nullopt;
    return splat;
  }

 private:
  // Spares far-off billboards the exact test: is the centre within eight of its radii of the
  // picture?
  bool may_reach(const glm::dvec2& pixel, double half_m, const glm::dvec3& centre) const {
    const double focal_px = std::max(camera_.lens.focal_px.x, camera_.lens.focal_px.y);
    const double margin_px = 8.0 * focal_px * half_m / centre.z;
    return pixel.x > -0.5 - margin_px && pixel.x < camera_.lens.width_px - 0.5 + margin_px &&
           pixel.y > -0.5 - margin_px && pixel.y < camera_.lens.height_px - 0.5 + margin_px;
  }

  // False also where a number is not finite.
  bool inside(const Splat& splat) const {
    const glm::vec2 half = half_extent_px(splat);
    const glm::vec2 low = splat.centre_px - half, high = splat.centre_px + half;
    return high.x > -0.5f && low.x < float(camera_.lens.width_px) - 0.5f && high.y > -0.5f &&
           low.y < float(camera_.lens.height_px) - 0.5f && half.x < 1e5f && half.y < 1e5f;
  }

  const TreeModel& model_;
  const Camera& camera_;
  glm::dvec3 eye_;
};

constexpr std::size_t kItemsPerChunk = 8192;

// Splats of all items that reach the picture, in the order of the draw list.
std::vector<Splat> project_items(const TreeModel& model, const Camera& camera,
                                 const std::vector<DrawItem>& list, Progress& progress) {
  const Projector projector(model, camera);
  const std::size_t chunks = (list.size() + kItemsPerChunk - 1) / kItemsPerChunk;
  std::vector<std::vector<Splat>> parts(chunks);
  tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t chunk) {
    progress.check();
    const std::size_t last = std::min(list.size(), (chunk + 1) * kItemsPerChunk);
    for (std::size_t i = chunk * kItemsPerChunk; i < last; ++i)
      if (const auto splat = projector.splat(list[i], std::uint32_t(i)))
        parts[chunk].push_back(*splat);
  });
  std::vector<Splat> splats;
  for (const std::vector<Splat>& part : parts)
    splats.insert(splats.end(), part.begin(), part.end());
  return splats;
}

struct TileGrid {
  int across = 0, down = 0;
  std::size_t count() const { return std::size_t(across) * std::size_t(down); }
};

// The tiles that the splat's bounding box touches, by index.
template <class Visit>
void for_each_tile(const Splat& splat, const TileGrid& grid, const Visit& visit) {
  const glm::vec2 half = half_extent_px(splat) + 0.5f;
  const glm::vec2 low = (splat.centre_px - half) / float(kTile_px);
  const glm::vec2 high = (splat.centre_px + half) / float(kTile_px);
  const int left = std::max(0, int(std::floor(std::max(low.x, 0.0f))));
  const int top = std::max(0, int(std::floor(std::max(low.y, 0.0f))));
  const int right = int(std::min(float(grid.across - 1), std::floor(high.x)));
  const int bottom = int(std::min(float(grid.down - 1), std::floor(high.y)));
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x)
      visit(std::size_t(y) * std::size_t(grid.across) + std::size_t(x));
}

// Positions of splats tile after tile, in drawing order within a tile; tile t has [first[t],
// first[t+1]).
struct TileBins {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> splats;
};

TileBins bin_splats(const std::vector<Splat>& splats, const TileGrid& grid) {
  TileBins bins;
  bins.first.assign(grid.count() + 1, 0);
  for (const Splat& splat : splats)
    for_each_tile(splat, grid, [&](std::size_t tile) { ++bins.first[tile + 1]; });
  for (std::size_t tile = 0; tile < grid.count(); ++tile) bins.first[tile + 1] += bins.first[tile];
  bins.splats.resize(bins.first.back());
  std::vector<std::size_t> next(bins.first.begin(), bins.first.end() - 1);
  for (std::size_t i = 0; i < splats.size(); ++i)
    for_each_tile(splats[i], grid,
                  [&](std::size_t tile) { bins.splats[next[tile]++] = std::uint32_t(i); });
  return bins;
}

void copy_tile(const Tile& tile, Image<glm::vec4>& image) {
  for (int y = 0; y < tile.height_px; ++y) {
    for (int x = 0; x < tile.width_px; ++x) {
      const Float4 pixel = tile.pixels[y * kTile_px + x];
      image(tile.left_px + x, tile.top_px + y) = {pixel[0], pixel[1], pixel[2], pixel[3]};
    }
  }
}

glm::vec4 straight(const glm::vec4& premultiplied) {
  if (!(premultiplied.a > 0.0f)) return glm::vec4(0.0f);
  const glm::vec3 colour = glm::clamp(glm::vec3(premultiplied) / premultiplied.a, 0.0f, 1.0f);
  return glm::vec4(colour, std::min(premultiplied.a, 1.0f));
}

}  // namespace

Options describe(RenderOptions& options) {
  return {
      {"detail",
       "",
       "draw as finely as if the tree were this many times larger on screen",
       &options.detail,
       0.01,
       100.0,
       {}},
      {"level",
       "",
       "draw this octree level alone; -1 chooses levels by size on screen",
       &options.level,
       -1.0,
       21.0,
       {}},
      {"blend",
       "",
       "how two views mix: fading avoids jumps, linear is the papers' rule",
       &options.blend,
       0.0,
       0.0,
       {"fading", "linear"}},
      {"gpu_texels",
       "",
       "show the BC3 texels that a GPU reads, not the exact ones",
       &options.gpu_texels,
       0.0,
       0.0,
       {}},
  };
}

DrawOptions draw_options(const RenderOptions& options) {
  DrawOptions draw;
  draw.detail = options.detail;
  draw.only_level = options.level;
  return draw;
}

Viewpoint viewpoint_of(const Camera& camera) {
  Viewpoint viewpoint;
  viewpoint.eye = camera.centre_in_world();
  viewpoint.forward = glm::transpose(camera.camera_from_world.rotation) * glm::dvec3(0, 0, 1);
  viewpoint.focal_px = std::sqrt(camera.lens.focal_px.x * camera.lens.focal_px.y);
  return viewpoint;
}

Image<glm::vec4> render_tree_premultiplied(const PreparedTree& tree, const Camera& camera,
                                           const RenderOptions& options, Progress& progress) {
  const TreeModel& model = tree.model();
  Image<glm::vec4> image(camera.lens.width_px, camera.lens.height_px, glm::vec4(0.0f));
  if (image.empty() || model.levels.empty()) return image;
  const TileGrid grid{(image.width() + kTile_px - 1) / kTile_px,
                      (image.height() + kTile_px - 1) / kTile_px};
  progress.begin("Drawing " + camera.name, grid.count());
  const TileTexels texels = options.gpu_texels ? gpu_tiles(model.atlas) : exact_tiles(model.atlas);
  const Viewpoint viewpoint = viewpoint_of(camera);
  const std::vector<DrawItem> list =
      draw_items(tree, make_draw_list(tree, viewpoint, draw_options(options)), viewpoint.eye,
                 blend_rule(options.blend));
  const std::vector<Splat> splats = project_items(model, camera, list, progress);
  const TileBins bins = bin_splats(splats, grid);
  tbb::parallel_for(std::size_t(0), grid.count(), [&](std::size_t index) {
    Tile tile{};
    tile.left_px = int(index % std::size_t(grid.across)) * kTile_px;
    tile.top_px = int(index / std::size_t(grid.across)) * kTile_px;
    tile.width_px = std::min(kTile_px, image.width() - tile.left_px);
    tile.height_px = std::min(kTile_px, image.height() - tile.top_px);
    Float4 texture[kMostTexels * kMostTexels];
    for (std::size_t i = bins.first[index]; i < bins.first[index + 1]; ++i) {
      const Splat& splat = splats[bins.splats[i]];
      const DrawItem& item = list[splat.item];
      decode_item(model, texels, item, texture);
      composite_splat(splat, texture, model.levels[item.level_slot].texels, item.fade, tile);
    }
    copy_tile(tile, image);
    progress.advance();
  });
  return image;
}

Image<glm::vec4> render_tree(const PreparedTree& tree, const Camera& camera,
                             const RenderOptions& options, Progress& progress) {
  return straight_from_premultiplied(render_tree_premultiplied(tree, camera, options, progress));
}

Image<glm::vec4> straight_from_premultiplied(Image<glm::vec4> image) {
  for (glm::vec4& pixel : image.pixels()) pixel = straight(pixel);
  return image;
}

}  // namespace bosk
