#include "core/project/recipe.h"

#include "core/base/error.h"
#include "core/project/stages.h"

namespace bosk {
namespace {

Option named_option(Recipe& recipe, const std::string& name) {
  for (const OptionGroup& group : option_groups(recipe)) {
    for (const Option& option : group.options) {
      if (group.stage + "." + option.name == name) return option;
    }
  }
  throw Error("option " + name + ": there is none of that name; `bosk run --help` lists them");
}

}  // namespace

std::vector<OptionGroup> option_groups(Recipe& recipe) {
  std::vector<OptionGroup> groups = {{"calibrate", describe(recipe.calibrate)}};
  for (const Stage& stage : stages()) {
    if (stage.options) groups.push_back({stage.name, stage.options(recipe)});
  }
  return groups;
}

void set_option(Recipe& recipe, const std::string& name, const std::string& value) {
  Option option = named_option(recipe, name);
  option.name = name;  // so that a refusal names it as it is written on the command line
  set_value(option, value);
}

std::string option_text(const Recipe& recipe, const std::string& name) {
  Recipe copy = recipe;
  return value_text(named_option(copy, name));
}

}  // namespace bosk
