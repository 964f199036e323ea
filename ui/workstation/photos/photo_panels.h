#pragma once

#include <filesystem>

namespace bosk {

struct Workspace;

// Parts of step Photos.
void draw_photo_grid(Workspace& workspace);
void draw_photo_detail(Workspace& workspace);
void draw_camera_wheel(Workspace& workspace);

// Shows a photo large, as the project names it.
void show_photo(Workspace& workspace, const std::filesystem::path& photo);

}  // namespace bosk
