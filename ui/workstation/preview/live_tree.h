#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/render/scatter.h"
#include "ui/forest_scene.h"
#include "ui/picture_pace.h"
#include "ui/widgets/pictures.h"

namespace bosk {

struct Workspace;

// What the panel shows of a package: its tree alone or as a forest.
struct LiveTreeState {
  // Half of what the viewer takes: here a picture keeps the rest of the window waiting.
  ViewOptions look = [] {
    ViewOptions options;
    options.frame_ms = 25.0;
    options.still_ms = 1000.0;
    return options;
  }();
  ScatterOptions forest;
  ViewCamera camera;
  bool framed = false;  // the camera has been put before the tree

  // What `scene` was made of, or is being made of
  std::shared_ptr<const std::vector<std::byte>> package;
  std::string forest_text;
  std::shared_ptr<const SceneTree> tree;
  std::shared_ptr<const ForestScene> scene;  // null until it is made

  // Drawn by Workspace::tree_pictures; while things move perhaps in fewer pixels
  PicturePace pace;
  PictureKey wanted;
  double share = 1.0;  // of the width and height of `wanted`
  Texture texture;
  std::string trouble;
  const ForestScene* drawn_scene = nullptr;

  // Drawn by the CPU
  int job = 0;
  PictureKey job_key;
  const ForestScene* job_scene = nullptr;
  std::shared_ptr<const Image<glm::u8vec4>> slow_picture;
  std::uint64_t slow_revision = 0;
};

// The tree live in what is left of the window, with its options and figures at the right.
void draw_live_tree(Workspace& workspace);

// One tree over grey, drawn by the CPU in at most `most_px` of height.
Image<glm::u8vec4> slow_picture(const SceneTree& tree, const PictureKey& key,
                                const ViewOptions& options, int most_px, Progress& progress);

}  // namespace bosk
