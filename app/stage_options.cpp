#include "app/stage_options.h"

#include <CLI/Error.hpp>
#include <algorithm>

#include "core/base/error.h"
#include "core/project/presets.h"

namespace bosk {
namespace {

std::string number_text(double number) {
  const Option option{"", "", "", &number, 0.0, 0.0, {}};
  return value_text(option);
}

struct RangeText {
  const Option& option;

  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const int*) const { return range(); }
  std::string operator()(const double*) const { return range(); }
  std::string operator()(const std::string*) const {
    std::string list;
    for (const std::string& choice : option.choices) list += (list.empty() ? "" : ", ") + choice;
    return list;
  }
  std::string range() const {
    return number_text(option.minimum) + " to " + number_text(option.maximum) +
           (option.unit.empty() ? "" : " " + option.unit);
  }
};

// "help (range; default value)"
std::string help_text(const Option& option) {
  const std::string range = std::visit(RangeText{option}, option.value);
  const std::string value = value_text(option);
  return option.help + " (" + (range.empty() ? "" : range + "; ") +
         (value.empty() ? "empty" : value) + " unless given)";
}

std::string preset_help() {
  std::string text = "a group of settings:";
  for (const Preset& preset : presets()) text += " " + preset.name + " (" + preset.help + "),";
  text.back() = '.';
  return text;
}

}  // namespace

void add_options(CLI::App& command, const Options& options, const std::string& prefix,
                 const std::string& group, OptionTexts& given) {
  for (const Option& option : options) {
    const std::string name = prefix + option.name;
    const auto keep = [&given, name](const std::string& text) { given.emplace_back(name, text); };
    command.add_option_function<std::string>("--" + name, keep, help_text(option))
        ->type_name("")
        ->group(group);
  }
}

void set_options(const OptionTexts& given, const Options& options) {
  for (const auto& [name, text] : given) {
    for (const Option& option : options) {
      if (option.name != name) continue;
      try {
        set_value(option, text);
      } catch (const Error& error) {
        throw CLI::ValidationError(error.what());
      }
    }
  }
}

void add_stage_options(CLI::App& command, const std::vector<std::string>& stage_names,
                       StageChoices& choices) {
  command.add_option("--preset", choices.preset, preset_help())->type_name("NAME");
  Recipe defaults;
  for (const OptionGroup& group : option_groups(defaults)) {
    const auto& names = stage_names;
    if (std::find(names.begin(), names.end(), group.stage) == names.end()) continue;
    add_options(command, group.options, group.stage + ".", "Options of the stage " + group.stage,
                choices.values);
  }
}

void set_options(const StageChoices& choices, Recipe& recipe) {
  try {
    if (!choices.preset.empty()) apply_preset(recipe, choices.preset);
    for (const auto& [name, value] : choices.values) set_option(recipe, name, value);
  } catch (const Error& error) {
    throw CLI::ValidationError(error.what());
  }
}

}  // namespace bosk
