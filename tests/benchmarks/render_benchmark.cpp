// How long a tree takes to list and to draw: random billboards in a ball, about 6 x 6 px each at
// level 7. CPU times are of all threads together.
#include <benchmark/benchmark.h>

#include "core/render/draw_list.h"
#include "core/render/level_switch.h"
#include "core/render/reference.h"
#include "tests/render/toy_trees.h"

namespace bosk {
namespace {

// One level of about `count` cells, `views` views around.
TreeModel big_ball(int level, std::uint64_t every, std::uint32_t views, int texels) {
  TreeModel model;
  model.origin = {-1.0, -1.0, 0.0};
  model.size_m = 2.0;
  model.view_positions = toy::ring(int(views), 6.0, 1.5);
  model.atlas = toy::noise_atlas(1);
  const double cells_per_m = std::ldexp(0.5, level);
  std::vector<std::uint64_t> cells;
  for (std::uint64_t code = 0; code >> (3 * level) == 0; ++code) {
    const glm::dvec3 at = (glm::dvec3(cell_from_morton(code)) + 0.5) / cells_per_m - 1.0;
    if (glm::length(at) < 0.95 && (code * 0x9e3779b97f4a7c15u >> 40) % every == 0)
      cells.push_back(code);
  }
  std::uint32_t next = 1;
  model.levels = {toy::make_level(level, texels, 1.35f, cells, views, [&](auto...) {
    next = next * 1664525u + 1013904223u;
    return std::uint16_t(next >> 24);
  })};
  return model;
}

Camera camera_at(double roll) {
  return toy::look_at({0, -6, 1.5}, {0, 0, 1}, 1700, 720, 960, roll);
}

void list_cells(benchmark::State& state) {
  const TreeModel model = big_ball(int(state.range(0)), 2, 24, 4);
  const PreparedTree tree(model);
  const Viewpoint viewpoint = viewpoint_of(camera_at(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        draw_items(tree, make_draw_list(tree, viewpoint, {}), viewpoint.eye, BlendRule::fading));
  }
  state.counters["billboards"] = double(model.levels[0].cells.size());
}
BENCHMARK(list_cells)->Arg(6)->Arg(7)->Unit(benchmark::kMillisecond);

// Arguments: level, roll of the camera in degrees, texels along an edge.
void draw_tree(benchmark::State& state) {
  const TreeModel model = big_ball(int(state.range(0)), 1, 4, int(state.range(2)));
  Camera camera = camera_at(double(state.range(1)) * std::numbers::pi / 180.0);
  camera.lens.model = LensModel::opencv;
  camera.lens.distortion = {-0.1, 0.02};
  Progress quiet;
  const PreparedTree tree(model);
  for (auto _ : state) benchmark::DoNotOptimize(render_tree(tree, camera, {}, quiet));
  state.counters["billboards"] = double(model.levels[0].cells.size());
}
BENCHMARK(draw_tree)
    ->Args({7, 0, 4})
    ->Args({7, 3, 4})
    ->Args({7, 45, 4})
    ->Args({7, 0, 8})
    ->Args({5, 0, 4})
    ->Args({5, 30, 8})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

void switch_levels(benchmark::State& state) {
  TreeModel model = big_ball(7, 4, 8, 4);
  for (const int level : {6, 5}) {
    const TreeModel coarser = big_ball(level, 1, 8, 4);
    model.levels.insert(model.levels.begin(), coarser.levels[0]);
  }
  Progress quiet;
  for (auto _ : state) set_level_switches(model, {}, quiet);
}
BENCHMARK(switch_levels)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bosk

BENCHMARK_MAIN();
