#include "core/project/presets.h"

#include "core/base/error.h"

namespace bosk {
namespace {

const Preset* find_preset(const std::string& name) {
  for (const Preset& preset : presets()) {
    if (preset.name == name) return &preset;
  }
  return nullptr;
}

std::string preset_names() {
  std::string names;
  for (const Preset& preset : presets()) names += (names.empty() ? "" : ", ") + preset.name;
  return names;
}

}  // namespace

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = {
      {"fast",
       "a look within a minute",
       {{"opacity.max_cells", "540"},
        {"radiance.max_samples", "200"},
        {"radiance.subsets", "32"},
        {"radiance.epochs", "1"},
        {"radiance.last_epochs", "0"}}},
      {"default", "the balance that the figures in the README are measured with", {}},
      {"best",
       "the best picture, whatever the time and the size",
       {{"opacity.cell_px", "2.8"}, {"radiance.epochs", "4"}, {"radiance.coarse_epochs", "4"}}},
  };
  return all;
}

void apply_preset(Recipe& recipe, const std::string& name) {
  const Preset* chosen = find_preset(name);
  if (chosen == nullptr) {
    throw Error("preset " + name + ": there is none of that name; choose one of " + preset_names());
  }
  Recipe plain;
  for (const Preset& preset : presets()) {
    for (const auto& [option, value] : preset.values) {
      set_option(recipe, option, option_text(plain, option));
    }
  }
  for (const auto& [option, value] : chosen->values) set_option(recipe, option, value);
}

}  // namespace bosk
