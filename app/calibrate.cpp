#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/calibrate_arguments.h"
#include "app/commands.h"
#include "core/base/atomic_file.h"
#include "core/base/system_error.h"
#include "core/project/calibration_figures.h"
#include "core/project/calibration_report.h"
#include "core/project/calibration_refine.h"
#include "core/project/calibration_run.h"
#include "core/project/lock.h"
#include "core/project/project_json.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

ExitStatus status_of(Verdict verdict) {
  if (verdict == Verdict::good) return ExitStatus::done;
  return verdict == Verdict::usable ? ExitStatus::below_quality : ExitStatus::bad_input;
}

// Its own cameras would be passed over in silence.
void require_no_camera_file(const Project& project) {
  if (project.cameras.empty()) return;
  throw Error(printable(project.folder.string()) + ": has cameras from " +
              printable(project.cameras.string()) +
              " already; give --replace to forget that file and calibrate");
}

// Before anything is written, so that a profile that can't be had leaves no trace.
const LensProfile& profile_to_save(const CalibrationFinds& finds) {
  if (finds.boards && finds.boards->verdict != Verdict::refused) return finds.boards->profile;
  throw Error(finds.boards ? "no lens could be had of the board photos, so none is saved: " +
                                 (finds.boards->sentences.empty() ? "see the report"
                                                                  : finds.boards->sentences.front())
                           : "there is no lens to save: name photos of a board with --boards");
}

void show(const std::string& folder, const Calibration& calibration, Console& console) {
  nlohmann::ordered_json json = calibration_figures_json(calibration);
  json["project"] = folder;
  json["exit_status"] = int(status_of(calibration.verdict));
  const bool refused = calibration.verdict == Verdict::refused;
  const std::string why = refused ? refusal_of(calibration) : "";
  if (refused) json["error"] = why;
  console.result(printable(folder) + ": " + calibration_figures_text(calibration), json);
  if (refused) console.say("bosk: " + printable(folder) + ": " + why + "; the project is as it was");
}

ExitStatus calibrate(const CalibrateArguments& arguments, Console& console) {
  require_project(arguments.folder);
  const ProjectLock lock(arguments.folder);
  Project project = read_project(arguments.folder);
  take_arguments(arguments, project);
  require_no_camera_file(project);
  for (const std::string& output : {arguments.report, arguments.save_lens}) {
    if (!output.empty()) require_writable(output);
  }
  const CalibrationSources sources = gather_calibration(project);
  const Cache cache(project.cache_folder());
  cache.sweep();
  Progress& progress = console.progress();
  const bool extras = !arguments.report.empty() || !arguments.save_lens.empty();
  progress.scope(0.0, extras ? 0.8 : 1.0);
  const Calibration calibration = calibrate_project(project, sources, cache, progress);
  progress.scope(0.8, 1.0);
  const CalibrationFinds finds =
      extras ? find_for_calibration(sources, cache, progress) : CalibrationFinds();
  if (!arguments.save_lens.empty()) {
    save_lens_profile(arguments.save_lens, profile_to_save(finds));
  }
  if (!arguments.report.empty()) {
    write_calibration_report(arguments.report, project.name(), sources, calibration, finds.boards,
                             progress);
  }
  if (calibration.verdict != Verdict::refused) save_project(project);
  show(arguments.folder, calibration, console);
  return status_of(calibration.verdict);
}

}  // namespace

void add_calibrate_command(CLI::App& app, Request& request) {
  CLI::App& command =
      add_command(app, request, "calibrate", "find the photos' cameras, from the photos alone",
                  "bosk calibrate oak --tape red blue 2.35 --height red 1.52 --report oak.html");
  auto arguments = std::make_shared<CalibrateArguments>();
  add_calibrate_arguments(command, *arguments);
  command.callback([arguments, &request] {
    request.run = [arguments](Console& console) { return calibrate(*arguments, console); };
  });
}

}  // namespace bosk
