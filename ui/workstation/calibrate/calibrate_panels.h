#pragma once

#include <vector>

#include "core/photo/camera.h"

namespace bosk {

struct Workspace;

// Parts of step Calibrate. `cameras` are those of the project's photos.
void draw_frusta(Workspace& workspace, const std::vector<Camera>& cameras);
void draw_camera_table(Workspace& workspace, const std::vector<Camera>& cameras);

}  // namespace bosk
