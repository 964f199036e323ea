#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "ui/widgets/image_view.h"
#include "ui/workstation/notice.h"
#include "ui/workstation/photos/large_photo.h"

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct PhotosStepState {
  PhotoShelf shelf;
  Notices said;
  std::string typed;  // where photos to add are
  std::string moved;  // where a missing photo is
  // Photos as the project names them:
  std::set<std::filesystem::path> chosen;  // to be removed
  std::filesystem::path shown;             // large; empty: the grid
  std::string pointed_at;                  // name of the photo that the mouse is on
  ImageView view;
  LargePhoto large;
  int last_frame = 0;  // of Dear ImGui, when the step was drawn
};

void draw_photos_step(Workspace& workspace);

}  // namespace bosk
