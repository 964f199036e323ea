#pragma once

#include <filesystem>
#include <string>

#include "core/base/random.h"

namespace bosk {

std::string read_whole(const std::filesystem::path& file);

// One random injury or up to four: bits flipped, bytes replaced, the end cut off, a piece copied
// elsewhere or left out, a 4- or 8-byte count set to 0, 1, 2^31, 2^32 - 1, 2^63 or 2^64 - 1.
std::string mutated_bytes(Random& random, std::string bytes);
// The same for text, where a count is a run of digits; also words that parsers trip over (nan,
// 1e999, brackets in heaps, quotes, controls) set in.
std::string mutated_text(Random& random, std::string text);

}  // namespace bosk
