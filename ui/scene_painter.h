#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/render/gl/headless_context.h"
#include "ui/forest_picture.h"

namespace bosk {

// Draws pictures of a scene into files, without a window: in any thread that has no other OpenGL
// context, the same thread all its life. The scene must outlive it.
class ScenePainter {
 public:
  // Throws Error where there is no OpenGL.
  ScenePainter(const ForestScene& scene, const ViewOptions& options, const glm::ivec2& size_px);

  // Throws Error when the file cannot be written.
  FrameFigures paint(const std::filesystem::path& path, const ViewCamera& view, double wind_time_s);
  const ForestScene& scene() const { return scene_; }

 private:
  const ForestScene& scene_;
  ViewOptions options_;
  glm::ivec2 size_px_;
  HeadlessContext context_;
  ForestPicture picture_;
};

// What a turntable has become.
struct TurntableFiles {
  std::vector<std::filesystem::path> pictures;
  std::optional<std::filesystem::path> video;
  std::string no_video;     // why there is none: a sentence
  bool is_failure = false;  // of the encoder; else there is none
  FrameFigures figures;     // of the last picture
};

// Pictures once round the scene, beginning at `camera`, into FOLDER/frame-0000.png and so on,
// 30 a second; and FOLDER/turntable.mp4 where ffmpeg is in PATH. The folder is made when missing.
TurntableFiles write_turntable(ScenePainter& painter, const std::filesystem::path& folder,
                               int frames, const ViewCamera& camera, Progress& progress);

}  // namespace bosk
