#include "core/calibrate/lens_verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"

namespace bosk {
namespace {

constexpr int kFewestBoards = 3, kEnoughBoards = 6;
constexpr double kFrontalTilt = 0.21;  // radians, 12 degrees: less tells no focal length
// Of the focal length, relative: one sigma by noise; by the choice of boards.
constexpr double kUnknownFocal = 0.02, kUnsureFocal = 0.005;
constexpr double kUnknownSpread = 0.1, kUnsureSpread = 0.01;
// Of the frame's diagonal: 1.5 and 0.45 px of 1800. Good boards leave 0.1 to 0.2 px.
constexpr double kHopelessRms = 1.0 / 1200, kHighRms = 1.0 / 4000;
constexpr double kBent = 0.005;  // of the board's longer side, that its middle stands out
constexpr double kUnsureEdge_px = 1.0, kGuessedEdge_px = 30.0;

struct Finding {
  Verdict verdict;
  std::string sentence;
};

struct Judge {
  const LensCalibration& calibration;
  const BoardShape& shape;
  std::vector<Finding> findings;

  void say(Verdict verdict, const std::string& sentence) {
    findings.push_back({verdict, sentence});
  }
};

int boards_used(const LensCalibration& calibration) { return calibration.profile.boards; }

std::string boards_text(int boards) {
  return boards == 1 ? "1 photo of the board" : std::to_string(boards) + " photos of the board";
}

void judge_count(Judge& judge) {
  const int boards = boards_used(judge.calibration);
  if (boards < kFewestBoards)
    judge.say(Verdict::refused, "only " + boards_text(boards) +
                                    " can be used, and a lens needs at least 3; take 10 to 40 "
                                    "that fill the picture, from many angles");
  else if (boards < kEnoughBoards)
    judge.say(Verdict::usable, "only " + boards_text(boards) +
                                   " can be used; take at least 6, better 10 to 20, from many "
                                   "angles");
}

double largest_tilt(const LensCalibration& calibration) {
  double tilt = 0.0;
  for (const BoardFinding& board : calibration.boards)
    if (board.used) tilt = std::max(tilt, board.tilt);
  return tilt;
}

std::string percent(double share) { return number_text(100.0 * std::min(share, 10.0), 1) + " %"; }

void judge_focal(Judge& judge) {
  const LensCalibration& calibration = judge.calibration;
  const std::string remedy =
      "tilt the board by 30 to 45 degrees, each way, in most photos and let it fill the picture";
  const double sigma = calibration.focal_sigma, spread = calibration.focal_spread;
  const std::string uncertain =
      "the focal length is uncertain by " + percent(sigma) + "; " + remedy;
  const std::string moving = "the focal length moves by " + percent(spread) +
                             " with the choice of photos; keep the focus as it is, take a stiff "
                             "board and " +
                             remedy;
  if (largest_tilt(calibration) < kFrontalTilt)
    judge.say(Verdict::refused,
              "every board is seen from the front, which leaves the focal length undetermined; " +
                  remedy);
  else if (!(sigma < kUnknownFocal))
    judge.say(Verdict::refused, uncertain);
  else if (spread > kUnsureSpread)
    judge.say(spread > kUnknownSpread ? Verdict::refused : Verdict::usable, moving);
  else if (sigma > kUnsureFocal)
    judge.say(Verdict::usable, uncertain);
}

double diagonal_px(const LensCalibration& calibration) {
  const Lens& lens = calibration.profile.lens;
  return std::hypot(double(lens.width_px), double(lens.height_px));
}

double bend_m(const Judge& judge) {
  const glm::dvec2 warp = glm::abs(judge.calibration.board_warp_m);
  return std::max(warp.x, warp.y);
}

bool is_bent(const Judge& judge) {
  const double side_m =
      judge.shape.square_m * (std::max(judge.shape.columns, judge.shape.rows) - 1);
  return bend_m(judge) > kBent * side_m;
}

void judge_residual(Judge& judge) {
  const double rms = judge.calibration.profile.rms_px;
  const double diagonal = diagonal_px(judge.calibration);
  const bool high = rms > kHighRms * diagonal;
  const std::string missed =
      "the corners miss their places by " + number_text(rms, 2) + " px (rms)";
  const std::string bent = "the board is bent by " + number_text(1e3 * bend_m(judge), 1) + " mm";
  if (rms > kHopelessRms * diagonal)
    judge.say(Verdict::refused,
              missed +
                  ", which no lens explains; check that the board is stiff and flat, that its "
                  "size is given right, and that focus and zoom stayed as they were");
  else if (high && is_bent(judge))
    judge.say(Verdict::refused, bent + ", and not alike in all photos: " + missed +
                                    "; glue it to something stiff and flat");
  else if (high)
    judge.say(Verdict::usable,
              missed +
                  ", which is much; glue the board to something stiff, hold the camera still "
                  "and focus on the board");
  else if (is_bent(judge))
    judge.say(Verdict::usable, bent + "; glue it to something stiff and flat");
}

std::string listed(const std::vector<std::string>& names, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

void judge_left_out(Judge& judge) {
  std::vector<std::string> named;
  int disagreeing = 0;
  for (const BoardFinding& board : judge.calibration.boards) {
    if (board.used) continue;
    named.push_back(board.photo);
    if (board.corners > 0) ++disagreeing;
  }
  if (named.empty()) return;
  const bool many = disagreeing * 3 > boards_used(judge.calibration) + disagreeing;
  judge.say(many ? Verdict::usable : Verdict::good,
            "left out, each for the reason beside it: " + listed(named, 5) +
                (many ? "; these are many: check that all photos show the same flat board through "
                        "the same lens"
                      : ""));
}

// Names of the frame's ninths, by row.
constexpr std::array kPlaces{"top left", "top",         "top right", "left",        "middle",
                             "right",    "bottom left", "bottom",    "bottom right"};

// Whether the frame's ninth number i has no corner of any board.
bool is_bare(const Image<float>& coverage, int i) {
  const int left = i % 3 * coverage.width() / 3, right = (i % 3 + 1) * coverage.width() / 3;
  const int top = i / 3 * coverage.height() / 3, bottom = (i / 3 + 1) * coverage.height() / 3;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      if (coverage(x, y) > 0.0f) return false;
  return true;
}

// The frame's ninths without a board are named.
std::array<bool, 9> judge_coverage(Judge& judge) {
  const Image<float>& coverage = judge.calibration.profile.coverage;
  std::array<bool, 9> bare{};
  if (coverage.empty()) return bare;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < bare.size(); ++i) {
    bare[i] = is_bare(coverage, int(i));
    if (bare[i]) names.emplace_back(kPlaces[i]);
  }
  if (!names.empty())
    judge.say(Verdict::usable, "no board was seen in the picture's " + listed(names, 9) +
                                   ", where the lens is only a guess; add photos with the board "
                                   "there");
  return bare;
}

// The number of the frame's ninth that a cell of the map lies in.
std::size_t ninth(int x, int y, const Image<float>& map) {
  return std::size_t(y * 3 / map.height()) * 3 + std::size_t(x * 3 / map.width());
}

// The place outside those without a board where the lens is most uncertain.
void judge_edge(Judge& judge, const std::array<bool, 9>& bare) {
  const Image<float>& sigma = judge.calibration.profile.uncertainty_px;
  float worst = 0.0f;
  std::size_t worst_place = 0;
  for (int y = 0; y < sigma.height(); ++y)
    for (int x = 0; x < sigma.width(); ++x) {
      const auto place = ninth(x, y, sigma);
      if (bare[place] || sigma(x, y) <= worst) continue;
      worst = sigma(x, y);
      worst_place = place;
    }
  if (double(worst) <= kUnsureEdge_px) return;
  const std::string amount = double(worst) > kGuessedEdge_px
                                 ? "only a guess"
                                 : "uncertain by " + number_text(double(worst), 1) + " px";
  judge.say(Verdict::usable, "near the picture's edge, " + std::string(kPlaces[worst_place]) +
                                 ", the lens is " + amount +
                                 "; add photos with the board there, tilted");
}

}  // namespace

void judge_lens(LensCalibration& calibration, const BoardShape& shape) {
  Judge judge{calibration, shape, {}};
  judge_count(judge);
  if (boards_used(calibration) >= kFewestBoards) {
    judge_residual(judge);
    judge_focal(judge);
    judge_edge(judge, judge_coverage(judge));
  }
  judge_left_out(judge);
  // What refuses comes first; the rest keeps its order.
  std::stable_sort(judge.findings.begin(), judge.findings.end(),
                   [](const Finding& a, const Finding& b) { return a.verdict > b.verdict; });
  calibration.verdict = judge.findings.empty() ? Verdict::good : judge.findings.front().verdict;
  calibration.sentences.clear();
  for (const Finding& finding : judge.findings) calibration.sentences.push_back(finding.sentence);
  if (calibration.sentences.empty())
    calibration.sentences.push_back("the lens explains the corners to " +
                                    number_text(calibration.profile.rms_px, 2) + " px (rms) in " +
                                    boards_text(boards_used(calibration)));
}

}  // namespace bosk
