#include "app/view_pictures.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "app/run_program.h"
#include "app/run_summary.h"
#include "core/base/atomic_file.h"
#include "core/base/system_error.h"
#include "core/image/image_io.h"
#include "core/render/gl/headless_context.h"
#include "ui/forest_picture.h"
#include "ui/view_marks.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFramesPerSecond = 30;

Json json_of(const FrameFigures& figures) {
  Json levels = Json::object();
  for (std::size_t level = 0; level < figures.by_level.size(); ++level) {
    if (figures.by_level[level] > 0) levels[std::to_string(level)] = figures.by_level[level];
  }
  return {{"billboards", figures.billboards},
          {"billboards_by_level", levels},
          {"ranges", figures.ranges},
          {"trees", figures.instances},
          {"trees_drawn", figures.instances_drawn},
          {"budget", figures.budget},
          {"detail", figures.detail},
          {"overdraw", figures.overdraw},
          {"draw_list_ms", figures.list_ms},
          {"scenery_ms", figures.scenery_ms},
          {"trees_ms", figures.trees_ms},
          {"picture_ms", figures.picture_ms},
          {"texture_bytes", figures.texture_bytes},
          {"index_bytes", figures.index_bytes},
          {"cell_bytes", figures.cell_bytes},
          {"frame_bytes", figures.frame_bytes},
          {"bc3", figures.bc3},
          {"driver", figures.driver}};
}

std::string text_of(const FrameFigures& figures) {
  return std::to_string(figures.billboards) + " billboards of " +
         std::to_string(figures.instances_drawn) + " trees, draw list " +
         number_text(figures.list_ms, 1) + " ms, picture " + number_text(figures.picture_ms, 0) +
         " ms (" + figures.driver + ")";
}

std::string frame_name(int number) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "frame-%04d.png", number);
  return name.data();
}

class Painter {
 public:
  Painter(const ForestScene& scene, const PictureArguments& arguments, const ViewOptions& options)
      : scene_(scene),
        arguments_(arguments),
        options_(options),
        picture_(scene, context_.description(), OffscreenTarget::Precision::bits_32) {}

  FrameFigures paint(const fs::path& path, const ViewCamera& view, double wind_time_s) {
    const Camera camera = camera_of(view, arguments_.size_px, view_angle(options_));
    FrameFigures figures =
        picture_.draw(camera, options_, std::uint64_t(options_.budget), wind_time_s);
    Image<glm::u8vec3> pixels = picture_.read();
    if (options_.cameras) paint_marks(pixels, view_marks(scene_, camera, target_of(view)));
    write_png(path, pixels);
    return figures;
  }

 private:
  const ForestScene& scene_;
  const PictureArguments& arguments_;
  const ViewOptions& options_;
  HeadlessContext context_;
  ForestPicture picture_;
};

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw system_error(folder, "created", failure.value());
}

// Encodes the first pictures in the folder; says what there is to say when that cannot be done.
// Written beside its place and renamed, so that a video that is there is whole.
std::optional<fs::path> make_video(const fs::path& folder, int frames, Console& console) {
  const auto ffmpeg = find_program("ffmpeg");
  if (!ffmpeg) {
    console.say("no video: ffmpeg is not in PATH; the pictures are all there (Debian: ffmpeg)");
    return std::nullopt;
  }
  const std::string part = "turntable.part.mp4";
  const fs::path log = folder / "ffmpeg.log", video = folder / "turntable.mp4";
  std::error_code none;
  fs::remove(log, none);
  const int status = run_program(*ffmpeg, {"-y",         "-nostdin",
                                           "-loglevel",  "error",
                                           "-framerate", std::to_string(kFramesPerSecond),
                                           "-i",         "frame-%04d.png",
                                           "-frames:v",  std::to_string(frames),
                                           "-vf",        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                           "-c:v",       "libx264",
                                           "-crf",       "18",
                                           "-pix_fmt",   "yuv420p",
                                           "-movflags",  "+faststart",
                                           part},
                                 folder, log, console.progress());
  if (status != 0) {
    fs::remove(folder / part, none);
    console.warn("no video: ffmpeg ended with status " + std::to_string(status) + "; see " +
                 printable(log.string()));
    return std::nullopt;
  }
  fs::remove(log, none);
  fs::rename(folder / part, video);
  return video;
}

}  // namespace

void draw_pictures(const ForestScene& scene, const PictureArguments& arguments,
                   const ViewCamera& camera, const ViewOptions& options, Console& console) {
  if (!arguments.turntable.empty()) make_folder(arguments.turntable);
  Painter painter(scene, arguments, options);
  Json pictures = Json::array(), result;
  FrameFigures figures;
  std::string text;
  if (!arguments.screenshot.empty()) {
    figures = painter.paint(arguments.screenshot, camera, 0.0);
    pictures.push_back(arguments.screenshot);
    text += printable(arguments.screenshot) + ": ";
  }
  if (!arguments.turntable.empty()) {
    console.progress().begin("Turntable", std::size_t(arguments.frames));
    for (int i = 0; i < arguments.frames; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / arguments.frames;
      const fs::path path = fs::path(arguments.turntable) / frame_name(i);
      figures = painter.paint(path, walked_round(camera, angle, scene.terrain),
                              double(i) / kFramesPerSecond);
      pictures.push_back(path.string());
      console.progress().advance();
    }
    const auto video = make_video(arguments.turntable, arguments.frames, console);
    if (video) result["video"] = video->string();
    text += printable(arguments.turntable) + ": " + std::to_string(arguments.frames) + " pictures" +
            (video ? " and a video; " : "; ");
  }
  result["pictures"] = pictures;
  result["size_px"] = {arguments.size_px.x, arguments.size_px.y};
  result["eye"] = {camera.eye.x, camera.eye.y, camera.eye.z};
  const glm::dvec3 at = target_of(camera);
  result["at"] = {at.x, at.y, at.z};
  result["figures"] = json_of(figures);
  console.result(text + text_of(figures), result);
}

}  // namespace bosk
