#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <clocale>
#include <exception>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_status.h"
#include "app/signals.h"
#include "app/threads.h"
#include "core/base/error.h"
#include "core/photo/child_mode.h"

namespace bosk {
namespace {

constexpr const char* kAbout =
    "Bosk makes a small package that draws like a real tree out of about 24 photographs of it.\n\n"
    "Without a command it opens the workstation, a window that leads from photographs to "
    "package.\n\n"
    "  bosk new oak photos/*.jpg --cameras transforms.json --mattes mattes\n"
    "  bosk run oak -o oak.bosk\n"
    "  bosk render oak.bosk --cameras transforms.json -o pictures";

constexpr const char* kExitStatuses =
    "Exit status: 0 done; 1 a fault of Bosk's own; 2 bad usage; 3 bad input; 4 done, but below "
    "the\n"
    "quality asked for; 5 out of memory or disk; 75 temporary, try again; 130 or 143 cancelled by "
    "a\n"
    "signal, with the work so far kept.";

void add_commands(CLI::App& app, Request& request) {
  app.set_help_flag("-h,--help", "this help");
  app.set_version_flag("--version", "bosk " BOSK_VERSION);
  app.footer(kExitStatuses);
  app.require_subcommand(0, 1);
  open_by_default(request);
  add_new_command(app, request);
  add_calibrate_command(app, request);
  add_matte_command(app, request);
  add_stage_commands(app, request);
  add_run_command(app, request);
  add_render_command(app, request);
  add_view_command(app, request);
  add_open_command(app, request);
  add_info_command(app, request);
  add_evaluate_command(app, request);
  add_phantom_command(app, request);
  add_export_command(app, request);
}

ExitStatus failed(Console& console, const std::string& message, ExitStatus status) {
  console.say("bosk: " + message);
  if (console.json()) {
    console.result("", {{"error", message}, {"exit_status", int(status)}});
  }
  return status;
}

// Runs the subcommand and turns what it throws into a sentence and an exit status. Cancelled
// passes.
ExitStatus run_request(const Request& request, Console& console) {
  try {
    return request.run(console);
  } catch (const CLI::Error& error) {
    return failed(console, error.what(), ExitStatus::usage);
  } catch (const Error& error) {
    return failed(console, error.what(), exit_status(error.kind()));
  } catch (const std::bad_alloc&) {
    return failed(console,
                  "out of memory; use smaller photos (--photo.working_megapixels) or more memory",
                  ExitStatus::resource);
  } catch (const std::filesystem::filesystem_error& error) {
    const bool full = error.code() == std::errc::no_space_on_device;
    return failed(console, error.what(), full ? ExitStatus::resource : ExitStatus::bad_input);
  } catch (const std::exception& error) {
    return failed(console, std::string("a fault of Bosk's own, please report it: ") + error.what(),
                  ExitStatus::fault);
  }
}

int run(const Request& request) {
  const int threads = request.common.threads > 0 ? request.common.threads : default_threads();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  std::size_t(threads));
  Console console(request.common);
  const CancelOnSignals cancel_on_signals(console.progress());
  try {
    return int(run_request(request, console));
  } catch (const Cancelled&) {
    console.say("bosk: cancelled; what was finished is kept");
    return 128 + received_signal();
  }
}

int parse_and_run(int argc, char** argv) {
  CLI::App app(kAbout, "bosk");
  Request request;
  add_commands(app, request);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : int(ExitStatus::usage);
  }
  return run(request);
}

}  // namespace
}  // namespace bosk

int main(int argc, char** argv) {
  std::setlocale(LC_ALL, "C");
  if (const auto status = bosk::run_child_mode(argc, argv)) return *status;
  return bosk::parse_and_run(argc, argv);
}
