// Loads a package and prints its size, section by section, and the best time of many: processor
// time of one thread and wall time of two.
//   package_benchmark              a made-up tree: 31,000 cells, 24 views, 1,024 colour and 512
//   alpha codewords package_benchmark TREE.bosk    a real one

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <limits>
#include <string>

#include "core/package/container.h"
#include "core/package/reader.h"
#include "core/package/writer.h"
#include "tests/package/sample_tree.h"

namespace bosk {
namespace {

std::vector<std::byte> made_up_package() {
  const TreeModel tree = sample_tree(
      {.levels = {4, 5, 6}, .views = 24, .alpha_codewords = 512, .colour_codewords = 1024});
  Progress progress;
  const auto begin = std::chrono::steady_clock::now();
  auto bytes = package_bytes(tree, progress);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  std::printf("written in %.2f s\n", taken.count());
  return bytes;
}

void print_sections(const std::vector<std::byte>& bytes) {
  for (const SectionEntry& entry : open_container(bytes).sections) {
    std::printf("  %-7s %8.3f MB, decoded %8.3f MB\n",
                section_name(entry.type, entry.instance).c_str(), double(entry.length) / 1e6,
                double(entry.raw_length) / 1e6);
  }
}

void print_contents(const TreeModel& tree) {
  std::size_t pairs = 0, live = 0;
  for (const TreeLevel& level : tree.levels) {
    pairs += level.alpha_indices.size();
    live +=
        level.alpha_indices.size() -
        std::size_t(std::count(level.alpha_indices.begin(), level.alpha_indices.end(), kPruned));
  }
  std::printf("  %zu pairs of indices, %zu of them not pruned\n", pairs, live);
}

// Best of many in milliseconds. Other programs disturb processor time less than wall time.
double best_processor_ms(const std::vector<std::byte>& bytes) {
  std::clock_t best = std::numeric_limits<std::clock_t>::max();
  for (int round = 0; round < 100; ++round) {
    const std::clock_t begin = std::clock();
    read_tree(bytes, "benchmark", 1);
    best = std::min(best, std::clock() - begin);
  }
  return 1e3 * double(best) / CLOCKS_PER_SEC;
}
double best_wall_ms(const std::vector<std::byte>& bytes) {
  using Clock = std::chrono::steady_clock;
  std::chrono::duration<double, std::milli> best(1e9);
  for (int round = 0; round < 100; ++round) {
    const auto begin = Clock::now();
    read_tree(bytes, "benchmark", 2);
    best = std::min<decltype(best)>(best, Clock::now() - begin);
  }
  return best.count();
}

}  // namespace
}  // namespace bosk

int main(int count, char** arguments) {
  try {
    const auto bytes = count > 1 ? bosk::load_package_bytes(arguments[1]) : bosk::made_up_package();
    bosk::print_sections(bytes);
    bosk::print_contents(bosk::read_tree(bytes, "benchmark"));
    std::printf("%.2f MB, loaded in %.1f ms of one core, in %.1f ms by two threads\n",
                double(bytes.size()) / 1e6, bosk::best_processor_ms(bytes),
                bosk::best_wall_ms(bytes));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
