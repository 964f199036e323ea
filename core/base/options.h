#pragma once

#include <string>
#include <variant>
#include <vector>

namespace bosk {

// One knob of a stage, described once: the command line, the sliders, the saved project, the cache
// key and the sweeps all read this. `value` points into the option struct that was described; the
// default is the value in a default-constructed struct.
struct Option {
  std::string name;  // snake_case, as on the command line: --stage.name=value
  std::string unit;  // "px", "m", "" for counts and ratios
  std::string help;  // one line that teaches
  std::variant<bool*, int*, double*, std::string*> value;
  double minimum = 0.0, maximum = 0.0;  // inclusive; numbers only
  std::vector<std::string> choices;     // strings only
};

// Each option struct S has, beside its declaration, `Options describe(S&)`.
using Options = std::vector<Option>;

// The value as text, numbers in the shortest form that reads back exactly, independent of the locale.
std::string value_text(const Option& option);
// Sets the value from text. Throws Error that names the option, its range or choices, and the text.
void set_value(const Option& option, const std::string& text);
// "codewords=1024 block_px=4 ...", in the order described: for cache keys and logs.
std::string values_text(const Options& options);

}  // namespace bosk
