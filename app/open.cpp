#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands.h"
#include "ui/workstation_window.h"

namespace bosk {
namespace {

ExitStatus open_window(const WorkstationStart& start, Console& console) {
  run_workstation(start, console.progress());
  return ExitStatus::done;
}

}  // namespace

void add_open_command(CLI::App& app, Request& request) {
  CLI::App& command =
      add_command(app, request, "open", "the workstation: from photographs to package in a window",
                  "bosk open oak\n  bosk                (the same without a project)");
  auto start = std::make_shared<WorkstationStart>();
  auto folder = std::make_shared<std::string>();
  auto landmarks = std::make_shared<std::string>();
  command.add_option("PROJECT", *folder, "folder of the project; none: the start page");
  command
      .add_option("--landmarks", *landmarks,
                  "keep in this file where buttons and pictures are in the window, a line each, "
                  "for programs that drive it")
      ->type_name("FILE");
  command.callback([=, &request] {
    if (!folder->empty()) start->project = *folder;
    start->landmarks = *landmarks;
    request.run = [start](Console& console) { return open_window(*start, console); };
  });
}

void open_by_default(Request& request) {
  request.run = [](Console& console) { return open_window({}, console); };
}

}  // namespace bosk
