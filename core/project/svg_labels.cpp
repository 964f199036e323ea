#include "core/project/svg_labels.h"

#include <algorithm>
#include <vector>

#include "core/base/number_text.h"
#include "core/geometry/label_places.h"
#include "core/project/html.h"

namespace bosk {
namespace {

// Whoever opens the page chooses the font, so widths are a guess on the wide side.
constexpr double kLetterWidth = 0.62;  // of the text's height
constexpr double kBaseline = 0.8;      // of the text's height, from its top

// A letter of UTF-8 has one byte that goes on from no other.
long letters_of(const std::string& words) {
  return std::count_if(words.begin(), words.end(),
                       [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; });
}

}  // namespace

std::string svg_labels(std::span<const SvgLabel> labels, double text_height, double gap,
                       const glm::dvec2& least, const glm::dvec2& most) {
  std::vector<PointLabel> wanted;
  for (const SvgLabel& label : labels) {
    const double width = kLetterWidth * text_height * double(letters_of(label.words));
    wanted.push_back({label.point, {width, text_height}, label.needed});
  }
  const auto places = label_places(wanted, gap, least, most);
  std::string svg;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!places[i]) continue;
    svg += "<text x=\"" + number_text(places[i]->x, 1) + "\" y=\"" +
           number_text(places[i]->y + kBaseline * text_height, 1) + "\" fill=\"" +
           labels[i].colour + "\" font-size=\"" + number_text(text_height, 1) + "\">" +
           html_text(labels[i].words) + "</text>\n";
  }
  return svg;
}

}  // namespace bosk
