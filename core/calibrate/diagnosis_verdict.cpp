#include "core/calibrate/diagnosis_verdict.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/calibrate/diagnosis_points.h"
#include "core/calibrate/uncertainty.h"

namespace bosk {
namespace {

// Of the bound on a photo's uncertainty, for half of the photos at least, where the lens was solved
// for too: photos then share their error, and a solve as a whole is off by twice its sigma in 2 of
// 100 cases (Rayleigh), which no average over photos makes better.
constexpr double kSharedShare = 5.0 / 6.0;
constexpr std::size_t kPlenty = 7;  // sightings that no other place explains by chance

constexpr double kOtherPlaceCost = 16.0;  // dearer by less, another place of a camera is as likely
constexpr double kElsewhere_px = 2.0;
constexpr int kFewestSpare = 6;  // equations beyond the unknowns
constexpr double kMostNoise = 8.0;

Camera camera_of(const Solution& solution, int camera) {
  const SolveInput& input = solution.input;
  const Lens lens = lens_of(input.problem.family, solution.state.intrinsics, input.lens.width_px,
                            input.lens.height_px);
  return {"", lens, solution.state.camera_from_world[std::size_t(camera)]};
}

std::vector<PoseSighting> used_sightings(const Solution& solution, int camera) {
  const Lens lens = camera_of(solution, camera).lens;
  std::vector<PoseSighting> result;
  for (const BundleSighting& sighting : solution.input.problem.sightings) {
    if (sighting.camera != camera || !sighting.used) continue;
    if (const auto bearing = camera_from_pixel(lens, sighting.pixel))
      result.push_back({solution.state.points[std::size_t(sighting.point)], *bearing,
                        sighting.sigma_px * solution.loss / kFinalLoss / lens.focal_px.x});
  }
  return result;
}

double apart_px(const Camera& a, const Camera& b, const glm::dvec3& point) {
  const auto in_a = project(a, point), in_b = project(b, point);
  return in_a && in_b ? glm::distance(*in_a, *in_b) : 1e6;
}

// Whether the camera could as well stand elsewhere, the points being where they are.
bool fits_elsewhere(const Solution& solution, int camera) {
  const std::vector<PoseSighting> sightings = used_sightings(solution, camera);
  if (sightings.size() >= kPlenty) return false;
  const Camera here = camera_of(solution, camera);
  const double cost =
      refined_pose(sightings, here.camera_from_world, kLeastSquares).cost + kOtherPlaceCost;
  const glm::dvec3 crown = crown_point(solution.state);
  for (const PlacedPose& pose : place_camera(sightings, kLeastSquares))
    if (pose.cost < cost &&
        apart_px(here, {"", here.lens, pose.camera_from_world}, crown) > kElsewhere_px)
      return true;
  return false;
}

std::string crown_text(double sigma_px, int sightings, double good_px) {
  const double share = sigma_px / good_px;
  const int more = std::clamp(int(std::ceil(sightings * (share * share - 1.0))), 1, 4);
  return "is uncertain by " + number_text(sigma_px, 1) + " px at the crown: add " +
         std::to_string(more) + (more == 1 ? " marker" : " markers") + " near its view";
}

void judge_photo(const Solution& solution, const SolveQuestion& question, int camera,
                 PhotoFinding& finding) {
  const SolveOptions& options = question.options;
  const int used = finding.sightings - finding.outliers;
  const std::size_t photo = solution.input.photo_of_camera[std::size_t(camera)];
  if (!(finding.crown_sigma_px < options.refused_crown_px)) {
    finding.fate = PhotoFate::refused;
    finding.reason = crown_text(finding.crown_sigma_px, used, options.uncertain_crown_px);
  } else if (solution.ambiguous[photo] || fits_elsewhere(solution, camera)) {
    finding.fate = PhotoFate::uncertain;
    finding.reason = "fits as well from another place: mark more points in it";
  } else if (used < options.few_sightings) {
    finding.fate = PhotoFate::uncertain;
    finding.reason = "has " + std::to_string(used) +
                     " sightings that fit, too few to check each other: mark " +
                     std::to_string(options.few_sightings - used) + " more or add markers";
  } else if (used < int(kPlenty) && 3 * finding.outliers > finding.sightings) {
    // So many mistakes are rare; a wrong place that a few sightings agree on is likelier
    finding.fate = PhotoFate::uncertain;
    finding.reason = std::to_string(finding.outliers) + " of its " +
                     std::to_string(finding.sightings) +
                     " sightings do not fit the others: look at each of them";
  } else if (finding.crown_sigma_px > options.uncertain_crown_px) {
    finding.fate = PhotoFate::uncertain;
    finding.reason = crown_text(finding.crown_sigma_px, used, options.uncertain_crown_px);
  }
}

int count_of(const Calibration& calibration, PhotoFate fate) {
  return int(std::count_if(calibration.photos.begin(), calibration.photos.end(),
                           [&](const PhotoFinding& finding) { return finding.fate == fate; }));
}

void add_survey_sentences(const Solution& solution, std::vector<std::string>& sentences) {
  const auto& [input, state, determined, ambiguous, loss] = solution;
  const auto name = [&](int point) { return input.points[std::size_t(point)]; };
  for (const LengthRow& row : input.problem.lengths) {
    if (row.used) continue;
    const double length =
        glm::distance(state.points[std::size_t(row.from)], state.points[std::size_t(row.to)]);
    const std::string lengths = " says " + number_text(row.length, 3) + " m and the photos " +
                                number_text(length, 3) + " m: measure it again";
    const bool is_height = name(row.from) == name(row.to) + " foot";
    sentences.push_back(is_height
                            ? "the height of " + name(row.to) + " over its foot" + lengths +
                                  ", or mark the foot where the stick meets the ground"
                            : "the tape from " + name(row.from) + " to " + name(row.to) + lengths);
  }
  for (const CoordinateRow& row : input.problem.coordinates) {
    if (row.used) continue;
    const double value = state.points[std::size_t(row.point)][row.axis];
    const char* const what[] = {"x of the surveyed place", "y of the surveyed place", "the height"};
    sentences.push_back(std::string(what[row.axis]) + " of " + name(row.point) +
                        " was measured as " + number_text(row.value, 3) + " m and the photos say " +
                        number_text(value, 3) + " m: measure it again");
  }
}

void add_world_sentences(const Calibration& calibration, std::vector<std::string>& sentences) {
  if (!calibration.scale_known)
    sentences.push_back(
        "nothing that was measured gives the size: lengths are in units of the cameras' mean "
        "distance; measure a tape between two points");
  if (!calibration.up_known)
    sentences.push_back(
        "up is a guess, from cameras held at one height: give the heights of three points, or mark "
        "balls and feet of upright sticks");
}

// A few, and how many there are more: of a printed marker all corners are said to have moved.
void add_the_first(std::vector<std::string> more, std::vector<std::string>& sentences) {
  constexpr std::size_t kFew = 3;
  if (more.size() > kFew) {
    const std::size_t rest = more.size() - kFew;
    more.resize(kFew);
    more.back() += " (and " + std::to_string(rest) + " more such)";
  }
  sentences.insert(sentences.end(), more.begin(), more.end());
}

// Photos that are uncertain at the crown share a sentence when they are many.
void add_photo_sentences(const Calibration& calibration, std::vector<std::string>& sentences) {
  constexpr std::size_t kMany = 4;
  std::vector<std::string> others, at_crown;
  double least_px = 1e9, most_px = 0.0;
  for (const PhotoFate fate : {PhotoFate::refused, PhotoFate::uncertain}) {
    for (const PhotoFinding& finding : calibration.photos) {
      if (finding.fate != fate) continue;
      const bool by_crown =
          fate == PhotoFate::uncertain && finding.reason.starts_with("is uncertain");
      (by_crown ? at_crown : others).push_back("photo " + finding.photo + " " + finding.reason);
      if (!by_crown) continue;
      least_px = std::min(least_px, finding.crown_sigma_px);
      most_px = std::max(most_px, finding.crown_sigma_px);
    }
  }
  if (at_crown.size() > kMany)
    at_crown = {std::to_string(at_crown.size()) + " photos are uncertain by " +
                number_text(least_px, 1) + " to " + number_text(most_px, 1) +
                " px at the crown: add markers round the tree and higher up, or mark each in more "
                "photos"};
  sentences.insert(sentences.end(), others.begin(), others.end());
  sentences.insert(sentences.end(), at_crown.begin(), at_crown.end());
}

// Why no camera can be trusted; empty: they can.
std::string reason_to_refuse(const Solution& solution, const SolveQuestion& question, double noise,
                             const Calibration& calibration) {
  const int placed = int(calibration.photos.size()) - count_of(calibration, PhotoFate::refused);
  const int solved = int(solution.input.cameras());
  if (redundancy(solution.input.problem, solution.state) < kFewestSpare)
    return "there are hardly more sightings than unknowns, so that nothing checks them: mark more "
           "points, in more photos";
  const auto ambiguous = std::count(solution.ambiguous.begin(), solution.ambiguous.end(), true);
  if (2 * ambiguous > solved)
    return "the sightings fit two different walks equally well: mark more points, or take photos "
           "in between";
  if (noise * calibration.rms_px > 0.0 && noise > kMostNoise)
    return "the sightings miss each other by " + number_text(calibration.rms_px, 1) +
           " px: check the names of the points, and that one lens took all photos";
  if (placed < 3 || 2 * placed < solved)
    return "only " + std::to_string(placed) + " of " + std::to_string(calibration.photos.size()) +
           " photos can be placed to better than " +
           number_text(question.options.refused_crown_px, 0) +
           " px at the crown: add markers round the tree and at several heights, and mark each in "
           "more photos";
  return {};
}

// Whether no tape, height or surveyed place had to be left out.
bool measures_agree(const BundleProblem& problem) {
  const auto is_used = [](const auto& row) { return row.used; };
  return std::all_of(problem.lengths.begin(), problem.lengths.end(), is_used) &&
         std::all_of(problem.coordinates.begin(), problem.coordinates.end(), is_used);
}

}  // namespace

void judge_photos(const Solution& solution, const SolveQuestion& question,
                  std::vector<PhotoFinding>& findings) {
  for (std::size_t i = 0; i < findings.size(); ++i)
    judge_photo(solution, question, int(i), findings[i]);
  const double good_px =
      question.options.uncertain_crown_px * (question.lens.known ? 1.0 : kSharedShare);
  const auto poor = std::count_if(findings.begin(), findings.end(), [&](const PhotoFinding& f) {
    return f.crown_sigma_px > good_px;
  });
  for (PhotoFinding& finding : findings) {
    if (2 * std::size_t(poor) <= findings.size() || finding.fate != PhotoFate::placed) continue;
    finding.fate = PhotoFate::uncertain;
    finding.reason = "is uncertain because most photos are, by more than " +
                     number_text(good_px, 1) + " px at the crown: add markers, or know the lens";
  }
}

void judge(const Solution& solution, const SolveQuestion& question, double noise,
           const std::optional<std::string>& doubt_of_lens, Calibration& calibration) {
  std::vector<std::string>& sentences = calibration.sentences;
  const std::string refusal = reason_to_refuse(solution, question, noise, calibration);
  const int refused = count_of(calibration, PhotoFate::refused);
  const int uncertain = count_of(calibration, PhotoFate::uncertain);
  const bool all_good = refused + uncertain == 0 && calibration.scale_known &&
                        calibration.up_known && measures_agree(solution.input.problem);
  calibration.verdict = !refusal.empty() ? Verdict::refused
                        : all_good       ? Verdict::good
                                         : Verdict::usable;
  if (!refusal.empty()) sentences.push_back(refusal);
  if (doubt_of_lens) sentences.push_back(*doubt_of_lens);
  add_the_first(moved_points(solution.input, solution.state, question.photos, solution.loss,
                             calibration.scale_known),
                sentences);
  for (const std::string& sentence :
       swapped_names(solution.input, solution.state, question.photos, solution.loss))
    sentences.push_back(sentence);
  add_photo_sentences(calibration, sentences);
  add_survey_sentences(solution, sentences);
  add_world_sentences(calibration, sentences);
  for (const std::string& sentence : solution.input.sentences) sentences.push_back(sentence);
}

}  // namespace bosk
