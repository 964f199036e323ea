#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/project_work.h"
#include "core/base/system_error.h"
#include "core/photo/camera_files.h"
#include "core/project/export.h"

namespace bosk {
namespace {

struct ExportArguments {
  std::string source, format, output;
};

ExitStatus export_something(const ExportArguments& arguments, Console& console) {
  ProjectWork work(arguments.source, {}, console);
  const bool mattes = arguments.format == "mattes";
  const Results results = work.run(mattes ? std::vector<std::string>{"view", "matte"}
                                          : std::vector<std::string>{"view"})
                              .results;
  const std::size_t count =
      mattes ? export_mattes(*results.views, *results.mattes, arguments.output, console.progress())
             : export_cameras(*results.views, work.capture(), arguments.format, arguments.output);
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
