// Processor time of a forest's draw lists on one core, with how many billboards they hold.
//
//     forest_benchmark TREE.bosk...        (google-benchmark's own options come first)

#include <benchmark/benchmark.h>

#include <iostream>
#include <random>

#include "core/render/forest.h"
#include "tests/benchmarks/packages.h"
#include "tests/benchmarks/run_or_explain.h"

namespace bosk {
namespace {

constexpr double kFocalPx = 1100.0;  // 1280 x 720 px, 60 degrees across
constexpr double kHalfAngle = 0.59;  // of the cone around the picture

Packages packages;

// `count` trees in a disc; on average `spacing_m` apart.
Forest forest_of(std::size_t count, double spacing_m) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double side_m = spacing_m * std::sqrt(double(count));
  std::vector<TreeInstance> instances(count);
  for (TreeInstance& instance : instances) {
    instance.tree = std::uint32_t(random() % packages.trees.size());
    instance.place = {side_m * (unit(random) - 0.5), side_m * (unit(random) - 0.5), 0.0};
    instance.turn = 6.28 * unit(random);
    instance.scale = 0.8 + 0.4 * unit(random);
  }
  return {packages.trees, instances};
}

// Frame `frame` of a walk along a circle of `radius_m`, looking to the middle and past it.
Viewpoint walk(int frame, double radius_m) {
  const double angle = 0.05 * frame;
  const glm::dvec3 eye(radius_m * std::cos(angle), radius_m * std::sin(angle), 1.7);
  return {eye, glm::normalize(glm::dvec3(-std::cos(angle + 0.4), -std::sin(angle + 0.4), 0.05)),
          kFocalPx};
}

void walk_through(benchmark::State& state, const Forest& forest, double radius_m,
                  std::uint64_t budget) {
  ForestDrawList list;
  DrawOptions options;
  options.half_angle = kHalfAngle;
  int frame = 0;
  double billboards = 0, ranges = 0, drawn = 0;
  for (auto _ : state) {
    forest.draw_list(walk(frame++, radius_m), options, budget, list);
    billboards += double(list.billboards);
    ranges += double(list.ranges.size());
    drawn += double(list.instances.size());
  }
  state.counters["trees seen"] = drawn / frame;
  state.counters["ranges"] = ranges / frame;
  state.counters["billboards"] = billboards / frame;
}

// The scene of Linz et al. 2006: 290 trees of three kinds. Argument: billboards at most, 0: any.
void walk_among_290(benchmark::State& state) {
  const Forest forest = forest_of(290, 14.0);
  walk_through(state, forest, 80.0, std::uint64_t(state.range(0)));
}
BENCHMARK(walk_among_290)->Arg(0)->Arg(300000)->Unit(benchmark::kMillisecond);

// All trees around the eye at once; the nearest hundredth is within a tenth of the radius.
void trees_all_round(benchmark::State& state) {
  const Forest forest = forest_of(std::size_t(state.range(0)), 14.0);
  ForestDrawList list;
  DrawOptions options;
  options.half_angle = std::numbers::pi;
  int frame = 0;
  for (auto _ : state) forest.draw_list(walk(frame++, 20.0), options, 300000, list);
  state.counters["trees seen"] = double(list.instances.size());
  state.counters["billboards"] = double(list.billboards);
  state.counters["trees/s"] =
      benchmark::Counter(double(state.range(0)), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(trees_all_round)->RangeMultiplier(10)->Range(100, 100000)->Unit(benchmark::kMillisecond);

void prepare(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(PreparedTree(packages.models.front()));
  state.counters["cells"] = double(packages.trees.front()->cell_count());
}
BENCHMARK(prepare)->Unit(benchmark::kMillisecond);

}  // namespace

int run(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (count < 2) {
    std::cerr << "forest_benchmark: name one or more packages (TREE.bosk)\n";
    return 2;
  }
  packages = load_packages(count - 1, arguments + 1);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace bosk

int main(int count, char** arguments) { return bosk::run_or_explain(bosk::run, count, arguments); }
