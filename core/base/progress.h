#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>

namespace bosk {

// Thrown by Progress when the job was asked to stop. Deliberately no std::exception: a stage's own
// catch must not swallow it.
struct Cancelled {};

// What a stage tells while it runs. `fraction` is of the whole job, 0 to 1.
struct ProgressReport {
  double fraction = 0.0;
  std::string phrase;
  std::string part;  // of the job that runs, where it has named parts: a stage
};

// All that a stage sees of its job: fraction, phrase, warnings, cancellation. `begin`, `warn` and
// the listeners are called from one thread at a time; `advance` and `check` from any thread.
class Progress {
 public:
  using Listener = std::function<void(const ProgressReport&)>;
  using WarningListener = std::function<void(const std::string&)>;

  Progress() = default;
  Progress(Listener listener, WarningListener on_warning);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Starts a step of `total` units that takes the share [from, to] of the job. Throws Cancelled.
  void begin(const std::string& phrase, std::size_t total, double from = 0.0, double to = 1.0);
  // Counts units of the step as done. Throws Cancelled when asked to stop. Call it per row or cell,
  // not per pixel; listeners hear of it at most every 50 ms.
  void advance(std::size_t units = 1);
  // Throws Cancelled when asked to stop.
  void check() const {
    if (cancelled_.load(std::memory_order_relaxed)) throw Cancelled{};
  }
  // One sentence for the user about something that went less well than it could.
  void warn(const std::string& sentence);
  // Maps what follows (begin's from and to) into [from, to] of the job: for a stage run as a part.
  void scope(double from, double to, const std::string& part = {});

  // As scope, but within the present one; gives that back for `leave`. See ProgressPart.
  struct Scope {
    double from = 0.0, to = 1.0;
  };
  Scope enter(double from, double to);
  void leave(const Scope& outer);

  // Asks the job to stop; safe from any thread and from a signal handler.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

 private:
  void report(bool always);

  Listener listener_;
  WarningListener on_warning_;
  std::mutex mutex_;
  std::string phrase_, part_;
  Scope scope_;
  double from_ = 0.0, to_ = 1.0;
  std::size_t total_ = 1;
  std::atomic<std::size_t> done_{0};
  std::atomic<long long> last_report_ns_{0};
  std::atomic<bool> cancelled_{false};
};

// While it lives, what follows fills only [from, to] of what it would have filled: for a function
// that calls others which each report from 0 to 1. Parts may lie in parts.
class ProgressPart {
 public:
  ProgressPart(Progress& progress, double from, double to)
      : progress_(progress), outer_(progress.enter(from, to)) {}
  ~ProgressPart() { progress_.leave(outer_); }
  ProgressPart(const ProgressPart&) = delete;
  ProgressPart& operator=(const ProgressPart&) = delete;

 private:
  Progress& progress_;
  Progress::Scope outer_;
};

}  // namespace bosk
