#include "core/calibrate/lens_views.h"

#include <algorithm>
#include <map>
#include <string>

namespace bosk {
namespace {

constexpr std::size_t kFewestCorners = 6;

std::string size_text(const BoardView& view) {
  return std::to_string(view.width_px) + " x " + std::to_string(view.height_px);
}

// Empty where EXIF is silent.
std::string camera_text(const BoardView& view) {
  return view.taken_with == LensIdentity{} ? std::string() : identity_text(view.taken_with);
}

// What most of the numbered views say of themselves, silent ones not counted.
template <class TextOf>
std::string commonest(std::span<const BoardView> views, const std::vector<std::size_t>& numbers,
                      const TextOf& text_of) {
  std::map<std::string, int> counts;
  for (const std::size_t i : numbers)
    if (const std::string text = text_of(views[i]); !text.empty()) ++counts[text];
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? std::string() : most->first;
}

// Drops the numbered views that say otherwise than most, and gives them the reason "WHAT; most are
// of ...".
template <class TextOf>
std::vector<std::size_t> agreeing(std::span<const BoardView> views,
                                  const std::vector<std::size_t>& numbers, const char* what,
                                  const TextOf& text_of, std::vector<BoardFinding>& findings) {
  const std::string most = commonest(views, numbers, text_of);
  std::vector<std::size_t> kept;
  for (const std::size_t i : numbers) {
    const std::string own = text_of(views[i]);
    if (own.empty() || own == most)
      kept.push_back(i);
    else
      findings[i].reason = what + own + ", most photos are of " + most +
                           "; a lens is calibrated for one camera, size and focal length";
  }
  return kept;
}

}  // namespace

std::vector<std::size_t> views_that_match(std::span<const BoardView> views, const BoardShape& shape,
                                          std::vector<BoardFinding>& findings) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < views.size(); ++i) {
    BoardFinding finding;
    finding.photo = views[i].photo;
    finding.corners = int(views[i].corners.size());
    if (views[i].corners.empty())
      finding.reason = "no board of " + std::to_string(shape.columns) + " x " +
                       std::to_string(shape.rows) + " inner corners was found in it";
    else if (views[i].corners.size() < kFewestCorners)
      finding.reason = "only " + std::to_string(views[i].corners.size()) +
                       " corners of the board were found, and 6 are needed";
    else
      numbers.push_back(i);
    findings.push_back(std::move(finding));
  }
  numbers = agreeing(views, numbers, "it is of ", size_text, findings);
  return agreeing(views, numbers, "it was taken with ", camera_text, findings);
}

}  // namespace bosk
