#include "core/phantom/phantom.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/stage_options.h"
#include "core/base/system_error.h"

namespace bosk {
namespace {

struct PhantomArguments {
  std::string folder;
  OptionTexts options;
};

ExitStatus make_sample(const PhantomArguments& arguments, Console& console) {
  PhantomOptions options;
  set_options(arguments.options, describe(options));
  console.progress().scope(0.0, 0.95);
  const Phantom phantom = make_phantom(options, console.progress());
  console.progress().scope(0.95, 1.0);
  write_phantom(arguments.folder, phantom, console.progress());
  console.result(printable(arguments.folder) + ": " + std::to_string(phantom.photos.size()) +
                     " photos of a tree with " + std::to_string(phantom.leaves) + " leaves, and " +
                     std::to_string(phantom.held_out.size()) + " held-out views",
                 {{"folder", arguments.folder},
                  {"photos", phantom.photos.size()},
                  {"held_out", phantom.held_out.size()},
                  {"leaves", phantom.leaves}});
  return ExitStatus::done;
}

}  // namespace

void add_phantom_command(CLI::App& app, Request& request) {
  CLI::App& command =
      add_command(app, request, "phantom",
                  "make a sample capture, its tree and its photographs, with the truth",
                  "bosk phantom sample --preset sparse --seed 7");
  auto arguments = std::make_shared<PhantomArguments>();
  command.add_option("DIR", arguments->folder, "folder to write, made when missing")->required();
  PhantomOptions defaults;
  add_options(command, describe(defaults), "", "What to make", arguments->options);
  command.callback([arguments, &request] {
    request.run = [arguments](Console& console) { return make_sample(*arguments, console); };
  });
}

}  // namespace bosk
