#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/project_work.h"
#include "app/run_summary.h"
#include "core/project/stages.h"

namespace bosk {
namespace {

struct StageArguments {
  std::string folder;
  StageChoices choices;
};

ExitStatus run_stage(const std::string& stage, const StageArguments& arguments, Console& console) {
  ProjectWork work(arguments.folder, arguments.choices, console);
  const bool finished = work.is_finished(stage);
  const Run run = finished ? Run{} : work.run({stage});
  console.result(arguments.folder + ": " + stage +
                     (finished ? " was finished before" : " is finished") + times_text(run.times),
                 {{"project", arguments.folder},
                  {"stage", stage},
                  {"key", hex(stage_key(work.capture(), work.project().recipe, stage))},
                  {"finished_before", finished},
                  {"stages", times_json(run.times)}});
  return ExitStatus::done;
}

void add_stage_command(CLI::App& app, Request& request, const std::string& stage,
                       const std::string& description) {
  CLI::App& command =
      add_command(app, request, stage, description, "bosk " + stage + " oak --preset fast");
  auto arguments = std::make_shared<StageArguments>();
  command.add_option("PROJECT", arguments->folder, "folder of the project")->required();
  std::vector<std::string> groups = stages_up_to(stage);
  groups.insert(groups.begin(), "calibrate");
  add_stage_options(command, groups, arguments->choices);
  command.callback([stage, arguments, &request] {
    request.run = [stage, arguments](Console& console) {
      return run_stage(stage, *arguments, console);
    };
  });
}

}  // namespace

void add_stage_commands(CLI::App& app, Request& request) {
  add_stage_command(app, request, "opacity", "up to the opacity: where the tree is, and how dense");
  add_stage_command(app, request, "radiance",
                    "up to the fine volume of opacity and view-dependent colour");
  add_stage_command(app, request, "texture", "up to the billboards' textures, at every level");
  add_stage_command(app, request, "compress", "up to the codebooks that textures are packed with");
}

}  // namespace bosk
