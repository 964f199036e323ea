#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/photo/verdicts.h"
#include "ui/widgets/theme.h"

namespace bosk {

struct VerdictWord {
  Tone tone = Tone::muted;
  std::string word;
};
// Of an import's verdict: "usable", "usable, with a guess", "left out".
VerdictWord word_of(const PhotoVerdict& verdict, const PhotoFacts& facts, bool cameras_known);

// What a person should know of the photos as a set: pictures of several sizes, several lenses,
// upright ones beside lying ones. A sentence each.
std::vector<std::string> set_remarks(std::span<const PhotoFacts* const> accepted);

// What EXIF and the file say, as names and values; what isn't there is said to be so.
using Details = std::vector<std::pair<std::string, std::string>>;
Details details_of(const PhotoFacts& facts, std::uintmax_t bytes);

// "1 photo", "2 photos".
std::string count_of(std::size_t count, const std::string& thing);

}  // namespace bosk
