// Comparisons for the panel: made in jobs, kept for the views looked at lately.

#include <algorithm>

#include "core/package/reader.h"
#include "ui/workstation/preview/compare_view.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr std::size_t kMostKept = 8;

struct MadeComparison {
  std::shared_ptr<const ReadTree> tree;
  std::shared_ptr<const Comparison> comparison;
};

// Forgets what was made from other results.
void follow_results(Workspace& workspace) {
  CompareState& state = workspace.preview.compare;
  const auto& evaluation = workspace.preview.held_out.evaluation;
  if (state.package == workspace.results.package && state.mattes == workspace.results.mattes &&
      state.evaluation == evaluation) {
    return;
  }
  if (state.package != workspace.results.package) state.tree.reset();
  state.package = workspace.results.package;
  state.mattes = workspace.results.mattes;
  state.evaluation = evaluation;
  state.kept.clear();
  state.order.clear();
  state.asked = {};
}

const KeptComparison* keep(CompareState& state, const ComparedView& view,
                           std::shared_ptr<const Comparison> comparison) {
  std::erase(state.order, view);
  state.order.push_back(view);
  if (state.order.size() > kMostKept) {
    state.kept.erase(state.order.front());
    state.order.erase(state.order.begin());
  }
  return &(state.kept[view] = {std::move(comparison), ++state.last_revision});
}

const KeptComparison* held_out_comparison(CompareState& state) {
  if (!state.evaluation) return nullptr;
  const auto& scores = state.evaluation->scores.views;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (scores[i].name != state.view.name) continue;
    const SheetRow& row = state.evaluation->views[i];
    return keep(state, state.view,
                std::make_shared<const Comparison>(Comparison{
                    shown_over_white(row.truth), row.truth, row.rendered, scores[i].score}));
  }
  return nullptr;
}

const Photo* photo_named(const Photos& photos, const std::string& name) {
  const auto found = std::find_if(photos.begin(), photos.end(),
                                  [&](const Photo& photo) { return photo.name == name; });
  return found == photos.end() ? nullptr : &*found;
}

void start(Workspace& workspace) {
  CompareState& state = workspace.preview.compare;
  const Results& results = workspace.results;
  if (!results.views || !results.mattes) return;
  state.asked = state.view;
  workspace.jobs.start(
      "Drawing what " + state.view.name + " shows",
      [views = results.views, mattes = results.mattes, imported = results.imported,
       package = results.package, name = state.view.name,
       tree = state.tree](Progress& progress) -> MadeComparison {
        progress.begin("reading the package", 1, 0.0, 0.1);
        MadeComparison made{tree, nullptr};
        if (!made.tree) made.tree = std::make_shared<const ReadTree>(read_tree(*package, name));
        const Photo* view = photo_named(*views, name);
        const Photo* photo = imported ? photo_named(imported->photos, name) : nullptr;
        const auto matte = std::find_if(mattes->begin(), mattes->end(),
                                        [&](const Matte& one) { return one.name == name; });
        if (!view || matte == mattes->end()) return made;
        const ProgressPart part(progress, 0.1, 1.0);
        made.comparison = std::make_shared<const Comparison>(
            compare_with_photo(made.tree->prepared, *view, photo ? photo->srgb : Image<glm::vec3>(),
                               matte->rgba, progress));
        return made;
      },
      [&state, package = results.package, view = state.view](const MadeComparison& made) {
        if (state.package != package) return;  // another one is shown by now
        state.tree = made.tree;
        if (made.comparison) keep(state, view, made.comparison);
      },
      Lane::interactive, "preview compare");
}

}  // namespace

const KeptComparison* follow_comparison(Workspace& workspace) {
  follow_results(workspace);
  CompareState& state = workspace.preview.compare;
  const auto kept = state.kept.find(state.view);
  if (kept != state.kept.end()) return &kept->second;
  if (state.view.held_out) return held_out_comparison(state);
  if (state.asked != state.view) start(workspace);
  return nullptr;
}

}  // namespace bosk
