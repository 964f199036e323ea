#include "app/commands.h"

namespace bosk {

CLI::App& add_command(CLI::App& app, Request& request, const std::string& name,
                      const std::string& description, const std::string& example) {
  CLI::App& command = *app.add_subcommand(name, description);
  command.footer("Example:\n  " + example);
  command.add_flag("--json", request.common.json, "results as JSON on standard output");
  command.add_flag("--quiet", request.common.quiet, "no progress on standard error");
  command
      .add_option("--threads", request.common.threads,
                  "threads to use (1 to 1024; as many as the machine, the job scheduler or the "
                  "container allows unless given); results don't depend on it")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  return command;
}

}  // namespace bosk
