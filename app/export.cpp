#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/project_work.h"
#include "core/base/system_error.h"
#include "core/image/image_io.h"
#include "core/photo/camera_files.h"
#include "core/project/original_pixels.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

struct ExportArguments {
  std::string source, format, output;
};

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw system_error(folder, "created", failure.value());
}

// Cameras as photographed, named by the photos' own files.
std::size_t export_cameras(ProjectWork& work, const ExportArguments& arguments) {
  const Run run = work.run({"view"});
  std::vector<Camera> cameras;
  std::vector<fs::path> images;
  for (const Photo& view : *run.results.views) {
    cameras.push_back(view.original_camera);
    for (const SourceFile& photo : work.capture().photos) {
      if (photo.name == view.name) images.push_back(photo.path.filename());
    }
  }
  write_cameras(cameras, arguments.format, arguments.output, images);
  return cameras.size();
}

// Mattes in the pixels of the photos as taken, so that they serve beside the original photos.
std::size_t export_mattes(ProjectWork& work, const ExportArguments& arguments, Console& console) {
  const Run run = work.run({"view", "matte"});
  const Photos& views = *run.results.views;
  make_folder(arguments.output);
  console.progress().begin("Writing mattes", views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Image<glm::vec4> matte = in_original_pixels((*run.results.mattes)[i].rgba, views[i]);
    write_png(fs::path(arguments.output) / (views[i].name + ".png"), rgba8_from_straight(matte));
    console.progress().advance();
  }
  return views.size();
}

ExitStatus export_something(const ExportArguments& arguments, Console& console) {
  ProjectWork work(arguments.source, {}, console);
  const bool mattes = arguments.format == "mattes";
  const std::size_t count =
      mattes ? export_mattes(work, arguments, console) : export_cameras(work, arguments);
  console.result(printable(arguments.output) + ": " + std::to_string(count) +
                     (mattes ? " mattes" : " cameras"),
                 {{"output", arguments.output}, {"format", arguments.format}, {"count", count}});
  return ExitStatus::done;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names = camera_format_names();
  names.push_back("mattes");
  return names;
}

}  // namespace

void add_export_command(CLI::App& app, Request& request) {
  CLI::App& command =
      add_command(app, request, "export", "write a project's cameras or mattes for other programs",
                  "bosk export oak --to colmap sparse");
  auto arguments = std::make_shared<ExportArguments>();
  command.add_option("PROJECT", arguments->source, "folder of the project")->required();
  command
      .add_option("--to", arguments->format,
                  "cameras as colmap, colmap-binary, transforms or cameramodel; or mattes: RGBA "
                  "PNGs with straight alpha, in the photos' own pixels")
      ->required()
      ->check(CLI::IsMember(format_names()))
      ->type_name("FORMAT");
  command.add_option("OUT", arguments->output, "folder or file to write")->required();
  command.callback([arguments, &request] {
    request.run = [arguments](Console& console) { return export_something(*arguments, console); };
  });
}

}  // namespace bosk
