#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/project/recipe.h"

namespace bosk {

// Options given on the command line, in the order given: name, text.
using OptionTexts = std::vector<std::pair<std::string, std::string>>;

// Adds each option as --PREFIXname=VALUE, with unit, range and default in the help; what is given
// is appended to `given`, names with the prefix.
void add_options(CLI::App& command, const Options& options, const std::string& prefix,
                 const std::string& group, OptionTexts& given);
// Sets options from texts whose names carry no prefix. Throws CLI::ValidationError (bad usage).
void set_options(const OptionTexts& given, const Options& options);

// Stage options given on the command line; a preset counts before all of them.
struct StageChoices {
  std::string preset;
  OptionTexts values;  // "stage.option"
};

// Adds --preset and, for each of `stage_names`, its options as --stage.name=VALUE with unit, range
// and default in the help.
void add_stage_options(CLI::App& command, const std::vector<std::string>& stage_names,
                       StageChoices& choices);

// Throws CLI::ValidationError (bad usage) when a value doesn't fit its option.
void set_options(const StageChoices& choices, Recipe& recipe);

}  // namespace bosk
