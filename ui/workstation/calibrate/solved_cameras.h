#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <memory>
#include <string>

#include "core/base/content_hash.h"
#include "core/image/image.h"
#include "core/project/calibration_run.h"
#include "ui/workstation/watched_job.h"

namespace bosk {

struct Workspace;

// How what calibration gave stands to the project as it is now.
enum class SolveState {
  unused,    // the project has a camera file, or no photos
  none,      // its photos were not looked through yet
  outdated,  // photos, board, lens or options are others than those that were looked through
  due,       // a click or a measurement changed, and the solve for it is at work or has failed
  current,
};

// What photos of a board say of the lens, as pictures for the screen; empty without such photos.
struct LensLook {
  Image<glm::u8vec4> coverage, uncertainty;
};
inline constexpr double kFullUncertaintyPx = 1.0;  // red on the map

// What the photos show by themselves, and the cameras that follow from it and from what a person
// told. Values come from jobs; what is shown may be of an earlier state of the project.
struct SolvedCameras {
  std::shared_ptr<const CalibrationSources> sources;
  std::shared_ptr<const CalibrationFinds> finds;  // of `sources`; not null where those aren't
  std::shared_ptr<const LensLook> lens_look;      // of `finds`
  std::shared_ptr<const Calibration> calibration;
  std::uint64_t revision = 1;      // raised with each of the above
  ContentHash files;               // what says which files and options `sources` are of
  ContentHash key, wanted, asked;  // of `calibration`; that the project asks for; last begun
  ContentHash looked_for;          // files that the cache was last asked for
  std::string trouble;             // why the newest find or solve gave nothing
  WatchedJob find, load, solve;
};

// Starts what the project's state asks for: takes from the cache what it holds of these files, and
// solves anew after clicks and measurements, the newest solve replacing one at work. After each
// change of the project, and once a job has ended.
void follow_calibration(Workspace& workspace);
// Tells of jobs that were stopped. Once a frame.
void follow_calibration_jobs(Workspace& workspace);

// Looks through all photos, then solves and, where the option asks for it, refines by the mattes: a
// job in the list. What was found before comes from the cache.
void find_markers(Workspace& workspace);

SolveState solve_state(const Workspace& workspace);
// The calibration that the project may use: current, whatever its verdict; null: there is none.
std::shared_ptr<const Calibration> current_calibration(const Workspace& workspace);
// Why there is none, and what to do, for steps that need cameras.
std::string obstacle_to_cameras(const Workspace& workspace);

}  // namespace bosk
