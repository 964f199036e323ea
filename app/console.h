#pragma once

#include <chrono>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/base/progress.h"
#include "core/base/remaining_time.h"

namespace bosk {

// What every subcommand takes.
struct CommonOptions {
  bool json = false;   // results on standard output as JSON
  bool quiet = false;  // no progress
  int threads = 0;     // 0: as many as the machine, the job scheduler or the container allows
};

// Where a subcommand talks to people and programs: results on standard output, all else on standard
// error, progress as a bar on a terminal and as plain lines elsewhere.
class Console {
 public:
  explicit Console(const CommonOptions& options);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  Progress& progress() { return progress_; }
  bool json() const { return options_.json; }
  // A line for people, on standard error.
  void say(const std::string& line);
  void warn(const std::string& sentence) { say("warning: " + sentence); }
  // The result: `text` for people or `value` for programs, as asked for, on standard output. Throws
  // Error when it can't be written.
  void result(const std::string& text, const nlohmann::json& value);

 private:
  // Never goes back, also where a stage begins a second step.
  void show(ProgressReport report);
  void show_bar(const ProgressReport& report);
  void show_line(const ProgressReport& report);
  void clear_bar();
  // "0:35, about 1:10 left"; the latter only once it is steady.
  std::string times(double fraction);

  using Clock = std::chrono::steady_clock;

  CommonOptions options_;
  bool terminal_ = false;
  bool bar_shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_line_{};
  std::string last_what_, last_part_;
  double furthest_ = 0.0;
  RemainingTime remaining_;
  Progress progress_;
};

}  // namespace bosk
