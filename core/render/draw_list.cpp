#include "core/render/draw_list.h"

#include <algorithm>
#include <cmath>

namespace bosk {
namespace {

constexpr double kEvenFineness = 1.0 / 8.0;    // differences of it within a node that don't show
constexpr int kLevelsOfNode = 4;               // nodes of 2^4 cells a side are not divided
constexpr int kLevelsOfEven = 5;               // nor those of 2^5 only since their levels differ
constexpr std::uint32_t kCheapTwice = 1024;    // cells that are sooner looked at twice than divided
constexpr std::uint32_t kCheapOutside = 2048;  // cells partly outside the cone that are not divided

double smooth(double t) { return t * t * (3.0 - 2.0 * t); }

// Bit per axis on which the point is on the high side.
unsigned octant_of(const glm::dvec3& point, const glm::dvec3& centre) {
  return unsigned(point.x > centre.x) | unsigned(point.y > centre.y) << 1 |
         unsigned(point.z > centre.z) << 2;
}

// Bit per axis on which the point lies strictly between the node's sides.
unsigned axes_inside(const glm::dvec3& point, const PreparedTree::Node& node) {
  const glm::dvec3 away = glm::abs(point - node.centre);
  const double half = 0.5 * node.size_m;
  return unsigned(away.x < half) | unsigned(away.y < half) << 1 | unsigned(away.z < half) << 2;
}

void append_merged(const DrawRange& range, std::vector<DrawRange>& ranges) {
  if (!ranges.empty() && range.split == 0) {
    DrawRange& last = ranges.back();
    DrawRange joined = range;
    joined.first = last.first;
    joined.count = last.count;
    const std::uint32_t next = last.backwards ? last.first - last.count : last.first + last.count;
    if (joined == last && next == range.first) {
      last.count += range.count;
      return;
    }
  }
  ranges.push_back(range);
}

}  // namespace

// One eye's way through the nodes, from the far octants to the near ones.
class RangeWalk {
 public:
  RangeWalk(const RangeChooser& chooser, const glm::dvec3& eye, const glm::dvec3& forward,
            std::uint32_t instance, std::vector<DrawRange>& ranges)
      : chooser_(chooser),
        tree_(*chooser.tree_),
        eye_(eye),
        forward_(forward),
        instance_(instance),
        ranges_(ranges) {}

  void visit(const PreparedTree::Node& node) {
    const glm::dvec3 from_eye = node.centre - eye_;
    const double beyond_m = chooser_.cone_.beyond(from_eye, forward_);
    const double radius_m =
        0.8661 * node.size_m + chooser_.reach_ * std::min(node.size_m, chooser_.largest_cell_m_);
    if (beyond_m > radius_m) return;
    const double level_m = level_depth(from_eye, forward_);
    const double fineness = chooser_.fineness(level_m);
    if (!node.is_leaf() && must_divide(node, level_m, fineness, beyond_m > -radius_m)) {
      // Of two octants the one across a plane from the eye cannot hide the other; counting down
      // over the axes in which an octant differs from the eye's puts it first.
      const unsigned near = octant_of(eye_, node.centre);
      for (unsigned step = 8; step-- > 0;) {
        const std::int32_t child = node.children[near ^ step];
        if (child >= 0) visit(tree_.nodes()[std::size_t(child)]);
      }
      return;
    }
    draw(node, fineness);
  }

 private:
  // The coarsest cut that may draw a node of this fineness and lies within it.
  int cut_for(const PreparedTree::Node& node, std::size_t step) const {
    int cut = chooser_.steps_[step].cut;
    while (!tree_.run(node, cut).whole) ++cut;
    return cut;
  }

  // Nodes are as small as the finest level asks for that shows anywhere in them, so that where they
  // are divided does not hang on a level that is just about to show.
  bool must_divide(const PreparedTree::Node& node, double depth, double fineness,
                   bool cone_cuts) const {
    const double reach = 0.8661 * node.size_m;
    const double finest = chooser_.fineness(depth - reach);
    const int finest_cut = chooser_.steps_[std::size_t(std::ceil(finest))].cut;
    const int levels = tree_.level_of_cut(finest_cut).level - node.depth;  // in the node
    if (levels <= kLevelsOfNode) return false;
    const PreparedTree::Run& run = tree_.run(node, chooser_.steps_[std::size_t(fineness)].cut);
    if (!run.whole) return false;
    if (cone_cuts && run.count > kCheapOutside) return true;
    if (axes_inside(eye_, node) != 0 && run.count > kCheapTwice) return true;
    return levels > kLevelsOfEven && finest - chooser_.fineness(depth + reach) > kEvenFineness;
  }

  void draw(const PreparedTree::Node& node, double fineness) {
    const auto step = std::size_t(fineness);
    const auto fine_share = float(smooth(fineness - double(step)));
    const int coarse = cut_for(node, step);
    const bool pure = fine_share <= 0.0f || step + 1 >= chooser_.steps_.size();
    const int fine = pure ? coarse : cut_for(node, step + 1);
    if (coarse == fine) return draw_cut(node, coarse, 1.0f);
    draw_cut(node, coarse, 1.0f - fine_share);
    draw_cut(node, fine, fine_share);
  }

  // Where the eye is between a node's sides, its planes part the node, and the parts see the eye in
  // different octants. A cell that a plane cuts belongs to the low part, which therefore comes
  // after the high one.
  void draw_cut(const PreparedTree::Node& node, int cut, float fade) {
    const PreparedTree::Run& run = tree_.run(node, cut);
    if (run.count == 0) return;
    const unsigned split = run.count > 1 ? axes_inside(eye_, node) : 0;
    const unsigned fixed = octant_of(eye_, node.centre) & ~split;
    for (unsigned low = 0;; low = (low - split) & split) {  // through all subsets, ascending
      append_merged(range_of(run, fixed | low, split, split & ~low, cut, fade), ranges_);
      if (low == split) break;
    }
  }

  DrawRange range_of(const PreparedTree::Run& run, unsigned eye_octant, unsigned split,
                     unsigned high, int cut, float fade) const {
    const bool backwards = eye_octant >= 4;
    DrawRange range;
    range.instance = instance_;
    range.first = backwards ? run.first[7 - eye_octant] + run.count - 1 : run.first[eye_octant];
    range.count = run.count;
    range.backwards = backwards ? 1 : 0;
    range.split = std::uint8_t(split);
    range.high = std::uint8_t(high);
    range.cut = std::uint8_t(cut);
    range.fade = fade;
    return range;
  }

  const RangeChooser& chooser_;
  const PreparedTree& tree_;
  glm::dvec3 eye_, forward_;
  std::uint32_t instance_;
  std::vector<DrawRange>& ranges_;
};

double level_depth(const glm::dvec3& from_eye, const glm::dvec3& forward) {
  const double depth = glm::dot(from_eye, forward), squared = glm::dot(from_eye, from_eye);
  return depth > 0.0 && 4.0 * depth * depth >= squared ? depth : 0.5 * std::sqrt(squared);
}

RangeChooser::RangeChooser(const PreparedTree& tree, double focal_px, const DrawOptions& options)
    : tree_(&tree), cone_(options.half_angle) {
  double widest_side = 1.0;
  const double dissolve = std::max(options.dissolve, 1.0);
  per_log_depth_ = 1.0 / std::log(dissolve);  // not used when levels change at once
  for (int cut = 0; cut < tree.cut_count(); ++cut) {
    const TreeLevel& level = tree.level_of_cut(cut);
    widest_side = std::max(widest_side, double(level.side_factor));
    if (options.only_level >= 0) {
      if (options.only_level == level.level) steps_ = {{cut, 0.0, 0.0}};
      continue;
    }
    const bool finest = cut + 1 == tree.cut_count();
    if (!finest && !(level.max_cell_px > 0.0f)) continue;
    const double cell_m = std::ldexp(tree.model().size_m, -level.level);
    const double depth =
        finest ? 0.0 : options.detail * focal_px * cell_m / double(level.max_cell_px);
    // A level that would not stand alone before the one above is gone is never drawn
    if (!finest && !steps_.empty() && depth > steps_.back().gone_depth) continue;
    steps_.push_back({cut, depth, depth / dissolve});
  }
  reach_ = 0.7072 * widest_side;
  if (!steps_.empty())
    largest_cell_m_ = std::ldexp(tree.model().size_m, -tree.level_of_cut(steps_[0].cut).level);
}

double RangeChooser::fineness(double depth) const {
  for (std::size_t at = 0; at + 1 < steps_.size(); ++at) {
    if (depth >= steps_[at].whole_depth) return double(at);
    if (depth > steps_[at].gone_depth) {
      return double(at) + std::log(steps_[at].whole_depth / depth) * per_log_depth_;
    }
  }
  return double(steps_.size() - 1);
}

void RangeChooser::append(const glm::dvec3& eye, const glm::dvec3& forward, std::uint32_t instance,
                          std::vector<DrawRange>& ranges) const {
  if (steps_.empty() || tree_->nodes().empty()) return;
  RangeWalk(*this, eye, forward, instance, ranges).visit(tree_->nodes().front());
}

double RangeChooser::billboards_at(double depth) const {
  if (steps_.empty() || tree_->nodes().empty()) return 0.0;
  const double at = fineness(depth);
  const auto step = std::size_t(at);
  const auto count = [&](std::size_t i) {
    return double(tree_->run(tree_->nodes().front(), steps_[i].cut).count);
  };
  return at > double(step) ? count(step) + count(step + 1) : count(step);
}

std::vector<DrawRange> make_draw_list(const PreparedTree& tree, const Viewpoint& viewpoint,
                                      const DrawOptions& options) {
  std::vector<DrawRange> ranges;
  RangeChooser(tree, viewpoint.focal_px, options)
      .append(viewpoint.eye, viewpoint.forward, 0, ranges);
  return ranges;
}

glm::ivec3 eye_cell(const PreparedTree& tree, const glm::dvec3& eye) {
  const double side = std::ldexp(1.0, tree.finest_level());
  const glm::dvec3 cell = (eye - tree.model().origin) * (side / tree.model().size_m);
  return glm::ivec3(glm::clamp(glm::floor(cell), -1.0, side));
}

}  // namespace bosk
