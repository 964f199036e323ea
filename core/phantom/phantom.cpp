#include "core/phantom/phantom.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/phantom/photograph.h"
#include "core/phantom/walk.h"

namespace bosk {
namespace {

constexpr double kSetUpShare = 0.1;  // of the job, before the first photograph

glm::vec3 sun_direction(double elevation_deg, Random& random) {
  const double azimuth = random.uniform(0.0, 6.283185307179586);
  const double up = glm::radians(elevation_deg);
  return {std::cos(up) * std::cos(azimuth), std::cos(up) * std::sin(azimuth), std::sin(up)};
}

float crown_radius(const Tree& tree) {
  float radius = 0.0f;
  for (const glm::vec3& v : tree.vertices) radius = std::max(radius, std::hypot(v.x, v.y));
  return radius;
}

// Beside the tree, leaning back a little on an easel, turned to the light.
Board stand_board(const World& world) {
  Board board;
  const glm::dvec3 sun(world.sun_direction);
  const glm::dvec3 flat = glm::normalize(glm::dvec3(sun.x, sun.y, 0.0));
  const glm::dvec3 face = glm::normalize(flat + glm::dvec3(0.0, 0.0, 0.35));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), face));
  board.world_from_board.rotation = glm::dmat3(right, glm::cross(face, right), face);
  board.world_from_board.translation =
      (1.5 * double(world.crown_radius) + 1.0) * flat + glm::dvec3(0.0, 0.0, 0.9);
  return board;
}

World surround(const Tree& tree, const PhantomOptions& options) {
  const auto seed = std::uint64_t(options.seed);
  Random random(seed, 10);
  World world;
  world.seed = std::uint32_t(options.seed);
  world.sun_direction = sun_direction(options.sun_elevation_deg, random);
  world.tree_height = float(tree.shape.height);
  world.crown_radius = crown_radius(tree);
  const double scale = std::min(1.0, tree.shape.height / 9.0);
  world.markers = place_markers(options.markers, double(world.crown_radius), scale, seed);
  if (options.board_photos > 0) world.boards.push_back(stand_board(world));
  if (options.background) world.distant_trees = place_distant_trees(32, tree.shape.height, seed);
  return world;
}

Shot shot_of(const PhantomOptions& options, std::uint64_t number) {
  Random random(std::uint64_t(options.seed), 1000 + number);
  Shot shot;
  shot.seed = random.bits();
  shot.exposure = std::exp2(options.exposure_drift * random.normal());
  shot.noise = options.noise;
  shot.wind = options.wind_m;
  shot.samples = (options.samples + 7) / 8 * 8;
  shot.background = options.background;
  return shot;
}

Shot still_shot(const PhantomOptions& options, std::uint64_t number) {
  Shot shot = shot_of(options, number);
  shot.exposure = 1.0;
  shot.noise = shot.wind = 0.0;
  return shot;
}

PhantomView view_of(const Studio& studio, const Camera& camera, const Shot& shot,
                    Progress& progress) {
  Exposure exposure = photograph(studio, camera, shot, progress);
  PhantomView view{camera,
                   std::move(exposure.photograph),
                   std::move(exposure.matte),
                   std::move(exposure.in_front),
                   shot.exposure,
                   {},
                   {}};
  for (std::size_t i = 0; i < studio.world.markers.size(); ++i) {
    const auto pixel = project(camera, studio.world.markers[i].centre);
    view.marker_px.push_back(pixel.value_or(glm::dvec2(-1e6)));
    view.marker_visible.push_back(visible_share(studio, camera, i));
  }
  return view;
}

}  // namespace

Phantom make_phantom(const PhantomOptions& options, Progress& progress) {
  progress.begin("Growing and lighting the tree", 1, 0.0, kSetUpShare);
  const auto seed = std::uint64_t(options.seed);
  const TreeShape shape = tree_shape(options.preset, options.detail, options.height_m);
  Tree tree = grow_tree(shape, seed, progress);
  Phantom phantom;
  phantom.options = options;
  phantom.density = measure_density(tree, options.density_side);
  phantom.leaves = tree.facet_count() / tree.facets_per_leaf;
  World world = surround(tree, options);
  const Studio studio =
      set_up_studio(std::move(tree), std::move(world), ground_map_side(options), progress);
  progress.advance();

  const Walk walk = walk_round(studio.tree.vertices, options);
  const auto rows = [&](std::size_t views) { return views * std::size_t(options.height_px); };
  const std::size_t views = walk.photos.size() + walk.held_out.size();
  progress.begin("Photographing", rows(views + std::size_t(options.board_photos)), kSetUpShare,
                 1.0);
  std::uint64_t number = 0;
  for (const Camera& camera : walk.photos) {
    phantom.photos.push_back(view_of(studio, camera, shot_of(options, number++), progress));
  }
  number = 100000;  // photos and held-out views don't depend on each other's number
  for (const Camera& camera : walk.held_out) {
    phantom.held_out.push_back(view_of(studio, camera, still_shot(options, number++), progress));
  }
  if (!studio.world.boards.empty()) phantom.board = studio.world.boards.front();
  number = 200000;
  for (const Camera& camera : board_views(phantom.board, options)) {
    phantom.board_photos.push_back(view_of(studio, camera, shot_of(options, number++), progress));
  }
  phantom.markers = studio.world.markers;
  return phantom;
}

Photos pinhole_photos(const Phantom& phantom) {
  Photos photos;
  for (const PhantomView& view : phantom.photos) {
    Photo photo{view.camera.name, view.camera, view.camera, {}};
    photo.srgb = Image<glm::vec3>(view.photograph.width(), view.photograph.height());
    std::transform(view.photograph.pixels().begin(), view.photograph.pixels().end(),
                   photo.srgb.pixels().begin(),
                   [](const glm::u8vec3& pixel) { return glm::vec3(pixel) / 255.0f; });
    photos.push_back(std::move(photo));
  }
  return photos;
}

Image<glm::vec4> straight_matte(const PhantomView& view) {
  Image<glm::vec4> rgba(view.matte.width(), view.matte.height());
  std::transform(view.matte.pixels().begin(), view.matte.pixels().end(), rgba.pixels().begin(),
                 [](const glm::u8vec4& pixel) { return glm::vec4(pixel) / 255.0f; });
  return rgba;
}

}  // namespace bosk
