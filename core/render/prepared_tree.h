#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/package/tree_model.h"

namespace bosk {

// One billboard: levels[slot].cells[cell].
struct CellName {
  std::uint32_t slot = 0, cell = 0;
};

// A tree made ready for drawing without sorting. For each level there is a cut through the octree:
// the level's own cells; where it has none, the coarsest finer ones; and coarser cells that have
// nothing finer below. Each cut covers the tree once. Its cells are listed in the eight orders of
// octants, far to near, that an eye can ask for; an order backwards is that of the opposite octant,
// so four are kept.
class PreparedTree {
 public:
  // Keeps a pointer to the model, which must stay alive and unchanged (max_cell_px may change).
  // Levels without cells or views are passed over.
  explicit PreparedTree(const TreeModel& model);

  const TreeModel& model() const { return *model_; }

  // Cells are numbered through all levels, coarse to fine.
  std::uint32_t cell_count() const { return first_cells_.back(); }
  CellName name_of(std::uint32_t number) const;

  // Numbers of cells, all cuts and orders one after the other.
  std::span<const std::uint32_t> order_table() const { return table_; }

  // The cells of a cut in a node of the octree. `first` are positions in the table: of the farthest
  // cell for eyes in octants 0 to 3 (bit per axis, x lowest: the eye is on the high side).
  struct Run {
    std::array<std::uint32_t, 4> first{};
    std::uint32_t count = 0;
    bool whole = true;  // the cells lie within the node; else one larger cell holds it
  };

  struct Node {
    std::array<std::int32_t, 8> children{-1, -1, -1, -1, -1, -1, -1, -1};  // by octant; -1: none
    glm::dvec3 centre{0.0};                                                // tree frame
    double size_m = 0.0;
    int depth = 0;
    std::uint32_t first_run = 0;  // of its cuts, coarse to fine

    bool is_leaf() const {
      for (const std::int32_t child : children)
        if (child >= 0) return false;
      return true;
    }
  };
  // Node 0 is the root; none for a tree without cells. Leaves have 16 finest cells a side, or are
  // one cell.
  std::span<const Node> nodes() const { return nodes_; }
  const Run& run(const Node& node, int cut) const {
    return runs_[node.first_run + std::uint32_t(cut)];
  }

  // One cut for each level that has cells and views, coarse to fine.
  int cut_count() const { return int(cut_slots_.size()); }
  const TreeLevel& level_of_cut(int cut) const {
    return model_->levels[cut_slots_[std::size_t(cut)]];
  }
  int finest_level() const { return finest_level_; }

  // The box of all leaves, tree frame.
  const glm::dvec3& lower() const { return lower_; }
  const glm::dvec3& upper() const { return upper_; }

 private:
  friend class NodeBuilder;

  const TreeModel* model_;
  std::vector<std::uint32_t> first_cells_;  // number of each slot's first cell, and of all cells
  std::vector<std::uint32_t> table_;
  std::vector<std::uint32_t> cut_slots_;
  std::vector<Node> nodes_;
  std::vector<Run> runs_;
  int finest_level_ = 0;
  glm::dvec3 lower_{0.0}, upper_{0.0};
};

}  // namespace bosk
