#include "tests/hostile_input/mutate.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

namespace bosk {
namespace {

constexpr std::array<std::uint64_t, 6> kCounts{
    0, 1, std::uint64_t(1) << 31, 0xffffffff, std::uint64_t(1) << 63, ~std::uint64_t(0)};

const std::array<std::string, 22> kWords{"nan",      "-inf",
                                         "1e999",    "-1",
                                         "0",        "1e-320",
                                         "\"",       "'",
                                         "\\",       "[",
                                         "{",        "]",
                                         "}",        ",",
                                         ":",        "#",
                                         "\n",       "\r\n\t",
                                         "b'",       "null",
                                         "\xff\xfe", std::string(1, '\0')};

std::size_t place(Random& random, const std::string& text) {
  return std::size_t(random.below(text.size() + 1));
}

void flip_bit(Random& random, std::string& bytes) {
  if (bytes.empty()) return;
  char& byte = bytes[random.below(bytes.size())];
  byte = char(byte ^ (1 << random.below(8)));
}

void replace_bytes(Random& random, std::string& bytes) {
  if (bytes.empty()) return;
  for (std::uint64_t left = 1 + random.below(8); left > 0; --left)
    bytes[random.below(bytes.size())] = char(random.below(256));
}

void cut(Random& random, std::string& bytes) { bytes.resize(place(random, bytes)); }

void remove_piece(Random& random, std::string& bytes) {
  bytes.erase(place(random, bytes), random.below(40));
}

void splice(Random& random, std::string& bytes) {
  const std::string piece = bytes.substr(place(random, bytes), random.below(80));
  if (random.below(2) == 0)
    bytes.insert(place(random, bytes), piece);
  else
    bytes.replace(place(random, bytes), piece.size(), piece);
}

// In half of the cases the first count of the file, else anywhere.
void set_binary_count(Random& random, std::string& bytes) {
  const std::uint64_t count = kCounts[random.below(kCounts.size())];
  const std::size_t size = random.below(2) == 0 ? 4 : 8;
  const std::size_t at = random.below(2) == 0 ? 0 : place(random, bytes);
  if (at + size <= bytes.size()) std::memcpy(bytes.data() + at, &count, size);
}

void set_text_count(Random& random, std::string& text) {
  const std::size_t begin = text.find_first_of("0123456789", place(random, text));
  if (begin == std::string::npos) return;
  const std::size_t end = std::min(text.find_first_not_of("0123456789", begin), text.size());
  text.replace(begin, end - begin, std::to_string(kCounts[random.below(kCounts.size())]));
}

void set_word(Random& random, std::string& text) {
  const std::string& word = kWords[random.below(kWords.size())];
  const std::size_t at = place(random, text);
  const std::size_t times = random.below(50) == 0 ? 20'000 : 1;
  std::string words;
  for (std::size_t i = 0; i < times; ++i) words += word;
  text.replace(at, random.below(6), words);
}

using Injury = void (*)(Random&, std::string&);

template <std::size_t N>
std::string injured(Random& random, std::string bytes, const std::array<Injury, N>& injuries) {
  for (std::uint64_t left = 1 + random.below(2) * random.below(4); left > 0; --left)
    injuries[random.below(N)](random, bytes);
  return bytes;
}

}  // namespace

std::string read_whole(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string mutated_bytes(Random& random, std::string bytes) {
  return injured(
      random, std::move(bytes),
      std::array<Injury, 6>{flip_bit, replace_bytes, cut, remove_piece, splice, set_binary_count});
}

std::string mutated_text(Random& random, std::string text) {
  return injured(random, std::move(text),
                 std::array<Injury, 7>{flip_bit, replace_bytes, cut, remove_piece, splice,
                                       set_text_count, set_word});
}

}  // namespace bosk
