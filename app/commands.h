#pragma once

#include <CLI/App.hpp>
#include <functional>

#include "app/console.h"
#include "app/exit_status.h"

namespace bosk {

// What the command line asks for, to be run once it is parsed.
struct Request {
  CommonOptions common;
  std::function<ExitStatus(Console&)> run;
};

// Each adds one subcommand, whose parsing fills `request`.
void add_new_command(CLI::App& app, Request& request);
void add_calibrate_command(CLI::App& app, Request& request);
void add_matte_command(CLI::App& app, Request& request);
void add_stage_commands(CLI::App& app, Request& request);  // opacity ... compress
void add_run_command(CLI::App& app, Request& request);
void add_render_command(CLI::App& app, Request& request);
void add_view_command(CLI::App& app, Request& request);
void add_open_command(CLI::App& app, Request& request);
void add_info_command(CLI::App& app, Request& request);
void add_evaluate_command(CLI::App& app, Request& request);
void add_phantom_command(CLI::App& app, Request& request);
void add_export_command(CLI::App& app, Request& request);

// What happens where no subcommand is named: the workstation's start page.
void open_by_default(Request& request);

// Adds a subcommand with the options that all have. `example` is one full command line.
CLI::App& add_command(CLI::App& app, Request& request, const std::string& name,
                      const std::string& description, const std::string& example);

}  // namespace bosk
