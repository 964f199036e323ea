#include "ui/workstation/workspace.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/project/cache.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/capture_files.h"
#include "ui/workstation/matte/matte_paint.h"
#include "ui/workstation/stage_run.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

// Takes over what `from` holds.
void merge(Results& into, const Results& from) {
  const auto take = [](auto& mine, const auto& other) {
    if (other) mine = other;
  };
  take(into.imported, from.imported);
  take(into.views, from.views);
  take(into.mattes, from.mattes);
  take(into.opacity, from.opacity);
  take(into.radiance, from.radiance);
  take(into.billboards, from.billboards);
  take(into.textures, from.textures);
  take(into.package, from.package);
}

// Results that were made from just what the project asks for.
Results current_results(const Workspace& workspace) {
  Results results = workspace.results;
  for (const Stage& stage : stages()) {
    if (state_of(workspace, stage.name) != StageState::current) stage.let_go(results);
  }
  return results;
}

struct Made {
  Recipe asked;  // what the run began with
  Run run;
  std::map<std::string, ContentHash> keys;
};

void install(Workspace& workspace, Made made) {
  merge(workspace.results, made.run.results);
  for (const auto& [stage, key] : made.keys) {
    if (!stage_named(stage).is_held(made.run.results)) continue;
    workspace.made[stage] = key;
    workspace.made_with[stage] = made.keys;
  }
  const std::string next = std::exchange(workspace.waiting_stage, {});
  apply_what_was_used(workspace, made.asked, made.run.recipe);
  workspace.seen_revision.reset();  // what is stored may have changed
  if (next.empty()) return;
  refresh(workspace);
  run_to(workspace, next);
}

void start_run(Workspace& workspace, const std::string& title, const std::string& stage,
               const std::vector<std::string>& wanted) {
  auto project = std::make_shared<const Project>(workspace.project());
  workspace.running_stage = stage;
  workspace.running_key = workspace.wanted.at(stage);
  workspace.running_job = workspace.jobs.start(
      title,
      [project, capture = workspace.capture, wanted, watchers = watchers_of(workspace),
       known = current_results(workspace)](Progress& progress) {
        Made made;
        made.asked = project->recipe;
        made.run = run_stages(*project, *capture, wanted, progress, {}, watchers, known);
        made.keys = stage_keys(*capture, made.run.recipe);
        return made;
      },
      [&workspace](Made made) { install(workspace, std::move(made)); });
}

// Whether a job is at work on a result that the project still asks for.
bool is_wanted_work(const Workspace& workspace) {
  if (workspace.running_job == 0) return false;
  const auto wanted = workspace.wanted.find(workspace.running_stage);
  return wanted != workspace.wanted.end() && wanted->second == workspace.running_key;
}

bool is_made_on_the_way_to(const std::string& last, const std::string& stage) {
  if (last.empty()) return false;
  const auto stages = stages_up_to(last);
  return std::count(stages.begin(), stages.end(), stage) > 0;
}

// Brings keys and what the cache holds up to date with the project.
void refresh_keys(Workspace& workspace) {
  workspace.wanted.clear();
  workspace.stored.clear();
  if (!workspace.session || !workspace.capture) return;
  workspace.wanted = stage_keys(*workspace.capture, workspace.project().recipe);
  const Cache cache(workspace.project().cache_folder());
  for (const auto& [stage, key] : workspace.wanted) {
    workspace.stored[stage] = cache.contains(stage, key);
  }
}

}  // namespace

bool WindowInput::pressed(int key) const {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::vector<ImVec2> WindowInput::stroke_places(bool began) const {
  const std::size_t first = began ? pressed_at.value_or(mouse_path.size()) : 0;
  std::size_t end = mouse_path.size();
  if (released_at && *released_at >= first) end = std::min(end, *released_at + 1);
  if (first >= mouse_path.size()) {
    return began ? std::vector<ImVec2>{ImGui::GetIO().MousePos} : std::vector<ImVec2>();
  }
  return {mouse_path.begin() + std::ptrdiff_t(first), mouse_path.begin() + std::ptrdiff_t(end)};
}

bool WindowInput::ends_stroke(bool began) const {
  const bool up_again = released_at && (!began || *released_at > pressed_at.value_or(0));
  return up_again || !ImGui::GetIO().MouseDown[ImGuiMouseButton_Left];
}

Workspace::Workspace(PictureDevice device, std::function<void()> wake, fs::path settings_folder)
    : pictures(std::move(device)),
      settings(read_settings(settings_folder)),
      settings_place(std::move(settings_folder)),
      jobs(std::move(wake)) {}

Workspace::~Workspace() {
  // Closing must not wait for the disk's errors to be told: the journal holds all of it
  try {
    close_project(*this);
  } catch (const Error&) {
  }
}

void open_project(Workspace& workspace, const fs::path& folder) {
  auto session = std::make_unique<Session>(folder);
  close_project(workspace);
  workspace.session = std::move(session);
  workspace.seen_revision.reset();
  workspace.seen_files = 0;
  remember(workspace.settings, folder);
  save_settings(workspace.settings, workspace.settings_place);
  workspace.step = WorkStep::photos;
  refresh(workspace);
}

void close_project(Workspace& workspace) {
  if (!workspace.session) return;
  keep_stroke_in_hand(workspace);
  workspace.jobs.cancel_all();
  workspace.session->save();
  workspace.session.reset();
  workspace.pictures.clear();  // the next project's have the same names
  workspace.capture.reset();
  workspace.results = {};
  workspace.made.clear();
  workspace.made_with.clear();
  workspace.wanted.clear();
  workspace.stored.clear();
  workspace.running_stage.clear();
  workspace.waiting_stage.clear();
  workspace.photos = {};
  workspace.calibrate = {};
  workspace.matte = {};
  workspace.volume = {};
  workspace.textures = {};
  workspace.codebook = {};
  workspace.preview = {};
  workspace.export_tree = {};
}

void edit(Workspace& workspace, Edit change) {
  workspace.session->apply(std::move(change));
  refresh(workspace);
}

void undo(Workspace& workspace) {
  if (workspace.session && workspace.session->can_undo()) workspace.session->undo();
  refresh(workspace);
}

void redo(Workspace& workspace) {
  if (workspace.session && workspace.session->can_redo()) workspace.session->redo();
  refresh(workspace);
}

void refresh(Workspace& workspace) {
  workspace.jobs.collect();
  if (workspace.running_job != 0 && !workspace.jobs.is_open(workspace.running_job)) {
    workspace.running_job = 0;
    workspace.running_stage.clear();
    workspace.waiting_stage.clear();  // its job was stopped or failed
    workspace.seen_revision.reset();
  }
  if (!workspace.session) return;
  const std::uint64_t revision = workspace.session->revision();
  if (revision == workspace.seen_revision) return;
  workspace.seen_revision = revision;
  follow_calibration(workspace);
  refresh_capture(workspace);
  refresh_keys(workspace);
}

float scale_of(const Workspace& workspace) {
  return workspace.settings.scale > 0.0 ? float(workspace.settings.scale) : workspace.screen_scale;
}

void ask_for_scale(Workspace& workspace, float scale) {
  workspace.scale_wanted = std::clamp(scale, kLeastScale, kLargestScale);
}

StageState state_of(const Workspace& workspace, const std::string& stage) {
  const auto wanted = workspace.wanted.find(stage);
  const auto made = workspace.made.find(stage);
  if (made != workspace.made.end()) {
    const bool same = wanted != workspace.wanted.end() && made->second == wanted->second;
    if (same) return StageState::current;
  }
  const auto stored = workspace.stored.find(stage);
  if (stored != workspace.stored.end() && stored->second) return StageState::stored;
  return made == workspace.made.end() ? StageState::missing : StageState::outdated;
}

bool is_shown(const Workspace& workspace, const std::string& stage) {
  return workspace.made.count(stage) > 0;
}

bool is_made_from(const Workspace& workspace, const std::string& stage, const std::string& input) {
  const auto with = workspace.made_with.find(stage);
  const auto made = workspace.made.find(input);
  if (with == workspace.made_with.end() || made == workspace.made.end()) return false;
  return with->second.at(input) == made->second;
}

bool is_running(const Workspace& workspace, const std::string& stage) {
  if (state_of(workspace, stage) == StageState::current) return false;
  return is_made_on_the_way_to(workspace.running_stage, stage) ||
         is_made_on_the_way_to(workspace.waiting_stage, stage);
}

bool waits(const Workspace& workspace, const std::string& stage) {
  return is_running(workspace, stage) && !is_made_on_the_way_to(workspace.running_stage, stage);
}

std::string obstacle_to_stages(const Workspace& workspace) {
  if (!workspace.session) return "open a project first";
  if (!workspace.capture) return workspace.capture_obstacle;
  return {};
}

void run_to(Workspace& workspace, const std::string& stage) {
  if (!obstacle_to_stages(workspace).empty() || is_running(workspace, stage)) return;
  if (is_wanted_work(workspace)) {
    workspace.waiting_stage = stage;
    return;
  }
  if (workspace.running_job != 0) workspace.jobs.cancel(workspace.running_job);
  start_run(workspace, title_of_stage(stage), stage, stages_up_to(stage));
}

void load_if_stored(Workspace& workspace, const std::string& stage) {
  if (workspace.running_job != 0 || state_of(workspace, stage) != StageState::stored) return;
  start_run(workspace, "Loading " + title_of_stage(stage), stage, {stage});
}

}  // namespace bosk
