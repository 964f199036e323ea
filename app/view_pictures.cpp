#include "app/view_pictures.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/number_text.h"
#include "core/base/system_error.h"
#include "ui/scene_painter.h"

namespace bosk {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

void draw_pictures(const ForestScene& scene, const PictureArguments& arguments,
                   const ViewCamera& camera, const ViewOptions& options, Console& console) {
  if (!arguments.turntable.empty()) make_folder(arguments.turntable);
  ScenePainter painter(scene, options, arguments.size_px);
  Json pictures = Json::array(), result;
  FrameFigures figures;
  std::string text;
  if (!arguments.screenshot.empty()) {
    figures = painter.paint(arguments.screenshot, camera, 0.0);
    pictures.push_back(arguments.screenshot);
    text += printable(arguments.screenshot) + ": ";
  }
  if (!arguments.turntable.empty()) {
    const TurntableFiles files =
        write_turntable(painter, arguments.turntable, arguments.frames, camera, console.progress());
    figures = files.figures;
    for (const auto& path : files.pictures) pictures.push_back(path.string());
    if (files.video) result["video"] = files.video->string();
    if (files.is_failure) console.warn(files.no_video);
    if (!files.is_failure && !files.no_video.empty()) console.say(files.no_video);
    text += printable(arguments.turntable) + ": " + std::to_string(arguments.frames) + " pictures" +
            (files.video ? " and a video; " : "; ");
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
