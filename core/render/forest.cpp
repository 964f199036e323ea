#include "core/render/forest.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/error.h"

namespace bosk {
namespace {

constexpr double kLeastDetail = 1.0 / 1024.0;
constexpr std::size_t kBatch = 64;         // instances
constexpr double kDetailTolerance = 0.03;  // octaves
constexpr double kBudgetTolerance = 1.1;

glm::dvec3 turned(const glm::dvec3& v, double cosine, double sine) {
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
}

void check(const TreeInstance& instance, std::size_t number, std::size_t trees) {
  const std::string name = "tree " + std::to_string(number) + " of the forest";
  if (instance.tree >= trees) throw Error(name + ": it is of a kind that is not loaded");
  if (!(instance.scale > 0.0) || !std::isfinite(instance.scale))
    throw Error(name + ": its scale must be above 0");
  const glm::dvec3 place = instance.place;
  if (!std::isfinite(place.x + place.y + place.z + instance.turn))
    throw Error(name + ": its place and turn must be finite numbers");
}

// Of billboards from their cells' middles.
double billboard_reach_m(const PreparedTree& tree) {
  double reach_m = 0.0;
  for (int cut = 0; cut < tree.cut_count(); ++cut) {
    const TreeLevel& level = tree.level_of_cut(cut);
    const double cell_m = std::ldexp(tree.model().size_m, -level.level);
    reach_m = std::max(reach_m, 0.7072 * cell_m * double(level.side_factor));
  }
  return reach_m;
}

// Numbers of the instances in the low half, and what they are ordered by in the high one: floats
// that are not negative order as their bits do.
std::uint64_t key_of(double power, std::uint32_t instance) {
  const auto value = float(std::max(power, 0.0));
  return std::uint64_t(std::bit_cast<std::uint32_t>(value)) << 32 | instance;
}

// Descending by the high half; instances of one power keep their order. Radix sort.
void sort_far_first(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& spare) {
  constexpr int kDigit = 11;
  constexpr std::uint64_t kMask = (1 << kDigit) - 1;
  spare.resize(keys.size());
  for (int shift = 32; shift < 64; shift += kDigit) {
    std::array<std::uint32_t, kMask + 2> first{};
    for (const std::uint64_t key : keys) ++first[kMask - (key >> shift & kMask) + 1];
    for (std::size_t digit = 1; digit < first.size(); ++digit) first[digit] += first[digit - 1];
    for (const std::uint64_t key : keys) spare[first[kMask - (key >> shift & kMask)]++] = key;
    keys.swap(spare);
  }
}

// Depths that share an exponent and three bits of mantissa as floats are counted together.
constexpr std::size_t kDepthBins = 2048;
constexpr int kDepthShift = 20;

std::size_t depth_bin(double depth) {
  return std::bit_cast<std::uint32_t>(float(std::max(depth, 0.0))) >> kDepthShift;
}

double depth_of_bin(std::size_t bin) {
  return double(std::bit_cast<float>(std::uint32_t(bin) << kDepthShift | 1u << (kDepthShift - 1)));
}

// Of the ranges from `first` on, all of one tree.
void count_billboards(const PreparedTree& tree, std::size_t first, ForestDrawList& list) {
  for (std::size_t i = first; i < list.ranges.size(); ++i) {
    const DrawRange& range = list.ranges[i];
    if (range.high != 0) continue;  // the cells of a divided node are counted with its lowest part
    const auto level = std::size_t(tree.level_of_cut(range.cut).level);
    if (list.by_level.size() <= level) list.by_level.resize(level + 1);
    list.by_level[level] += range.count;
    list.billboards += range.count;
  }
}

}  // namespace

glm::dvec3 tree_from_world(const TreeInstance& instance, const glm::dvec3& point_in_world) {
  return turned(point_in_world - instance.place, std::cos(instance.turn),
                -std::sin(instance.turn)) /
         instance.scale;
}

glm::dvec3 world_from_tree(const TreeInstance& instance, const glm::dvec3& point_in_tree) {
  return turned(point_in_tree * instance.scale, std::cos(instance.turn), std::sin(instance.turn)) +
         instance.place;
}

Forest::Forest(std::vector<std::shared_ptr<const PreparedTree>> trees,
               std::vector<TreeInstance> instances)
    : trees_(std::move(trees)), instances_(std::move(instances)) {
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const TreeInstance& instance = instances_[i];
    check(instance, i, trees_.size());
    const PreparedTree& tree = *trees_[instance.tree];
    const glm::dvec3 half = 0.5 * (tree.upper() - tree.lower());
    stands_.push_back({world_from_tree(instance, tree.lower() + half),
                       instance.scale * (glm::length(half) + billboard_reach_m(tree)),
                       instance.scale * 0.5 * (half.x + half.y), instance.place, instance.scale,
                       std::cos(instance.turn), std::sin(instance.turn), instance.tree});
    largest_radius_m_ = std::max(largest_radius_m_, stands_.back().crown_radius_m);
  }
}

void Forest::list_instances(const Viewpoint& viewpoint, double half_angle,
                            ForestDrawList& list) const {
  const ViewCone cone(half_angle);
  list.keys.clear();
  list.depths.assign(trees_.size() * kDepthBins, 0);
  for (std::uint32_t i = 0; i < stands_.size(); ++i) {
    const Stand& stand = stands_[i];
    const glm::dvec3 from_eye = stand.centre - viewpoint.eye;
    if (cone.beyond(from_eye, viewpoint.forward) > stand.reach_m) continue;
    const glm::dvec2 away(from_eye);
    // Powers are negative within a crown, at least -radius^2: shifted, so that they order as floats
    const double power = glm::dot(away, away) - stand.crown_radius_m * stand.crown_radius_m;
    list.keys.push_back(key_of(power + largest_radius_m_ * largest_radius_m_, i));
    const double depth = level_depth(from_eye, viewpoint.forward);
    const double in_tree = std::max(depth, 0.5 * stand.crown_radius_m) / stand.scale;
    ++list.depths[stand.tree * kDepthBins + depth_bin(in_tree)];
  }
  sort_far_first(list.keys, list.spare_keys);
  list.instances.clear();
  for (const std::uint64_t key : list.keys) list.instances.push_back(std::uint32_t(key));
}

double Forest::affordable_detail(const Viewpoint& viewpoint, const DrawOptions& options,
                                 std::uint64_t budget, const ForestDrawList& list) const {
  const auto fits = [&](double detail) {
    DrawOptions coarser = options;
    coarser.detail = detail;
    double sum = 0.0;
    for (std::size_t tree = 0; tree < trees_.size(); ++tree) {
      const RangeChooser chooser(*trees_[tree], viewpoint.focal_px, coarser);
      for (std::size_t bin = 0; bin < kDepthBins; ++bin) {
        const std::uint32_t count = list.depths[tree * kDepthBins + bin];
        if (count > 0) sum += count * chooser.billboards_at(depth_of_bin(bin));
      }
    }
    return sum <= double(budget);
  };
  if (fits(options.detail)) return options.detail;
  double low = std::log2(kLeastDetail * options.detail), high = std::log2(options.detail);
  while (high - low > kDetailTolerance) {
    const double middle = 0.5 * (low + high);
    (fits(std::exp2(middle)) ? low : high) = middle;
  }
  return std::exp2(low);
}

void Forest::list_ranges(const Viewpoint& viewpoint, const DrawOptions& options, double detail,
                         ForestDrawList& list) const {
  list.ranges.clear();
  list.by_level.clear();
  list.billboards = 0;
  list.detail = detail;
  DrawOptions afforded = options;
  afforded.detail = detail;
  std::vector<RangeChooser> choosers;
  choosers.reserve(trees_.size());
  for (const auto& tree : trees_) choosers.emplace_back(*tree, viewpoint.focal_px, afforded);
  // In batches: what far-apart instances need is fetched from memory in a loop of its own, so that
  // the processor waits for many at once
  std::array<Stand, kBatch> stands;
  for (std::size_t first = 0; first < list.instances.size(); first += kBatch) {
    const std::size_t count = std::min(kBatch, list.instances.size() - first);
    for (std::size_t i = 0; i < count; ++i) stands[i] = stands_[list.instances[first + i]];
    for (std::size_t i = 0; i < count; ++i) {
      const Stand& stand = stands[i];
      const glm::dvec3 eye =
          turned(viewpoint.eye - stand.place, stand.cosine, -stand.sine) / stand.scale;
      const glm::dvec3 forward = turned(viewpoint.forward, stand.cosine, -stand.sine);
      const std::size_t before = list.ranges.size();
      choosers[stand.tree].append(eye, forward, list.instances[first + i], list.ranges);
      count_billboards(*trees_[stand.tree], before, list);
    }
  }
}

void Forest::draw_list(const Viewpoint& viewpoint, const DrawOptions& options, std::uint64_t budget,
                       ForestDrawList& list) const {
  list_instances(viewpoint, options.half_angle, list);
  const double detail =
      budget == 0 ? options.detail : affordable_detail(viewpoint, options, budget, list);
  const auto keeps_to_budget = [&](double at) {
    list_ranges(viewpoint, options, at, list);
    return budget == 0 || double(list.billboards) <= kBudgetTolerance * double(budget);
  };
  // Trees were counted whole and at their middle's depth; one of which a part crosses to a much
  // finer level may go far beyond. Then halve the detail until the list fits, and try once between
  if (keeps_to_budget(detail)) return;
  double kept = 0.5 * detail;
  while (!keeps_to_budget(kept) && kept > kLeastDetail * options.detail) kept *= 0.5;
  if (!keeps_to_budget(std::numbers::sqrt2 * kept)) list_ranges(viewpoint, options, kept, list);
}

}  // namespace bosk
