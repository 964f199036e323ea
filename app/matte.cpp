#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/project_work.h"
#include "app/run_summary.h"
#include "core/base/atomic_file.h"
#include "core/base/system_error.h"
#include "core/project/matte_sheet.h"
#include "core/project/stages.h"

namespace bosk {
namespace {

using Json = nlohmann::ordered_json;

struct MatteArguments {
  std::string folder, sheet;
  StageChoices choices;
};

Json photos_json(const std::vector<MatteDoubt>& doubts) {
  const double median = median_doubt(doubts);
  Json all = Json::array();
  for (const MatteDoubt& doubt : doubts) {
    all.push_back({{"photo", doubt.photo},
                   {"confidence", std::max(0.0, 1.0 - doubt.doubt)},
                   {"look_first", stands_out(doubt, median)},
                   {"reason", doubt.reason}});
  }
  return all;
}

// "; look at 003 (tree smaller than in the others) and 2 more first".
std::string first_text(const std::vector<MatteDoubt>& doubts) {
  const double median = median_doubt(doubts);
  const MatteDoubt* worst = nullptr;
  int more = -1;
  for (const MatteDoubt& doubt : doubts) {
    if (!stands_out(doubt, median)) continue;
    if (!worst || doubt.doubt > worst->doubt) worst = &doubt;
    ++more;
  }
  if (!worst) return "";
  return "; look first at " + printable(worst->photo) +
         (worst->reason.empty() ? "" : " (" + worst->reason + ")") +
         (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

ExitStatus matte(const MatteArguments& arguments, Console& console) {
  if (!arguments.sheet.empty()) require_writable(arguments.sheet);
  ProjectWork work(arguments.folder, arguments.choices, console);
  const bool finished = work.is_finished("matte");
  const bool compare = !finished || console.json() || !arguments.sheet.empty();
  const Run run = compare ? work.run(work.capture(), {"photo", "matte"}, {0.0, 0.9}) : Run{};
  console.progress().scope(0.9, 1.0);
  std::vector<MatteDoubt> doubts;
  if (compare) {
    doubts = doubt_mattes(run.results.imported->photos, *run.results.mattes, console.progress());
  }
  if (!arguments.sheet.empty()) {
    write_matte_sheet(arguments.sheet, work.project().name(), run.results.imported->photos,
                      *run.results.mattes, doubts, console.progress());
  }
  console.result(printable(arguments.folder) + ": matte" +
                     (finished ? " was finished before" : " is finished") + times_text(run.times) +
                     first_text(doubts),
                 {{"project", arguments.folder},
                  {"stage", "matte"},
                  {"key", hex(stage_key(work.capture(), work.project().recipe, "matte"))},
                  {"finished_before", finished},
                  {"photos", photos_json(doubts)},
                  {"stages", times_json(run.times)}});
  return ExitStatus::done;
}

}  // namespace

void add_matte_command(CLI::App& app, Request& request) {
  CLI::App& command = add_command(
      app, request, "matte", "up to the mattes: the tree's opacity and pure colour in every photo",
      "bosk matte oak --sheet mattes.html");
  auto arguments = std::make_shared<MatteArguments>();
  command.add_option("PROJECT", arguments->folder, "folder of the project")->required();
  command
      .add_option("--sheet", arguments->sheet,
                  "a page to judge the mattes by: each photo, its matte, the tree over black and "
                  "over magenta, those first that are least like the others")
      ->type_name("FILE.html");
  std::vector<std::string> groups = stages_up_to("matte");
  groups.insert(groups.begin(), "calibrate");
  add_stage_options(command, groups, arguments->choices);
  command.callback([arguments, &request] {
    request.run = [arguments](Console& console) { return matte(*arguments, console); };
  });
}

}  // namespace bosk
