#include "app/console.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace bosk {
namespace {

constexpr auto kLineInterval = std::chrono::seconds(1);       // at least, between two lines
constexpr auto kSameLineInterval = std::chrono::seconds(10);  // that say the same
constexpr int kBarCells = 24;

std::size_t terminal_columns() {
  struct winsize size {};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

std::string what(const ProgressReport& report) {
  return report.part.empty() ? report.phrase : report.part + ": " + report.phrase;
}

std::string per_cent(double fraction) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%3.0f %%", std::floor(100.0 * fraction));
  return text.data();
}

}  // namespace

Console::Console(const CommonOptions& options)
    : options_(options),
      terminal_(::isatty(STDERR_FILENO) != 0),
      progress_([this](const ProgressReport& report) { show(report); },
                [this](const std::string& sentence) { warn(sentence); }) {}

Console::~Console() { clear_bar(); }

void Console::say(const std::string& line) {
  clear_bar();
  std::fprintf(stderr, "%s\n", line.c_str());
}

void Console::result(const std::string& text, const nlohmann::json& value) {
  clear_bar();
  const std::string out = options_.json ? value.dump(1) : text;
  if (out.empty()) return;
  std::cout << out << (out.back() == '\n' ? "" : "\n") << std::flush;
  if (!std::cout) throw Error("standard output: cannot be written", ErrorKind::resource);
}

void Console::show(ProgressReport report) {
  if (options_.quiet) return;
  report.fraction = furthest_ = std::max(furthest_, report.fraction);
  if (terminal_) {
    show_bar(report);
  } else {
    show_line(report);
  }
}

void Console::show_bar(const ProgressReport& report) {
  const int full = std::clamp(int(kBarCells * report.fraction), 0, kBarCells);
  std::string line =
      "[" + std::string(std::size_t(full), '#') + std::string(std::size_t(kBarCells - full), '.') +
      "] " + per_cent(report.fraction) + "  " + times(report.fraction) + "  " + what(report);
  line.resize(std::min(line.size(), terminal_columns() - 1));
  std::fprintf(stderr, "\r%s\x1b[K", line.c_str());
  std::fflush(stderr);
  bar_shown_ = true;
}

void Console::show_line(const ProgressReport& report) {
  const auto now = Clock::now();
  const std::string line = what(report);
  const auto interval = line == last_what_ ? kSameLineInterval : kLineInterval;
  if (report.part == last_part_ && now - last_line_ < interval) return;
  last_line_ = now;
  last_what_ = line;
  last_part_ = report.part;
  std::fprintf(stderr, "%s  %s  %s\n", per_cent(report.fraction).c_str(), line.c_str(),
               times(report.fraction).c_str());
}

void Console::clear_bar() {
  if (bar_shown_) std::fprintf(stderr, "\r\x1b[K");
  bar_shown_ = false;
}

std::string Console::times(double fraction) {
  const double spent = std::chrono::duration<double>(Clock::now() - start_).count();
  const auto left = remaining_.update(fraction, spent);
  if (!left) return minutes_text(spent);
  return minutes_text(spent) + ", about " + minutes_text(*left) + " left";
}

}  // namespace bosk
