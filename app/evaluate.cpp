#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/project_work.h"
#include "core/base/number_text.h"
#include "core/project/evaluation.h"
#include "core/project/report.h"

namespace bosk {
namespace {

struct EvaluateArguments {
  std::string folder, cameras, truth, report;
  int hold_out = 6;
  double min_psnr = 0.0, min_ssim = -1.0;
};

Evaluation evaluate(const EvaluateArguments& arguments, ProjectWork& work, Console& console) {
  const EvaluationSource source{
      work.project(), work.capture(),
      [&work](const Capture& capture, const std::vector<std::string>& wanted, Share share) {
        return work.run(capture, wanted, share);
      }};
  Progress& progress = console.progress();
  if (arguments.cameras.empty()) return evaluate_held_out(source, arguments.hold_out, progress);
  return evaluate_against(source, arguments.cameras, arguments.truth, progress);
}

ExitStatus judged(const EvaluateArguments& arguments, const ViewScore& mean, Console& console) {
  if (mean.psnr >= arguments.min_psnr && mean.ssim >= arguments.min_ssim) return ExitStatus::done;
  console.say("bosk: below the quality asked for: " + number_text(mean.psnr, 3) + " dB, SSIM " +
              number_text(mean.ssim, 4));
  return ExitStatus::below_quality;
}

ExitStatus run_evaluate(const EvaluateArguments& arguments, Console& console) {
  ProjectWork work(arguments.folder, {}, console);
  const Evaluation evaluation = evaluate(arguments, work, console);
  if (!arguments.report.empty()) write_report(arguments.report, evaluation, work.project());
  console.result(figures_text(evaluation), figures_json(evaluation));
  return judged(arguments, evaluation.scores.mean, console);
}

}  // namespace

void add_evaluate_command(CLI::App& app, Request& request) {
  CLI::App& command = add_command(app, request, "evaluate",
                                  "compare the package with pictures that it was not made from",
                                  "bosk evaluate oak --hold-out 6 --report report");
  auto arguments = std::make_shared<EvaluateArguments>();
  command.add_option("PROJECT", arguments->folder, "folder of the project")->required();
  CLI::Option* hold_out = command.add_option(
      "--hold-out", arguments->hold_out,
      "leave every N-th photo out of all stages and compare with their mattes (2 to 1000; 6 unless "
      "given)");
  hold_out->check(CLI::Range(2, 1000))->type_name("N");
  CLI::Option* cameras = command.add_option(
      "--cameras", arguments->cameras, "compare for these cameras instead, with all photos used");
  cameras->type_name("FILE|DIR")->excludes(hold_out);
  CLI::Option* truth = command.add_option(
      "--truth", arguments->truth,
      "true RGBA pictures for --cameras, straight alpha, in each camera's lens and size, named as "
      "its photo");
  truth->type_name("DIR")->needs(cameras);
  cameras->needs(truth);
  command
      .add_option("--report", arguments->report,
                  "folder for contact-sheet.png, figures.txt, figures.json and report.html")
      ->type_name("DIR");
  command
      .add_option("--min-psnr", arguments->min_psnr,
                  "end with exit status 4 when the mean PSNR is below this (dB)")
      ->type_name("DB");
  command
      .add_option("--min-ssim", arguments->min_ssim,
                  "end with exit status 4 when the mean SSIM is below this (-1 to 1)")
      ->type_name("S");
  command.callback([arguments, &request] {
    request.run = [arguments](Console& console) { return run_evaluate(*arguments, console); };
  });
}

}  // namespace bosk
