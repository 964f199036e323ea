#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace bosk::camera_files {

// Reads the text of a Python dictionary as far as .cameramodel files need it: strings (also b'...'
// and adjacent ones), numbers, lists, tuples, nested dictionaries, None, True, False, '#' comments,
// trailing commas. Nothing is run. Errors name the place and the line. The text must outlive the
// reader.
class PythonLiteral {
 public:
  PythonLiteral(std::string_view text, std::string place);

  // Calls `read_value` for each key of the dictionary that is the whole text; it reads or skips the
  // value.
  void each_key(const std::function<void(const std::string& key)>& read_value);
  std::string string();
  std::vector<double> numbers();  // a list or tuple of finite numbers
  void skip_value() { skip_value(0); }

 private:
  void skip_value(int depth);
  void skip_group(char close, bool pairs, int depth);
  void append_string(std::string& target);
  std::string_view word();
  void skip_space();
  char peek();
  bool accept(char c);
  void expect(char c);
  [[noreturn]] void refuse_here(const std::string& complaint) const;

  std::string_view text_;
  std::string place_;
  std::size_t at_ = 0;
};

}  // namespace bosk::camera_files
