#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/project/recipe.h"

namespace bosk {

// A named trade between time and quality: option values beside the defaults.
struct Preset {
  std::string name;
  std::string help;
  std::vector<std::pair<std::string, std::string>> values;  // "stage.name", value
};
const std::vector<Preset>& presets();

// Puts every option that any preset touches back to its default, then sets the preset's values.
// Throws Error that names the presets when there is none of that name.
void apply_preset(Recipe& recipe, const std::string& name);

}  // namespace bosk
