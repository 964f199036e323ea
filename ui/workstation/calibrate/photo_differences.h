#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/base/content_hash.h"
#include "core/radiance/photo_residuals.h"

namespace bosk {

struct Workspace;

// How far each photo's matte is from the volume that is held in memory.
struct PhotoDifferences {
  std::map<std::string, PhotoResidual> by_name;
  ContentHash volume, mattes;  // keys of what was compared
  bool has_colour = false;     // else opacity alone was compared
};

// Compares anew, by a job, where volume or mattes are others. Once a frame by the step that shows
// it.
void follow_differences(Workspace& workspace);
// Why there is nothing to compare; empty when there is.
std::string obstacle_to_differences(const Workspace& workspace);

}  // namespace bosk
