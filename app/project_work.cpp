#include "app/project_work.h"

#include <algorithm>

#include "core/project/cache.h"

namespace bosk {
namespace {

std::string recipe_text(Recipe recipe) {
  std::string text;
  for (const OptionGroup& group : option_groups(recipe)) {
    text += group.stage + ": " + values_text(group.options) + "\n";
  }
  return text;
}

}  // namespace

ProjectWork::ProjectWork(const std::string& folder, const StageChoices& choices, Console& console)
    : project_(read_project(folder)), console_(console) {
  const std::string before = recipe_text(project_.recipe);
  set_options(choices, project_.recipe);
  if (recipe_text(project_.recipe) != before) {
    lock();
    project_ = read_project(folder);  // as it is now that nobody else may change it
    set_options(choices, project_.recipe);
    save_project(project_);
  }
  capture_ = gather_capture(project_);
  for (const std::string& remark : capture_.remarks) console_.warn(remark);
}

ProjectWork::ProjectWork(Project project, Console& console)
    : project_(std::move(project)), capture_(gather_capture(project_)), console_(console) {
  for (const std::string& remark : capture_.remarks) console_.warn(remark);
}

bool ProjectWork::is_finished(const std::string& stage) const {
  return bosk::is_finished(project_, capture_, stage);
}

Run ProjectWork::run(const Capture& capture, const std::vector<std::string>& wanted, Share share) {
  const bool all_there = std::all_of(wanted.begin(), wanted.end(), [&](const std::string& stage) {
    return bosk::is_finished(project_, capture, stage);
  });
  if (!all_there) lock();
  return run_stages(project_, capture, wanted, console_.progress(), share);
}

void ProjectWork::lock() {
  if (lock_) return;
  lock_.emplace(project_.folder);
  Cache(project_.cache_folder()).sweep();
}

}  // namespace bosk
