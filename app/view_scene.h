#pragma once

#include <string>
#include <vector>

#include "app/console.h"
#include "app/stage_options.h"
#include "core/render/scatter.h"
#include "ui/forest_scene.h"

namespace bosk {

// Which trees stand where, as the command line says it.
struct SceneArguments {
  std::vector<std::string> packages;
  std::string density, positions;  // files; empty: none
  ScatterOptions scatter;
};

// Throws CLI::ValidationError (bad usage) for arguments that contradict each other, Error for files
// that are no use.
ForestScene make_scene(const SceneArguments& arguments, Console& console);

}  // namespace bosk
