#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/project_work.h"
#include "app/stage_options.h"
#include "core/base/system_error.h"
#include "core/project/capture.h"
#include "core/project/new_project.h"

namespace bosk {
namespace {

struct NewArguments {
  std::string folder, cameras, mattes, scribbles;
  std::vector<std::string> photos;
  bool replace = false;
  StageChoices choices;
};

NewProject wanted_project(const NewArguments& arguments) {
  NewProject wanted{arguments.folder, {}, arguments.cameras, arguments.mattes, arguments.scribbles};
  for (const std::string& photo : arguments.photos) wanted.photos.emplace_back(photo);
  return wanted;
}

std::string verdict_text(const PhotoVerdict& verdict) {
  return "  " + printable(verdict.name) + (verdict.accepted ? ": " : ": NOT USED, ") +
         printable(verdict.reason) + "\n";
}

nlohmann::json verdict_json(const PhotoVerdict& verdict) {
  return {{"name", verdict.name},
          {"accepted", verdict.accepted},
          {"reason", verdict.reason},
          {"width_px", verdict.width_px},
          {"height_px", verdict.height_px}};
}

void report(const std::string& folder, const Project& project, const Capture& capture,
            const ImportedPhotos& imported, Console& console) {
  std::string text = printable(folder) + ": project with " +
                     std::to_string(imported.photos.size()) + " of " +
                     std::to_string(project.photos.size()) + " photos in use\n";
  nlohmann::json verdicts = nlohmann::json::array();
  for (const PhotoVerdict& verdict : imported.verdicts) {
    text += verdict_text(verdict);
    verdicts.push_back(verdict_json(verdict));
  }
  console.result(text, {{"project", folder},
                        {"photos_given", project.photos.size()},
                        {"photos_used", imported.photos.size()},
                        {"photos", verdicts},
                        {"remarks", capture.remarks}});
}

void report_photos_alone(const std::string& folder, const Project& project, Console& console) {
  console.result(printable(folder) + ": project with " + std::to_string(project.photos.size()) +
                     " photos and no cameras yet; " + cameras_remedy(folder) + "\n",
                 {{"project", folder},
                  {"photos_given", project.photos.size()},
                  {"photos_used", 0},
                  {"photos", nlohmann::json::array()},
                  {"remarks", {"no cameras yet; " + cameras_remedy(folder)}}});
}

void tell_of_the_guess(const Project& project, Console& console) {
  if (!project.mattes.empty() || !project.scribbles.empty() || !project.strokes.empty()) return;
  console.say(
      "no mattes and no strokes: the tree will be guessed; better ones come with `bosk new "
      "--replace "
      "... --mattes DIR` or `--scribbles DIR`, or with strokes in the Matte step of `bosk open`");
}

ExitStatus make_new_project(const NewArguments& arguments, Console& console) {
  Recipe recipe;
  set_options(arguments.choices, recipe);
  const Project project =
      make_project(wanted_project(arguments), recipe, arguments.replace, console.progress());
  if (project.cameras.empty()) {
    report_photos_alone(arguments.folder, project, console);
    return ExitStatus::done;
  }
  ProjectWork work(project, console);
  const Run run = work.run({"photo"});
  tell_of_the_guess(project, console);
  report(arguments.folder, project, work.capture(), *run.results.imported, console);
  return ExitStatus::done;
}

}  // namespace

void add_new_command(CLI::App& app, Request& request) {
  CLI::App& command = add_command(
      app, request, "new", "make a project from photographs and, if known, their cameras",
      "bosk new oak photos --cameras photos/transforms.json --mattes mattes");
  auto arguments = std::make_shared<NewArguments>();
  command.add_option("PROJECT", arguments->folder, "folder of the project, made when missing")
      ->required();
  command.add_option(
      "PHOTO", arguments->photos,
      "photos, or folders of photos (those that the camera file lists unless given)");
  command
      .add_option("--cameras", arguments->cameras,
                  "known cameras, if there are any (`bosk calibrate` finds them): a COLMAP model's "
                  "folder, a "
                  "transforms.json, a .cameramodel or a "
                  "folder of them; they match photos by name without ending")
      ->type_name("FILE|DIR");
  command
      .add_option("--mattes", arguments->mattes,
                  "known mattes, matched by name: RGBA with straight alpha, or one channel")
      ->type_name("DIR");
  command
      .add_option("--scribbles", arguments->scribbles,
                  "strokes to make mattes from, matched by name: white tree, black background, "
                  "grey unknown; one photo with strokes is enough")
      ->type_name("DIR");
  command.add_flag("--replace", arguments->replace,
                   "describe an existing project anew; finished work and strokes drawn in the "
                   "workstation are kept where they still fit");
  add_stage_options(
      command,
      {"calibrate", "photo", "matte", "opacity", "radiance", "texture", "compress", "pack"},
      arguments->choices);
  command.callback([arguments, &request] {
    request.run = [arguments](Console& console) { return make_new_project(*arguments, console); };
  });
}

}  // namespace bosk
