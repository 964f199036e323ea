#include "ui/workstation/calibrate/solved_cameras.h"

#include <chrono>
#include <filesystem>

#include "core/base/error.h"
#include "core/calibrate/lens_pictures.h"
#include "core/project/calibration_refine.h"
#include "core/project/feature_finds.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

constexpr int kLensPicturePx = 480;  // their width

// What a job gives back; with trouble, what came before it.
struct Outcome {
  ContentHash files;
  std::shared_ptr<const CalibrationSources> sources = nullptr;
  std::shared_ptr<const CalibrationFinds> finds = nullptr;
  std::shared_ptr<const LensLook> lens_look = nullptr;
  std::shared_ptr<const Calibration> calibration = nullptr;
  ContentHash key = {};
  std::string trouble = {};
};

// What of the project says which files are looked through, and what for.
ContentHash files_of(const Project& project) {
  ContentHasher hasher;
  hasher.text(project.folder.string()).value(std::uint64_t(project.photos.size()));
  for (const fs::path& photo : project.photos) hasher.text(photo.string());
  hasher.text(project.calibration.boards.string()).text(project.calibration.lens.string());
  Recipe recipe = project.recipe;
  hasher.text(values_text(describe(recipe.calibrate))).text(values_text(describe(recipe.photo)));
  return hasher.finish();
}

// Of photos that were looked through before; without any no photo need be read to know.
bool holds_finds(const fs::path& cache_folder) {
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(cache_folder, failure)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("calibrate-") || name.starts_with("found-")) return true;
  }
  return false;
}

// A refusal is an answer; what throws is trouble.
void solve(Outcome& outcome, const Cache& cache, Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  outcome.key = calibration_key(*outcome.sources);
  auto stored = stored_calibration(*outcome.sources, cache);
  if (!stored) {
    stored = solve_calibration(*outcome.finds, *outcome.sources, progress);
    progress.check();
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    store_calibration(*outcome.sources, *stored, spent.count(), cache);
  }
  outcome.calibration = std::make_shared<const Calibration>(*std::move(stored));
}

template <class Work>
Outcome outcome_of(Outcome outcome, const Work& work) {
  try {
    work(outcome);
  } catch (const Error& error) {
    outcome.trouble = error.what();
  }
  return outcome;
}

Image<glm::u8vec4> opaque(const Image<glm::u8vec3>& picture) {
  Image<glm::u8vec4> shown(picture.width(), picture.height());
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) shown(x, y) = glm::u8vec4(picture(x, y), 255);
  }
  return shown;
}

LensLook look_of(const CalibrationFinds& finds) {
  if (!finds.boards) return {};
  return {opaque(coverage_picture(*finds.boards, kLensPicturePx)),
          opaque(uncertainty_picture(finds.boards->profile, kLensPicturePx, kFullUncertaintyPx))};
}

void find(Outcome& outcome, const CalibrationSources& sources, const Cache& cache,
          Progress& progress) {
  outcome.finds =
      std::make_shared<const CalibrationFinds>(find_for_calibration(sources, cache, progress));
  outcome.lens_look = std::make_shared<const LensLook>(look_of(*outcome.finds));
  outcome.sources = std::make_shared<const CalibrationSources>(sources);
}

Outcome found(const Project& project, Progress& progress) {
  return outcome_of({files_of(project)}, [&](Outcome& outcome) {
    const Cache cache(project.cache_folder());
    progress.begin("reading the photos", 1, 0.0, 0.05);
    const CalibrationSources sources = gather_calibration(project);
    {
      const ProgressPart part(progress, 0.05, 0.85);
      find(outcome, sources, cache, progress);
    }
    const ProgressPart part(progress, 0.85, 1.0);
    solve(outcome, cache, progress);
    outcome.calibration =
        std::make_shared<const Calibration>(calibrate_project(project, sources, cache, progress));
  });
}

// Of what was calibrated before, or found before and not solved to the end; nothing where it
// wasn't.
Outcome loaded(const Project& project, Progress& progress) {
  return outcome_of({files_of(project)}, [&](Outcome& outcome) {
    progress.begin("looking for an earlier calibration", 1);
    if (!holds_finds(project.cache_folder())) return;
    const Cache cache(project.cache_folder());
    const CalibrationSources sources = gather_calibration(project);
    if (!stored_calibration(sources, cache) && !was_found(sources, cache)) return;
    {
      const ProgressPart part(progress, 0.0, 0.5);
      find(outcome, sources, cache, progress);
    }
    const ProgressPart part(progress, 0.5, 1.0);
    solve(outcome, cache, progress);
  });
}

void take(SolvedCameras& solved, Outcome outcome) {
  if (outcome.finds) {
    solved.sources = std::move(outcome.sources);
    solved.finds = std::move(outcome.finds);
    if (outcome.lens_look) solved.lens_look = std::move(outcome.lens_look);
    solved.files = outcome.files;
  }
  if (outcome.calibration) {
    solved.calibration = std::move(outcome.calibration);
    solved.key = outcome.key;
  }
  solved.trouble = std::move(outcome.trouble);
  solved.asked = outcome.key;
  ++solved.revision;
}

// Starts a job whose outcome is of this project; `job` is the one to watch.
template <class Work>
void start(Workspace& workspace, WatchedJob SolvedCameras::*job, const std::string& title,
           Lane lane, Work work) {
  SolvedCameras& solved = workspace.calibrate.solved;
  solved.*job = {};
  (solved.*job).id = workspace.jobs.start(
      title, std::move(work),
      [&workspace, job, folder = workspace.project().folder](Outcome outcome) {
        if (!workspace.session || workspace.project().folder != folder) return;
        workspace.calibrate.solved.*job = {};
        take(workspace.calibrate.solved, std::move(outcome));
        workspace.seen_revision.reset();
      },
      lane, "calibration/" + title);
}

std::shared_ptr<const Project> copy_of(const Workspace& workspace) {
  return std::make_shared<const Project>(workspace.project());
}

// Features are looked for only where nothing is left out; markers found there are passed over.
bool fits_left_out(const SolvedCameras& solved, const Project& project) {
  if (!finds_features(*solved.finds)) return true;
  CalibrationSources now = *solved.sources;
  take_inputs(now, project.calibration);
  return now.left_out == solved.sources->left_out;
}

void load_earlier(Workspace& workspace, const ContentHash& files) {
  SolvedCameras& solved = workspace.calibrate.solved;
  if (solved.looked_for == files || solved.find.is_at_work()) return;
  solved.looked_for = files;
  start(workspace, &SolvedCameras::load, "Looking for cameras", Lane::interactive,
        [project = copy_of(workspace)](Progress& progress) { return loaded(*project, progress); });
}

// Clicks and measurements on top of what was found.
void solve_again(Workspace& workspace) {
  SolvedCameras& solved = workspace.calibrate.solved;
  auto sources = std::make_shared<CalibrationSources>(*solved.sources);
  take_inputs(*sources, workspace.project().calibration);
  solved.wanted = calibration_key(*sources);
  if (solved.wanted == solved.key) {
    solved.trouble.clear();
    solved.asked = solved.key;
    if (solved.solve.is_at_work()) workspace.jobs.cancel(solved.solve.id);
    return;
  }
  if (solved.wanted == solved.asked) return;
  solved.asked = solved.wanted;
  Outcome so_far{solved.files, sources, solved.finds};
  start(workspace, &SolvedCameras::solve, "Solving cameras", Lane::interactive,
        [so_far, cache = Cache(workspace.project().cache_folder())](Progress& progress) {
          progress.begin("solving cameras", 1);
          return outcome_of(so_far, [&](Outcome& outcome) { solve(outcome, cache, progress); });
        });
}

}  // namespace

void follow_calibration(Workspace& workspace) {
  const Project& project = workspace.project();
  SolvedCameras& solved = workspace.calibrate.solved;
  if (!project.cameras.empty() || project.photos.empty()) return;
  const ContentHash files = files_of(project);
  const bool looked = solved.sources && solved.files == files;
  if (looked && fits_left_out(solved, project)) return solve_again(workspace);
  solved.wanted = {};
  load_earlier(workspace, files);
}

void follow_calibration_jobs(Workspace& workspace) {
  SolvedCameras& solved = workspace.calibrate.solved;
  if (was_stopped(solved.find, workspace.jobs)) {
    solved.trouble = "Looking through the photos was stopped; what was found so far is kept.";
  }
  was_stopped(solved.load, workspace.jobs);
  was_stopped(solved.solve, workspace.jobs);
}

void find_markers(Workspace& workspace) {
  start(workspace, &SolvedCameras::find, "Finding markers", Lane::background,
        [project = copy_of(workspace)](Progress& progress) { return found(*project, progress); });
}

SolveState solve_state(const Workspace& workspace) {
  const Project& project = workspace.project();
  const SolvedCameras& solved = workspace.calibrate.solved;
  if (!project.cameras.empty() || project.photos.empty()) return SolveState::unused;
  if (!solved.sources) return SolveState::none;
  if (solved.wanted == ContentHash()) return SolveState::outdated;
  const bool same = solved.calibration && solved.wanted == solved.key;
  return same ? SolveState::current : SolveState::due;
}

std::shared_ptr<const Calibration> current_calibration(const Workspace& workspace) {
  if (solve_state(workspace) != SolveState::current) return nullptr;
  return workspace.calibrate.solved.calibration;
}

std::string obstacle_to_cameras(const Workspace& workspace) {
  const SolvedCameras& solved = workspace.calibrate.solved;
  if (workspace.project().photos.empty()) return "add photos in step Photos";
  switch (solve_state(workspace)) {
    case SolveState::due:
      if (solved.solve.is_at_work()) return "the cameras are being solved again";
      return "the cameras could not be solved: see step Calibrate";
    case SolveState::outdated:
      return "photos or options changed: press Find markers again in step Calibrate";
    case SolveState::current:
      return "no cameras could be found for the photos: step Calibrate says why";
    default:
      return "find or import the photos' cameras in step Calibrate";
  }
}

}  // namespace bosk
