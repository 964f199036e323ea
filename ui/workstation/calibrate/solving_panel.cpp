#include <imgui.h>

#include <algorithm>

#include "core/project/calibration_figures.h"
#include "ui/widgets/landmarks.h"
#include "ui/workstation/calibrate/calibrate_panels.h"
#include "ui/workstation/calibrate/calibration_words.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr std::size_t kSentences = 3;  // shown at once; the rest behind a click

void draw_find(Workspace& workspace) {
  const SolvedCameras& solved = workspace.calibrate.solved;
  const bool again = solved.finds != nullptr;
  if (button("calibrate/find", again ? "Find markers again" : "Find markers",
             "looks through all photos for coloured balls, printed markers and features, then "
             "solves the cameras; photos that were looked through before take no time",
             solved.find.is_at_work() ? "at work; stop it below" : "")) {
    find_markers(workspace);
  }
  ImGui::SameLine();
  switch (solve_state(workspace)) {
    case SolveState::due:
      return badge(solved.solve.is_at_work() ? Tone::busy : Tone::note,
                   solved.solve.is_at_work() ? "solving" : "not solved");
    case SolveState::outdated:
      return badge(Tone::note, "out of date");
    case SolveState::current:
      return badge(tone_of(solved.calibration->verdict),
                   verdict_words(solved.calibration->verdict));
    default:
      return badge(Tone::muted, solved.find.is_at_work() ? "at work" : "not yet");
  }
}

void draw_sentences(const Calibration& calibration) {
  const auto& sentences = calibration.sentences;
  const Tone tone = calibration.verdict == Verdict::refused ? Tone::bad : Tone::note;
  for (std::size_t i = 0; i < std::min(kSentences, sentences.size()); ++i) {
    paragraph(i == 0 ? tone : Tone::neutral, sentences[i]);
  }
  if (sentences.size() <= kSentences) return;
  const bool open =
      ImGui::CollapsingHeader((std::to_string(sentences.size() - kSentences) + " more").c_str());
  mark("calibrate/more");
  for (std::size_t i = kSentences; open && i < sentences.size(); ++i) paragraph(sentences[i]);
}

void draw_verdict(const Calibration& calibration) {
  paragraph(tone_of(calibration.verdict), summary_words(calibration) + ".");
  for (const PhotoFate fate : {PhotoFate::uncertain, PhotoFate::refused}) {
    const std::string words = troubled_photos(calibration, fate);
    if (!words.empty()) paragraph(tone_of(fate), words + ".");
  }
  draw_sentences(calibration);
}

}  // namespace

void draw_solving(Workspace& workspace) {
  const SolvedCameras& solved = workspace.calibrate.solved;
  draw_find(workspace);
  if (!solved.trouble.empty()) paragraph(Tone::bad, solved.trouble);
  if (solved.calibration) draw_verdict(*solved.calibration);
}

}  // namespace bosk
