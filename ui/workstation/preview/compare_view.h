#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/matte/matte.h"
#include "ui/widgets/image_view.h"
#include "ui/workstation/preview/comparison.h"

namespace bosk {

struct Workspace;
struct Evaluation;

// How photo and render are shown.
enum class CompareMode { photo, render, wipe, blend, side_by_side, difference };

// Which view is compared: a photo that the package was made from, or one of those held out, with
// the package of the rest.
struct ComparedView {
  std::string name;
  bool held_out = false;
  auto operator<=>(const ComparedView&) const = default;
};

// A package read for drawing where its cameras are.
struct ReadTree {
  explicit ReadTree(TreeModel tree_model) : model(std::move(tree_model)), prepared(model) {}
  ReadTree(const ReadTree&) = delete;
  ReadTree& operator=(const ReadTree&) = delete;

  TreeModel model;
  PreparedTree prepared;
};

struct KeptComparison {
  std::shared_ptr<const Comparison> comparison;
  std::uint64_t revision = 0;  // of its pictures
};

struct CompareState {
  ComparedView view;
  CompareMode mode = CompareMode::wipe;
  bool tree_alone = true;  // the photo cut out by its matte, over white
  float divider = 0.5f;    // of the area's width, wipe
  float blend = 0.5f;      // share of the render
  ImageView part;          // zoom and pan, of all modes

  // Comparisons made, and what they were made from
  std::map<ComparedView, KeptComparison> kept;
  std::vector<ComparedView> order;  // oldest first
  std::shared_ptr<const std::vector<std::byte>> package;
  std::shared_ptr<const std::vector<Matte>> mattes;
  std::shared_ptr<const Evaluation> evaluation;
  std::shared_ptr<const ReadTree> tree;
  ComparedView asked;
  std::uint64_t last_revision = 0;
};

// The list of views and the chosen one, photo against render.
void draw_compare(Workspace& workspace);

// Parts of it: starts what is missing for the chosen view and gives it once it is there; draws it.
const KeptComparison* follow_comparison(Workspace& workspace);
void draw_comparison(Workspace& workspace, const KeptComparison& kept);

}  // namespace bosk
