#include <benchmark/benchmark.h>

#include "core/photo/camera.h"

namespace bosk {
namespace {

using glm::dvec2;
using glm::dvec3;

// A phone's lens and an equally strong fisheye, 720 x 960.
Lens lens_of(LensModel model) {
  Lens lens{model, 720, 960, dvec2(930.0), dvec2(361.8, 476.4), {}};
  if (model != LensModel::pinhole) lens.distortion = {-0.06, 0.012, 0.001, -0.001};
  return lens;
}

dvec2 pixel_of(int index) { return {index % 720, index / 720 % 960}; }

void project_points(benchmark::State& state) {
  const Lens lens = lens_of(LensModel(state.range(0)));
  int index = 0;
  for (auto _ : state) {
    const dvec2 pixel = pixel_of(index++);
    const dvec3 point((pixel.x - 360.0) / 930.0, (pixel.y - 480.0) / 930.0, 1.0);
    benchmark::DoNotOptimize(pixel_from_camera(lens, point));
  }
}
BENCHMARK(project_points)->DenseRange(0, 2);

void cast_rays(benchmark::State& state) {
  const Lens lens = lens_of(LensModel(state.range(0)));
  int index = 0;
  for (auto _ : state) benchmark::DoNotOptimize(camera_from_pixel(lens, pixel_of(index++)));
}
BENCHMARK(cast_rays)->DenseRange(0, 2);

// Pixels beyond the fold: Newton has to find out that there is no ray.
void cast_rays_in_vain(benchmark::State& state) {
  Lens lens = lens_of(LensModel::opencv);
  lens.distortion = {-0.3};
  int index = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(camera_from_pixel(lens, {2000.0 + index++ % 1000, 500.0}));
}
BENCHMARK(cast_rays_in_vain);

}  // namespace
}  // namespace bosk

BENCHMARK_MAIN();
