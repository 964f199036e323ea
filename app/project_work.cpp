#include "app/project_work.h"

#include <algorithm>

#include "core/project/cache.h"
#include "core/project/calibration_run.h"

namespace bosk {
namespace {

constexpr double kShareOfCameras = 0.15;  // of a run that finds them as well

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
  if (project_.cameras.empty()) {
    find_cameras();
  } else {
    capture_ = gather_capture(project_);
  }
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
  const auto behind = [&](double of_rest) { return done_ + (1.0 - done_) * of_rest; };
  return run_stages(project_, capture, wanted, console_.progress(),
                    {behind(share.from), behind(share.to)});
}

void ProjectWork::find_cameras() {
  const CalibrationSources sources = gather_calibration(project_);
  const Cache cache(project_.cache_folder());
  auto calibration = stored_calibration(sources, cache);
  if (!calibration) {
    lock();
    done_ = kShareOfCameras;
    console_.progress().scope(0.0, done_, "Cameras");
    calibration = run_calibration(sources, cache, console_.progress());
    for (const std::string& sentence : calibration->sentences) console_.warn(sentence);
  }
  require_cameras(*calibration);
  capture_ = gather_capture(project_, *calibration);
}

void ProjectWork::lock() {
  if (lock_) return;
  lock_.emplace(project_.folder);
  Cache(project_.cache_folder()).sweep();
}

}  // namespace bosk
