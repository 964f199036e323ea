#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands.h"
#include "app/stage_options.h"
#include "app/view_pictures.h"
#include "app/view_scene.h"
#include "ui/viewer.h"
#include "ui/viewer_input.h"

namespace bosk {
namespace {

struct ViewArguments {
  SceneArguments scene;
  PictureArguments pictures;
  std::string size, eye, at;  // as given; empty: not
  OptionTexts options;
};

// The numbers of "1.5,-2,3"; throws CLI::ValidationError unless there are so many.
std::vector<double> numbers(const std::string& option, const std::string& text, char between,
                            std::size_t count, const char* wanted) {
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    double value = 0.0;
    const auto [rest, failure] = std::from_chars(at, end, value);
    if (failure != std::errc() || !std::isfinite(value) || std::abs(value) > 1e6) break;
    values.push_back(value);
    at = rest;
    if (at != end && *at == between && at + 1 != end)
      ++at;
    else
      break;
  }
  if (at != end || values.size() != count) {
    throw CLI::ValidationError(option + " " + text + ": give " + wanted);
  }
  return values;
}

std::optional<glm::dvec3> place(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto xyz = numbers(option, text, ',', 3, "metres east, north and up, such as 4,-8.5,1.7");
  return glm::dvec3(xyz[0], xyz[1], xyz[2]);
}

glm::ivec2 picture_size(const std::string& text) {
  if (text.empty()) return {1280, 800};
  const auto size = numbers("--size", text, 'x', 2, "WIDTHxHEIGHT, such as 1280x800");
  for (const double side : size) {
    if (side < 1.0 || side > 16384.0 || side != std::floor(side)) {
      throw CLI::ValidationError("--size " + text + ": give whole numbers from 1 to 16384");
    }
  }
  return {int(size[0]), int(size[1])};
}

ViewCamera start_camera(const ForestScene& scene, const ViewArguments& arguments,
                        const ViewOptions& options) {
  const ViewCamera whole = framing(scene, arguments.pictures.size_px, view_angle(options));
  const auto eye = place("--eye", arguments.eye), at = place("--at", arguments.at);
  if (!eye && !at) return whole;
  return looking_at(whole, eye.value_or(whole.eye), at.value_or(target_of(whole)));
}

std::string title_of(const ForestScene& scene) {
  std::string title;
  for (const auto& tree : scene.trees) title += (title.empty() ? "" : ", ") + tree->name;
  return title + " - Bosk";
}

ExitStatus view(ViewArguments arguments, Console& console) {
  ViewOptions options;
  set_options(arguments.options, describe(options));
  set_options(arguments.options, describe(arguments.scene.scatter));
  arguments.pictures.size_px = picture_size(arguments.size);
  place("--eye", arguments.eye);  // a slip of the pen is told before trees are read
  place("--at", arguments.at);
  const ForestScene scene = make_scene(arguments.scene, console);
  const ViewCamera camera = start_camera(scene, arguments, options);
  if (!arguments.pictures.screenshot.empty() || !arguments.pictures.turntable.empty()) {
    draw_pictures(scene, arguments.pictures, camera, options, console);
    return ExitStatus::done;
  }
  ViewerStart start{title_of(scene), options, camera, arguments.pictures.size_px};
  run_viewer(scene, start, console.progress(),
             [&console](const std::string& line) { console.say(line); });
  return ExitStatus::done;
}

std::string key_lines() {
  std::string lines = "In the window:\n";
  for (const KeyHelp& help : viewer_keys()) {
    lines += "  " + help.keys +
             std::string(help.keys.size() < 26 ? 26 - help.keys.size() : 1, ' ') + help.what + "\n";
  }
  return lines;
}

void add_picture_options(CLI::App& command, ViewArguments& arguments) {
  PictureArguments& pictures = arguments.pictures;
  const std::string group = "Pictures";
  command
      .add_option("--screenshot", pictures.screenshot,
                  "draw one picture into this PNG instead of opening a window; needs no display")
      ->type_name("FILE.png")
      ->group(group);
  command
      .add_option("--turntable", pictures.turntable,
                  "draw pictures once round the trees into this folder, made when missing, and a "
                  "video of them when ffmpeg is in PATH; needs no display")
      ->type_name("DIR")
      ->group(group);
  command
      .add_option("--frames", pictures.frames,
                  "pictures of the turntable, 30 a second (1 to 9999; 72 unless given)")
      ->check(CLI::Range(1, 9999))
      ->type_name("N")
      ->group(group);
  command
      .add_option("--size", arguments.size,
                  "of pictures and window in pixels (1x1 to 16384x16384; 1280x800 unless given)")
      ->type_name("WxH")
      ->group(group);
  command
      .add_option(
          "--eye", arguments.eye,
          "where the eye is, metres east, north and up (outside the trees, in the south, unless "
          "given)")
      ->type_name("X,Y,Z")
      ->group(group);
  command
      .add_option(
          "--at", arguments.at,
          "where it looks, and what the turntable goes round (the middle of the trees unless "
          "given)")
      ->type_name("X,Y,Z")
      ->group(group);
}

}  // namespace

void add_view_command(CLI::App& app, Request& request) {
  CLI::App& command = add_command(
      app, request, "view",
      "look at trees, alone or as a forest: in a window, as a picture or as a turntable",
      "bosk view oak.bosk\n"
      "  bosk view oak.bosk spruce.bosk --trees 500 --terrain_m 6\n"
      "  bosk view oak.bosk --trees 2000 --density map.png --screenshot forest.png\n"
      "  bosk view oak.bosk --turntable round --frames 90 --size 960x720\n\n" +
          key_lines());
  auto arguments = std::make_shared<ViewArguments>();
  command.add_option("TREE.bosk", arguments->scene.packages, "packages, one or more")->required();
  const std::string group = "Where trees stand";
  command
      .add_option("--density", arguments->scene.density,
                  "a grey picture of the area, north up: black stays clear, white grows the most")
      ->type_name("FILE.png")
      ->group(group);
  command
      .add_option("--positions", arguments->scene.positions,
                  "a table of places instead: columns x,y and, as wanted, z,turn_deg,scale,tree "
                  "(name or number of a package), named in the first line")
      ->type_name("FILE.csv")
      ->group(group);
  ScatterOptions scatter;
  add_options(command, describe(scatter), "", group, arguments->options);
  ViewOptions options;
  add_options(command, describe(options), "", "How they are drawn", arguments->options);
  add_picture_options(command, *arguments);
  command.callback([arguments, &request] {
    request.run = [arguments](Console& console) { return view(*arguments, console); };
  });
}

}  // namespace bosk
