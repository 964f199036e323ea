#include "core/render/forest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "core/base/error.h"

namespace bosk {
namespace {

constexpr double kLeastDetail = 1.0 / 1024.0;
constexpr int kDetailSteps = 24;        // halvings of the interval in which the detail is sought
constexpr double kDepthsPerOctave = 8;  // trees at depths that differ less are counted together

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

// Of the cells' box and what billboards reach out of it.
double crown_radius(const PreparedTree& tree) {
  double reach_m = 0.0;
  for (int cut = 0; cut < tree.cut_count(); ++cut) {
    const TreeLevel& level = tree.level_of_cut(cut);
    const double cell_m = std::ldexp(tree.model().size_m, -level.level);
    reach_m = std::max(reach_m, 0.7072 * cell_m * double(level.side_factor));
  }
  return 0.5 * glm::length(tree.upper() - tree.lower()) + reach_m;
}

double sphere_reach(const glm::dvec3& lower, const glm::dvec3& upper) {
  return 0.5 * glm::length(upper - lower);
}

class Cone {
 public:
  Cone(const Viewpoint& viewpoint, double half_angle)
      : eye_(viewpoint.eye),
        forward_(viewpoint.forward),
        cosine_(std::cos(half_angle)),
        sine_(std::sin(half_angle)) {}

  bool misses(const glm::dvec3& centre, double radius) const {
    const glm::dvec3 from_eye = centre - eye_;
    const double depth = glm::dot(from_eye, forward_);
    const double across = std::sqrt(std::max(0.0, glm::dot(from_eye, from_eye) - depth * depth));
    return across * cosine_ - depth * sine_ > radius;
  }

 private:
  glm::dvec3 eye_, forward_;
  double cosine_, sine_;
};

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

// Lists the instances in the cone, far groves first.
class GroveWalk {
 public:
  GroveWalk(const Forest& forest, const Viewpoint& viewpoint, double half_angle,
            std::vector<std::uint32_t>& instances)
      : forest_(forest), eye_(viewpoint.eye), cone_(viewpoint, half_angle), instances_(instances) {}

  void visit(std::int32_t number) {
    const Forest::Grove& grove = forest_.groves_[std::size_t(number)];
    const glm::dvec3 centre = 0.5 * (grove.lower + grove.upper);
    if (cone_.misses(centre, sphere_reach(grove.lower, grove.upper))) return;
    if (grove.low < 0) {
      for (std::uint32_t i = grove.first; i < grove.last; ++i) {
        const std::uint32_t instance = forest_.by_place_[i];
        const Forest::Stand& stand = forest_.stands_[instance];
        if (!cone_.misses(stand.centre, stand.radius)) instances_.push_back(instance);
      }
      return;
    }
    const bool eye_is_high = eye_[grove.axis] > grove.plane;
    visit(eye_is_high ? grove.low : grove.high);
    visit(eye_is_high ? grove.high : grove.low);
  }

 private:
  const Forest& forest_;
  glm::dvec3 eye_;
  Cone cone_;
  std::vector<std::uint32_t>& instances_;
};

Forest::Forest(std::vector<std::shared_ptr<const PreparedTree>> trees,
               std::vector<TreeInstance> instances)
    : trees_(std::move(trees)), instances_(std::move(instances)) {
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const TreeInstance& instance = instances_[i];
    check(instance, i, trees_.size());
    const PreparedTree& tree = *trees_[instance.tree];
    stands_.push_back({world_from_tree(instance, 0.5 * (tree.lower() + tree.upper())),
                       instance.scale * crown_radius(tree), std::cos(instance.turn),
                       std::sin(instance.turn)});
    by_place_.push_back(std::uint32_t(i));
  }
  if (!instances_.empty()) add_grove(0, std::uint32_t(instances_.size()));
}

std::int32_t Forest::add_grove(std::uint32_t first, std::uint32_t last) {
  const auto number = std::int32_t(groves_.size());
  groves_.emplace_back();
  Grove grove;
  grove.first = first;
  grove.last = last;
  glm::dvec2 least(std::numeric_limits<double>::infinity()), most(-least);
  grove.lower = glm::dvec3(std::numeric_limits<double>::infinity());
  grove.upper = -grove.lower;
  for (std::uint32_t i = first; i < last; ++i) {
    const std::uint32_t instance = by_place_[i];
    const Stand& stand = stands_[instance];
    grove.lower = glm::min(grove.lower, stand.centre - stand.radius);
    grove.upper = glm::max(grove.upper, stand.centre + stand.radius);
    least = glm::min(least, glm::dvec2(instances_[instance].place));
    most = glm::max(most, glm::dvec2(instances_[instance].place));
  }
  grove.axis = most.x - least.x >= most.y - least.y ? 0 : 1;
  if (most[grove.axis] > least[grove.axis]) {
    const auto coordinate = [&](std::uint32_t i) { return instances_[i].place[grove.axis]; };
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
      return coordinate(a) < coordinate(b);
    };
    std::uint32_t middle = (first + last) / 2;
    const auto begin = by_place_.begin();
    std::nth_element(begin + first, begin + middle, begin + last, before);
    const double upper = coordinate(by_place_[middle]);
    // All below the plane are strictly below, else those in the middle's place go up with it
    const auto parted = std::partition(begin + first, begin + last,
                                       [&](std::uint32_t i) { return coordinate(i) < upper; });
    middle = std::uint32_t(parted - begin);
    if (middle == first) {  // half of them or more share the least place
      const auto above = std::partition(begin + first, begin + last,
                                        [&](std::uint32_t i) { return coordinate(i) <= upper; });
      middle = std::uint32_t(above - begin);
    }
    const auto last_low = *std::max_element(begin + first, begin + middle, before);
    const auto first_high = *std::min_element(begin + middle, begin + last, before);
    grove.plane = 0.5 * (coordinate(last_low) + coordinate(first_high));
    grove.low = add_grove(first, middle);
    grove.high = add_grove(middle, last);
  }
  groves_[std::size_t(number)] = grove;
  return number;
}

// Trees of one kind at about the same depth are counted once; then the interval of details is
// halved until the sum fits.
double Forest::affordable_detail(const Viewpoint& viewpoint, const DrawOptions& options,
                                 std::uint64_t budget,
                                 const std::vector<std::uint32_t>& instances) const {
  std::map<std::pair<std::uint32_t, int>, double> trees_at;  // kind and octave step -> how many
  for (const std::uint32_t i : instances) {
    const Stand& stand = stands_[i];
    const double depth = glm::dot(stand.centre - viewpoint.eye, viewpoint.forward);
    const double in_tree = std::max(depth, 0.5 * stand.radius) / instances_[i].scale;
    trees_at[{instances_[i].tree, int(std::floor(kDepthsPerOctave * std::log2(in_tree)))}] += 1.0;
  }
  const auto billboards = [&](double detail) {
    DrawOptions coarser = options;
    coarser.detail = detail;
    double sum = 0.0;
    for (std::uint32_t tree = 0; tree < trees_.size(); ++tree) {
      const RangeChooser chooser(*trees_[tree], viewpoint.focal_px, coarser);
      for (auto at = trees_at.lower_bound({tree, std::numeric_limits<int>::min()});
           at != trees_at.end() && at->first.first == tree; ++at) {
        sum += at->second *
               chooser.billboards_at(std::exp2((at->first.second + 0.5) / kDepthsPerOctave));
      }
    }
    return sum;
  };
  if (budget == 0 || billboards(options.detail) <= double(budget)) return options.detail;
  double low = std::log2(kLeastDetail * options.detail), high = std::log2(options.detail);
  for (int step = 0; step < kDetailSteps; ++step) {
    const double middle = 0.5 * (low + high);
    (billboards(std::exp2(middle)) <= double(budget) ? low : high) = middle;
  }
  return std::exp2(low);
}

void Forest::draw_list(const Viewpoint& viewpoint, const DrawOptions& options, std::uint64_t budget,
                       ForestDrawList& list) const {
  list.ranges.clear();
  list.instances.clear();
  list.by_level.clear();
  list.billboards = 0;
  if (groves_.empty()) return;
  GroveWalk(*this, viewpoint, options.half_angle, list.instances).visit(0);
  DrawOptions afforded = options;
  afforded.detail = list.detail = affordable_detail(viewpoint, options, budget, list.instances);
  std::vector<RangeChooser> choosers;
  for (const auto& tree : trees_) choosers.emplace_back(*tree, viewpoint.focal_px, afforded);
  for (const std::uint32_t i : list.instances) {
    const TreeInstance& instance = instances_[i];
    const Stand& stand = stands_[i];
    const glm::dvec3 eye =
        turned(viewpoint.eye - instance.place, stand.cosine, -stand.sine) / instance.scale;
    const glm::dvec3 forward = turned(viewpoint.forward, stand.cosine, -stand.sine);
    choosers[instance.tree].append(eye, forward, i, list.ranges);
  }
  for (const DrawRange& range : list.ranges) {
    const PreparedTree& tree = *trees_[instances_[range.instance].tree];
    const auto level = std::size_t(tree.level_of_cut(range.cut).level);
    if (list.by_level.size() <= level) list.by_level.resize(level + 1);
    list.by_level[level] += range.count;
    list.billboards += range.count;
  }
}

}  // namespace bosk
