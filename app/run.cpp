#include <CLI/CLI.hpp>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/project_work.h"
#include "app/run_summary.h"
#include "core/base/number_text.h"
#include "core/base/system_error.h"
#include "core/project/export.h"
#include "core/project/stages.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::string folder, output;
  StageChoices choices;
};

ExitStatus run_all(const RunArguments& arguments, Console& console) {
  ProjectWork work(arguments.folder, arguments.choices, console);
  const Run run = work.run({"pack"});
  const std::vector<std::byte>& package = *run.results.package;
  const fs::path output =
      arguments.output.empty() ? usual_package_path(work.project()) : fs::path(arguments.output);
  write_package_file(output, package);
  console.result(
      printable(output.string()) + ": " + size_text(package.size()) + times_text(run.times),
      {{"package", output.string()}, {"bytes", package.size()}, {"stages", times_json(run.times)}});
  return ExitStatus::done;
}

void add(CLI::App& app, Request& request, const std::string& name, const std::string& description) {
  CLI::App& command =
      add_command(app, request, name, description, "bosk " + name + " oak -o oak.bosk");
  auto arguments = std::make_shared<RunArguments>();
  command.add_option("PROJECT", arguments->folder, "folder of the project")->required();
  command
      .add_option("-o,--output", arguments->output,
                  "the package to write (PROJECT/NAME-OF-PROJECT.bosk unless given)")
      ->type_name("TREE.bosk");
  std::vector<std::string> groups = stages_up_to("pack");
  groups.insert(groups.begin(), "calibrate");
  add_stage_options(command, groups, arguments->choices);
  command.callback([arguments, &request] {
    request.run = [arguments](Console& console) { return run_all(*arguments, console); };
  });
}

}  // namespace

void add_run_command(CLI::App& app, Request& request) {
  add(app, request, "pack", "all stages, and the package written (the same as run)");
  add(app, request, "run", "all stages: from the photos to the package");
}

}  // namespace bosk
