#include "core/photo/python_literal.h"

#include <algorithm>
#include <utility>

#include "core/photo/camera_files_parts.h"

namespace bosk::camera_files {
namespace {
constexpr int kMaxDepth = 64;
}

PythonLiteral::PythonLiteral(std::string_view text, std::string place)
    : text_(text), place_(std::move(place)) {}

void PythonLiteral::refuse_here(const std::string& complaint) const {
  const auto line = 1 + std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at_), '\n');
  refuse(place_ + ", line " + std::to_string(line), complaint + "; export it again");
}

void PythonLiteral::skip_space() {
  while (at_ < text_.size()) {
    if (text_[at_] == '#')
      at_ = std::min(text_.find('\n', at_), text_.size());
    else if (std::string_view(" \t\r\n\f").find(text_[at_]) != std::string_view::npos)
      ++at_;
    else
      return;
  }
}

// The next character that matters, '\0' at the end.
char PythonLiteral::peek() {
  skip_space();
  return at_ < text_.size() ? text_[at_] : '\0';
}

bool PythonLiteral::accept(char c) {
  if (peek() != c || at_ >= text_.size()) return false;
  ++at_;
  return true;
}

void PythonLiteral::expect(char c) {
  if (!accept(c)) refuse_here(std::string("'") + c + "' is missing");
}

void PythonLiteral::append_string(std::string& target) {
  const char quote = text_[at_++];
  for (; at_ < text_.size() && text_[at_] != quote; ++at_) {
    if (text_[at_] == '\\') ++at_;  // keeps what follows; the keys and values used have no escapes
    if (at_ >= text_.size() || text_[at_] == '\n') break;
    target += text_[at_];
  }
  if (at_ >= text_.size() || text_[at_] != quote) refuse_here("a string is not closed");
  ++at_;
}

std::string PythonLiteral::string() {
  if (peek() == 'b') ++at_;
  std::string result;
  if (at_ >= text_.size() || (text_[at_] != '\'' && text_[at_] != '"'))
    refuse_here("a string must stand here");
  while (peek() == '\'' || peek() == '"') append_string(result);
  return result;
}

// A number or a name: what reaches up to the next mark.
std::string_view PythonLiteral::word() {
  skip_space();
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n\f,:#'\"()[]{}", at_), text_.size());
  const std::string_view result = text_.substr(at_, end - at_);
  at_ = end;
  return result;
}

std::vector<double> PythonLiteral::numbers() {
  const char close = peek() == '(' ? ')' : ']';
  expect(close == ')' ? '(' : '[');
  std::vector<double> result;
  while (!accept(close)) {
    result.push_back(number_from(word(), place_));
    if (!accept(',') && peek() != close) refuse_here("',' is missing");
  }
  return result;
}

void PythonLiteral::skip_group(char close, bool pairs, int depth) {
  ++at_;
  while (!accept(close)) {
    skip_value(depth + 1);
    if (pairs) {
      expect(':');
      skip_value(depth + 1);
    }
    if (!accept(',') && peek() != close) refuse_here("',' is missing");
  }
}

void PythonLiteral::skip_value(int depth) {
  if (depth > kMaxDepth) refuse_here("nested deeper than 64 levels");
  const char first = peek();
  const bool bytes =
      first == 'b' && at_ + 1 < text_.size() && (text_[at_ + 1] == '\'' || text_[at_ + 1] == '"');
  if (first == '[') return skip_group(']', false, depth);
  if (first == '(') return skip_group(')', false, depth);
  if (first == '{') return skip_group('}', true, depth);
  if (first == '\'' || first == '"' || bytes) {
    string();
    return;
  }
  const std::string_view value = word();
  if (value != "None" && value != "True" && value != "False") number_from(value, place_);
}

void PythonLiteral::each_key(const std::function<void(const std::string& key)>& read_value) {
  expect('{');
  while (!accept('}')) {
    const std::string key = string();
    expect(':');
    read_value(key);
    if (!accept(',') && peek() != '}') refuse_here("',' is missing");
  }
  skip_space();
  if (at_ < text_.size()) refuse_here("something follows the dictionary");
}

}  // namespace bosk::camera_files
