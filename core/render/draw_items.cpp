#include <algorithm>

#include "core/render/billboard_geometry.h"
#include "core/render/draw_list.h"

namespace bosk {
namespace {

class Expander {
 public:
  Expander(const PreparedTree& tree, const glm::dvec3& eye, BlendRule blend)
      : tree_(tree), model_(tree.model()), eye_(eye), eye_cell_(eye_cell(tree, eye)) {
    for (const TreeLevel& level : model_.levels) pickers_.emplace_back(model_, level, blend);
  }

  void append(const DrawRange& range, std::vector<DrawItem>& items) const {
    for (std::uint32_t i = 0; i < range.count; ++i) {
      const std::uint32_t entry = range.backwards ? range.first - i : range.first + i;
      const CellName name = tree_.name_of(tree_.order_table()[entry]);
      const TreeLevel& level = model_.levels[name.slot];
      if (range.split != 0 && !in_half(range, level, level.cells[name.cell])) continue;
      append_item(name, level, range.fade, items);
    }
  }

 private:
  bool in_half(const DrawRange& range, const TreeLevel& level, std::uint64_t code) const {
    const glm::ivec3 corner = glm::ivec3(cell_from_morton(code))
                              << (tree_.finest_level() - level.level);
    for (int axis = 0; axis < 3; ++axis) {
      if ((range.split >> axis & 1) == 0) continue;
      if ((corner[axis] > eye_cell_[axis]) != ((range.high >> axis & 1) != 0)) return false;
    }
    return true;
  }

  void append_item(const CellName& name, const TreeLevel& level, float fade,
                   std::vector<DrawItem>& items) const {
    const glm::dvec3 centre = cell_centre_in_world(model_, level.level, level.cells[name.cell]);
    const double side_m = cell_size_m(model_, level.level) * double(level.side_factor);
    const glm::dvec3 from_eye = centre - eye_;
    if (!(glm::dot(from_eye, from_eye) > 0.25 * side_m * side_m)) return;
    ViewBlend blend = pickers_[name.slot].pick(centre, eye_);
    const bool no_a = is_pruned(level, name.cell, blend.a);
    const bool no_b = blend.b == blend.a ? no_a : is_pruned(level, name.cell, blend.b);
    if (no_a && no_b) return;
    if (no_a) blend = {blend.b, blend.b, 0.0f};
    if (no_b) blend = {blend.a, blend.a, 0.0f};
    items.push_back({name.slot, name.cell, blend.a, blend.b, blend.weight_b, fade});
  }

  const PreparedTree& tree_;
  const TreeModel& model_;
  glm::dvec3 eye_;
  glm::ivec3 eye_cell_;
  std::vector<ViewPicker> pickers_;  // per slot
};

}  // namespace

std::vector<DrawItem> draw_items(const PreparedTree& tree, const std::vector<DrawRange>& ranges,
                                 const glm::dvec3& eye, BlendRule blend) {
  std::vector<DrawItem> items;
  const Expander expander(tree, eye, blend);
  for (const DrawRange& range : ranges) expander.append(range, items);
  return items;
}

bool is_pruned(const TreeLevel& level, std::uint32_t cell, std::uint32_t view) {
  const std::size_t blocks = std::size_t(level.texels / 4) * std::size_t(level.texels / 4);
  const std::size_t first = (std::size_t(cell) * level.views.size() + view) * blocks;
  return std::all_of(level.alpha_indices.begin() + std::ptrdiff_t(first),
                     level.alpha_indices.begin() + std::ptrdiff_t(first + blocks),
                     [](std::uint16_t index) { return index == kPruned; });
}

}  // namespace bosk
