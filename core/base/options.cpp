#include "core/base/options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/error.h"

namespace bosk {
namespace {

template <class T>
std::string number_text(T number) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return {buffer.data(), end};
}

[[noreturn]] void refuse(const Option& option, const std::string& text, const std::string& wanted) {
  throw Error("option " + option.name + "=" + text + ": " + wanted + " (" + option.help + ")");
}

template <class T>
T parse_number(const Option& option, const std::string& text) {
  T number{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  const double value = static_cast<double>(number);
  const bool whole = result.ec == std::errc() && result.ptr == end && std::isfinite(value);
  if (!whole || value < option.minimum || value > option.maximum) {
    refuse(option, text, "give a number from " + number_text(option.minimum) + " to " +
                             number_text(option.maximum) +
                             (option.unit.empty() ? "" : " " + option.unit));
  }
  return number;
}

struct Setter {
  const Option& option;
  const std::string& text;

  void operator()(bool* value) const {
    if (text != "true" && text != "false") refuse(option, text, "give true or false");
    *value = text == "true";
  }
  void operator()(int* value) const { *value = parse_number<int>(option, text); }
  void operator()(double* value) const { *value = parse_number<double>(option, text); }
  void operator()(std::string* value) const {
    const auto& choices = option.choices;
    if (!choices.empty() && std::find(choices.begin(), choices.end(), text) == choices.end()) {
      std::string list;
      for (const std::string& choice : choices) list += (list.empty() ? "" : ", ") + choice;
      refuse(option, text, "choose one of " + list);
    }
    *value = text;
  }
};

struct Printer {
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const int* value) const { return number_text(*value); }
  std::string operator()(const double* value) const { return number_text(*value); }
  std::string operator()(const std::string* value) const { return *value; }
};

}  // namespace

std::string value_text(const Option& option) { return std::visit(Printer{}, option.value); }

void set_value(const Option& option, const std::string& text) {
  std::visit(Setter{option, text}, option.value);
}

std::string values_text(const Options& options) {
  std::string all;
  for (const Option& option : options) {
    all += (all.empty() ? "" : " ") + option.name + "=" + value_text(option);
  }
  return all;
}

}  // namespace bosk
