#include "core/render/prepared_tree.h"

#include <algorithm>
#include <limits>

#include "core/render/octree_cuts.h"

namespace bosk {
namespace {

constexpr int kLeafLevels = 4;  // a leaf has 2^4 finest cells a side
constexpr unsigned kOrders = 4;

// Cells [first, last) of a cut that lie in a node, or the one cell that holds it.
struct CutRange {
  std::size_t first = 0, last = 0;
};

}  // namespace

// Builds the nodes from the root down, with the places of their cells in every order.
class NodeBuilder {
 public:
  NodeBuilder(PreparedTree& tree, const std::vector<Cut>& cuts) : tree_(tree), cuts_(cuts) {}

  void build(const std::vector<std::array<std::uint32_t, kOrders>>& starts) {
    const TreeModel& model = tree_.model();
    PreparedTree::Node root;
    root.centre = model.origin + 0.5 * model.size_m;
    root.size_m = model.size_m;
    std::vector<CutRange> ranges;
    std::vector<PreparedTree::Run> runs;
    for (std::size_t cut = 0; cut < cuts_.size(); ++cut) {
      ranges.push_back({0, cuts_[cut].size()});
      runs.push_back({starts[cut], std::uint32_t(cuts_[cut].size()), true});
    }
    tree_.lower_ = glm::dvec3(std::numeric_limits<double>::infinity());
    tree_.upper_ = -tree_.lower_;
    add(root, ranges, runs);
  }

 private:
  std::int32_t add(PreparedTree::Node node, const std::vector<CutRange>& ranges,
                   const std::vector<PreparedTree::Run>& runs) {
    const auto number = std::int32_t(tree_.nodes_.size());
    node.first_run = std::uint32_t(tree_.runs_.size());
    tree_.runs_.insert(tree_.runs_.end(), runs.begin(), runs.end());
    tree_.nodes_.push_back(node);
    if (is_leaf(node, ranges.back())) {
      tree_.lower_ = glm::min(tree_.lower_, node.centre - 0.5 * node.size_m);
      tree_.upper_ = glm::max(tree_.upper_, node.centre + 0.5 * node.size_m);
      return number;
    }
    add_children(number, ranges, runs);
    return number;
  }

  bool is_leaf(const PreparedTree::Node& node, const CutRange& finest) const {
    if (node.depth >= tree_.finest_level_ - kLeafLevels) return true;
    return finest.last - finest.first == 1 && holds(cuts_.back()[finest.first], node.depth);
  }

  static bool holds(const CutCell& cell, int depth) { return int(cell.level) <= depth; }

  void add_children(std::int32_t number, const std::vector<CutRange>& ranges,
                    const std::vector<PreparedTree::Run>& runs) {
    const PreparedTree::Node node = tree_.nodes_[std::size_t(number)];
    std::array<std::vector<CutRange>, 8> child_ranges;
    std::array<std::vector<PreparedTree::Run>, 8> child_runs;
    for (std::size_t cut = 0; cut < cuts_.size(); ++cut)
      divide(node.depth, cut, ranges[cut], runs[cut], child_ranges, child_runs);
    for (unsigned octant = 0; octant < 8; ++octant) {
      if (child_runs[octant].back().count == 0) continue;
      PreparedTree::Node child;
      const glm::dvec3 side(octant & 1 ? 1.0 : -1.0, octant & 2 ? 1.0 : -1.0,
                            octant & 4 ? 1.0 : -1.0);
      child.centre = node.centre + side * (0.25 * node.size_m);
      child.size_m = 0.5 * node.size_m;
      child.depth = node.depth + 1;
      const std::int32_t added = add(child, child_ranges[octant], child_runs[octant]);
      tree_.nodes_[std::size_t(number)].children[octant] = added;
    }
  }

  // A cut's cells among the octants of a node at `depth`.
  void divide(int depth, std::size_t cut, const CutRange& range, const PreparedTree::Run& run,
              std::array<std::vector<CutRange>, 8>& child_ranges,
              std::array<std::vector<PreparedTree::Run>, 8>& child_runs) const {
    const Cut& cells = cuts_[cut];
    if (run.count == 1 && holds(cells[range.first], depth)) {
      for (unsigned octant = 0; octant < 8; ++octant) {
        child_ranges[octant].push_back(range);
        child_runs[octant].push_back({run.first, 1, false});
      }
      return;
    }
    const int shift = 3 * (tree_.finest_level_ - depth - 1);
    std::array<PreparedTree::Run, 8> parts{};
    std::size_t at = range.first;
    for (unsigned octant = 0; octant < 8; ++octant) {
      const auto begin = cells.begin() + std::ptrdiff_t(at);
      const auto next = std::partition_point(
          begin, cells.begin() + std::ptrdiff_t(range.last),
          [&](const CutCell& cell) { return ((cell.code >> shift) & 7) <= octant; });
      parts[octant].count = std::uint32_t(next - begin);
      child_ranges[octant].push_back({at, at + parts[octant].count});
      at += parts[octant].count;
    }
    for (unsigned eye = 0; eye < kOrders; ++eye) {
      std::uint32_t place = run.first[eye];
      for (unsigned step = 8; step-- > 0;) {
        parts[eye ^ step].first[eye] = place;
        place += parts[eye ^ step].count;
      }
    }
    for (unsigned octant = 0; octant < 8; ++octant) child_runs[octant].push_back(parts[octant]);
  }

  PreparedTree& tree_;
  const std::vector<Cut>& cuts_;
};

PreparedTree::PreparedTree(const TreeModel& model) : model_(&model), first_cells_{0} {
  for (std::uint32_t slot = 0; slot < model.levels.size(); ++slot) {
    const TreeLevel& level = model.levels[slot];
    first_cells_.push_back(first_cells_.back() + std::uint32_t(level.cells.size()));
    if (!level.cells.empty() && !level.views.empty()) cut_slots_.push_back(slot);
  }
  if (cut_slots_.empty()) return;
  finest_level_ = model.levels[cut_slots_.back()].level;
  const std::vector<Cut> cuts = octree_cuts(model, cut_slots_, first_cells_);
  std::size_t entries = 0;
  for (const Cut& cut : cuts) entries += kOrders * cut.size();
  table_.reserve(entries);
  std::vector<std::array<std::uint32_t, kOrders>> starts(cuts.size());
  for (std::size_t cut = 0; cut < cuts.size(); ++cut) {
    for (unsigned eye = 0; eye < kOrders; ++eye) {
      starts[cut][eye] = std::uint32_t(table_.size());
      append_order(cuts[cut], eye, finest_level_, table_);
    }
  }
  NodeBuilder(*this, cuts).build(starts);
}

CellName PreparedTree::name_of(std::uint32_t number) const {
  const auto next = std::upper_bound(first_cells_.begin(), first_cells_.end(), number);
  const auto slot = std::uint32_t(next - first_cells_.begin()) - 1;
  return {slot, number - first_cells_[slot]};
}

}  // namespace bosk
