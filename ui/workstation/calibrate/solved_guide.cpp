#include "ui/workstation/calibrate/solved_guide.h"

#include "core/project/calibration_figures.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

// Without the full stop that ends it.
std::string clause(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

StepGuide guide_of(const Calibration& calibration) {
  const std::string first = calibration.sentences.empty() ? "" : calibration.sentences.front();
  const std::string has = summary_words(calibration);
  switch (calibration.verdict) {
    case Verdict::good:
      return {Tone::good, "ready", "", has, "check in the view that up is up, then go on to Matte"};
    case Verdict::usable:
      return {Tone::note, "usable", "", has,
              "go on to Matte, or read below what would make it better"};
    case Verdict::refused:
      break;
  }
  return {Tone::bad, "refused", "", clause(first),
          "click points that several photos share, take photos again, or import cameras"};
}

}  // namespace

StepGuide solved_guide(const Workspace& workspace) {
  const SolvedCameras& solved = workspace.calibrate.solved;
  if (solved.find.is_at_work()) {
    return {Tone::busy, "at work", "", "",
            "watch below, or stop it; photos can be clicked meanwhile"};
  }
  switch (solve_state(workspace)) {
    case SolveState::outdated:
      return {Tone::note, "out of date", "", "photos or options changed since",
              "press Find markers again"};
    case SolveState::due:
      if (solved.solve.is_at_work()) {
        return {Tone::busy, "solving", "", "", "go on clicking: the cameras follow"};
      }
      return {Tone::bad, "look here", "", clause(solved.trouble),
              "change what is told, or press Find markers again"};
    case SolveState::current:
      return guide_of(*solved.calibration);
    default:
      break;
  }
  if (!solved.trouble.empty()) {
    return {Tone::bad, "look here", "", clause(solved.trouble),
            "mend that, then press Find markers"};
  }
  return {Tone::note, "needs cameras", "", "",
          "press Find markers; or type or drop a camera file (a COLMAP model, a transforms.json or "
          "mrcal's .cameramodel)"};
}

}  // namespace bosk
