#include "ui/scene_painter.h"

#include <array>
#include <cstdio>
#include <numbers>

#include "core/base/atomic_file.h"
#include "core/base/run_program.h"
#include "core/base/system_error.h"
#include "core/image/image_io.h"
#include "ui/view_marks.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

constexpr int kFramesPerSecond = 30;

std::string frame_name(int number) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "frame-%04d.png", number);
  return name.data();
}

// Encodes the pictures in the folder. Written beside its place and renamed, so that a video that is
// there is whole.
void make_video(const fs::path& folder, TurntableFiles& files, const Progress& progress) {
  const auto ffmpeg = find_program("ffmpeg");
  if (!ffmpeg) {
    files.no_video = "no video: ffmpeg is not in PATH; the pictures are all there (Debian: ffmpeg)";
    return;
  }
  const std::string part = "turntable.part.mp4";
  const fs::path log = folder / "ffmpeg.log", video = folder / "turntable.mp4";
  std::error_code none;
  fs::remove(log, none);
  const int status = run_program(*ffmpeg, {"-y",         "-nostdin",
                                           "-loglevel",  "error",
                                           "-framerate", std::to_string(kFramesPerSecond),
                                           "-i",         "frame-%04d.png",
                                           "-frames:v",  std::to_string(files.pictures.size()),
                                           "-vf",        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                           "-c:v",       "libx264",
                                           "-crf",       "18",
                                           "-pix_fmt",   "yuv420p",
                                           "-movflags",  "+faststart",
                                           part},
                                 folder, log, progress);
  if (status != 0) {
    fs::remove(folder / part, none);
    files.no_video = "no video: ffmpeg ended with status " + std::to_string(status) + "; see " +
                     printable(log.string());
    files.is_failure = true;
    return;
  }
  fs::remove(log, none);
  fs::rename(folder / part, video);
  files.video = video;
}

}  // namespace

ScenePainter::ScenePainter(const ForestScene& scene, const ViewOptions& options,
                           const glm::ivec2& size_px)
    : scene_(scene),
      options_(options),
      size_px_(size_px),
      picture_(scene, context_.description(), OffscreenTarget::Precision::bits_32) {}

FrameFigures ScenePainter::paint(const fs::path& path, const ViewCamera& view, double wind_time_s) {
  const Camera camera = camera_of(view, size_px_, view_angle(options_));
  FrameFigures figures =
      picture_.draw(camera, options_, std::uint64_t(options_.budget), wind_time_s);
  Image<glm::u8vec3> pixels = picture_.read();
  if (options_.cameras) paint_marks(pixels, view_marks(scene_, camera, target_of(view)));
  write_png(path, pixels);
  return figures;
}

TurntableFiles write_turntable(ScenePainter& painter, const fs::path& folder, int frames,
                               const ViewCamera& camera, Progress& progress) {
  TurntableFiles files;
  make_folder(folder);
  progress.begin("Turntable", std::size_t(frames));
  for (int i = 0; i < frames; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / frames;
    files.pictures.push_back(folder / frame_name(i));
    files.figures =
        painter.paint(files.pictures.back(), walked_round(camera, angle, painter.scene().terrain),
                      double(i) / kFramesPerSecond);
    progress.advance();
  }
  make_video(folder, files, progress);
  return files;
}

}  // namespace bosk
