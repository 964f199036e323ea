#include "core/render/draw_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/render/billboard_geometry.h"

namespace bosk {
namespace {

constexpr std::size_t kMostLevels = 22;  // a 64-bit Morton code holds levels 0 to 21

// Cells of one level inside a node: positions in TreeLevel::cells, which Morton order keeps
// together.
struct CellRange {
  std::uint32_t first = 0, last = 0;
  bool empty() const { return first == last; }
};
using CellRanges = std::array<CellRange, kMostLevels>;  // per slot

struct Node {
  int depth = 0;
  glm::dvec3 centre{0.0};
  double size_m = 0.0;
};

// Octant `octant` of a cell range whose codes share all bits above the three at `shift`.
std::array<std::uint32_t, 9> octant_bounds(const std::vector<std::uint64_t>& cells,
                                           const CellRange& range, int shift) {
  std::array<std::uint32_t, 9> bounds;
  std::uint32_t at = range.first;
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    bounds[octant] = at;
    if (range.last - at > 32) {
      const auto next =
          std::partition_point(cells.begin() + at, cells.begin() + range.last,
                               [&](std::uint64_t code) { return ((code >> shift) & 7) <= octant; });
      at = std::uint32_t(next - cells.begin());
    } else {
      while (at < range.last && ((cells[at] >> shift) & 7) == octant) ++at;
    }
  }
  bounds[8] = range.last;
  return bounds;
}

// Walks the octree from the far octants to the near ones and writes a cut through its levels.
class Walk {
 public:
  Walk(const TreeModel& model, const Viewpoint& viewpoint, const DrawOptions& options)
      : model_(model), viewpoint_(viewpoint), options_(options) {
    cone_cosine_ = std::cos(options.half_angle);
    cone_sine_ = std::sin(options.half_angle);
    for (const TreeLevel& level : model.levels) {
      pickers_.emplace_back(model, level, options.blend);
      widest_side_ = std::max(widest_side_, double(level.side_factor));
    }
  }

  DrawList list() {
    CellRanges ranges{};
    slots_ = std::min(model_.levels.size(), kMostLevels);
    for (std::size_t slot = 0; slot < slots_; ++slot) {
      const TreeLevel& level = model_.levels[slot];
      if (options_.only_level >= 0 && options_.only_level != level.level) continue;
      if (level.views.empty()) continue;
      ranges[slot].last = std::uint32_t(level.cells.size());
    }
    visit({0, model_.origin + 0.5 * model_.size_m, model_.size_m}, 0, ranges);
    return std::move(list_);
  }

 private:
  // `slot` is the first whose level is at least the node's depth.
  void visit(const Node& node, std::size_t slot, const CellRanges& ranges) {
    if (outside_cone(node)) return;
    if (slot < slots_ && model_.levels[slot].level == node.depth) {
      const bool finer = has_cells(ranges, slot + 1);
      if (!ranges[slot].empty() && (!finer || small_enough(node, slot))) {
        draw(node, slot, ranges[slot].first);
        return;
      }
      ++slot;
    }
    if (has_cells(ranges, slot)) visit_children(node, slot, ranges);
  }

  void visit_children(const Node& node, std::size_t slot, const CellRanges& ranges) {
    std::array<std::array<std::uint32_t, 9>, kMostLevels> bounds;
    for (std::size_t s = slot; s < slots_; ++s) {
      const int shift = 3 * (model_.levels[s].level - node.depth - 1);
      bounds[s] = octant_bounds(model_.levels[s].cells, ranges[s], shift);
    }
    // The octant of the eye comes last. Of two octants the one across a plane from the eye cannot
    // hide the other; counting down over the axes in which an octant differs from the eye's puts it
    // first.
    const unsigned eye_octant = unsigned(viewpoint_.eye.x > node.centre.x) |
                                unsigned(viewpoint_.eye.y > node.centre.y) << 1 |
                                unsigned(viewpoint_.eye.z > node.centre.z) << 2;
    for (unsigned step = 8; step-- > 0;) {
      const unsigned octant = eye_octant ^ step;
      CellRanges inside;
      for (std::size_t s = slot; s < slots_; ++s)
        inside[s] = {bounds[s][octant], bounds[s][octant + 1]};
      if (has_cells(inside, slot)) visit(child(node, octant), slot, inside);
    }
  }

  static Node child(const Node& node, unsigned octant) {
    const glm::dvec3 side(octant & 1 ? 1.0 : -1.0, octant & 2 ? 1.0 : -1.0,
                          octant & 4 ? 1.0 : -1.0);
    return {node.depth + 1, node.centre + side * (0.25 * node.size_m), 0.5 * node.size_m};
  }

  bool has_cells(const CellRanges& ranges, std::size_t slot) const {
    for (; slot < slots_; ++slot)
      if (!ranges[slot].empty()) return true;
    return false;
  }

  // By a sphere around the node and the billboards of the cells inside it.
  bool outside_cone(const Node& node) const {
    const double radius = node.size_m * (0.8661 + 0.7072 * widest_side_);
    const glm::dvec3 from_eye = node.centre - viewpoint_.eye;
    const double along = glm::dot(from_eye, viewpoint_.forward);
    const double across = std::sqrt(std::max(0.0, glm::dot(from_eye, from_eye) - along * along));
    return across * cone_cosine_ - along * cone_sine_ > radius;
  }

  // Planes of equal depth part the levels, as in Linz et al. 2006, section 3.1.
  bool small_enough(const Node& node, std::size_t slot) const {
    const double depth = glm::dot(node.centre - viewpoint_.eye, viewpoint_.forward);
    const double size_px = options_.detail * viewpoint_.focal_px * node.size_m;
    return size_px <= double(model_.levels[slot].max_cell_px) * depth;
  }

  void draw(const Node& node, std::size_t slot, std::uint32_t cell) {
    const TreeLevel& level = model_.levels[slot];
    const double side_m = node.size_m * double(level.side_factor);
    const glm::dvec3 from_eye = node.centre - viewpoint_.eye;
    if (!(glm::dot(from_eye, from_eye) > 0.25 * side_m * side_m)) return;
    ViewBlend blend = pickers_[slot].pick(node.centre, viewpoint_.eye);
    if (blend.a >= level.views.size()) return;
    // A texture is pruned where the cell is hidden from its view: it must not thin the other one.
    const bool no_a = is_pruned(level, cell, blend.a);
    const bool no_b = blend.b == blend.a ? no_a : is_pruned(level, cell, blend.b);
    if (no_a && no_b) return;
    if (no_a) blend = {blend.b, blend.b, 0.0f};
    if (no_b) blend = {blend.a, blend.a, 0.0f};
    list_.push_back({std::uint32_t(slot), cell, blend.a, blend.b, blend.weight_b});
  }

  const TreeModel& model_;
  const Viewpoint& viewpoint_;
  const DrawOptions& options_;
  std::vector<ViewPicker> pickers_;  // per slot
  std::size_t slots_ = 0;
  double widest_side_ = 1.0, cone_cosine_ = 0.0, cone_sine_ = 1.0;
  DrawList list_;
};

}  // namespace

bool is_pruned(const TreeLevel& level, std::uint32_t cell, std::uint32_t view) {
  const std::size_t blocks = std::size_t(level.texels / 4) * std::size_t(level.texels / 4);
  const std::size_t first = (std::size_t(cell) * level.views.size() + view) * blocks;
  return std::all_of(level.alpha_indices.begin() + std::ptrdiff_t(first),
                     level.alpha_indices.begin() + std::ptrdiff_t(first + blocks),
                     [](std::uint16_t index) { return index == kPruned; });
}

DrawList make_draw_list(const TreeModel& model, const Viewpoint& viewpoint,
                        const DrawOptions& options) {
  return Walk(model, viewpoint, options).list();
}

}  // namespace bosk
