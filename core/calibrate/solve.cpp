#include "core/calibrate/solve.h"

#include "core/base/number_text.h"
#include "core/calibrate/diagnosis.h"
#include "core/calibrate/solve_steps.h"

namespace bosk {
namespace {

std::vector<bool> by_photo(const SolveInput& input, const std::vector<bool>& of_camera) {
  std::vector<bool> result(input.refused.size(), false);
  for (std::size_t i = 0; i < of_camera.size(); ++i)
    result[input.photo_of_camera[i]] = of_camera[i];
  return result;
}

// Whether the photos would fit with a lens that isn't known, as a sentence.
std::string other_lens_sentence(const SolveQuestion& question, Progress& progress) {
  const Calibration calibration = solve_cameras(
      question.photos, question.survey, {question.lens.lens, false}, question.options, progress);
  if (calibration.verdict == Verdict::refused) return {};
  return "with the known lens, focal length " + number_text(question.lens.lens.focal_px.x, 0) +
         " px, the photos don't fit each other, and with " +
         number_text(calibration.lens.focal_px.x, 0) +
         " px they do: calibrate the lens at this zoom setting, or leave it free";
}

// Most photos don't fit, or the solve fell apart.
Calibration disagreement(const SolveInput& input, const SolveQuestion& question,
                         Progress& progress) {
  std::string sentence;
  if (question.lens.known) sentence = other_lens_sentence(question, progress);
  if (sentence.empty())
    sentence =
        "most photos don't fit each other: check that points have the same name in all photos, "
        "and that all photos show the same tree through one lens";
  return refused_calibration(input, question, {sentence});
}

}  // namespace

Calibration solve_cameras(std::span<const PhotoSightings> photos, const Survey& survey,
                          const LensKnowledge& lens, const SolveOptions& options,
                          Progress& progress) {
  const SolveQuestion question{photos, survey, lens, options};
  check_input(photos, survey, lens);
  Solution solution;
  solution.input = solve_input(photos, survey, lens, options, {});
  if (const auto reason = too_little(solution.input, question))
    return refused_calibration(solution.input, question, {*reason});
  progress.begin("Cameras, first guesses", 1, 0.0, 0.1);
  SolveStart start = start_solve(solution.input, options.first_poses, photos, progress);
  solution.state = std::move(start.state);
  solution.ambiguous = by_photo(solution.input, start.ambiguous);
  progress.begin("Cameras, all points", 3, 0.7, 1.0);
  settle(solution, progress);
  progress.advance();
  if (!leave_out_photos(solution, question, progress) || !finish(solution, question, progress))
    return disagreement(solution.input, question, progress);
  progress.advance();
  Calibration calibration = report(solution, question, progress);
  progress.advance();
  return calibration;
}

}  // namespace bosk
