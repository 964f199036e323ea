#include "core/base/progress.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace bosk {
namespace {

constexpr long long kReportIntervalNs = 50'000'000;

long long now_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace

Progress::Progress(Listener listener, WarningListener on_warning)
    : listener_(std::move(listener)), on_warning_(std::move(on_warning)) {}

void Progress::begin(const std::string& phrase, std::size_t total, double from, double to) {
  check();
  {
    const std::lock_guard lock(mutex_);
    phrase_ = phrase;
    total_ = std::max<std::size_t>(total, 1);
    from_ = from;
    to_ = to;
    done_.store(0, std::memory_order_relaxed);
  }
  report(true);
}

void Progress::advance(std::size_t units) {
  check();
  done_.fetch_add(units, std::memory_order_relaxed);
  report(false);
}

void Progress::warn(const std::string& sentence) {
  const std::lock_guard lock(mutex_);
  if (on_warning_) on_warning_(sentence);
}

void Progress::scope(double from, double to, const std::string& part) {
  const std::lock_guard lock(mutex_);
  part_ = part;
  scope_ = {from, to};
}

Progress::Scope Progress::enter(double from, double to) {
  const std::lock_guard lock(mutex_);
  const Scope outer = scope_;
  const double width = outer.to - outer.from;
  scope_ = {outer.from + width * from, outer.from + width * to};
  return outer;
}

void Progress::leave(const Scope& outer) {
  const std::lock_guard lock(mutex_);
  scope_ = outer;
}

void Progress::report(bool always) {
  if (!listener_) return;
  const long long now = now_ns();
  long long last = last_report_ns_.load(std::memory_order_relaxed);
  if (!always) {
    if (now - last < kReportIntervalNs) return;
    if (!last_report_ns_.compare_exchange_strong(last, now, std::memory_order_relaxed)) return;
  } else {
    last_report_ns_.store(now, std::memory_order_relaxed);
  }
  const std::lock_guard lock(mutex_);
  const double done = static_cast<double>(done_.load(std::memory_order_relaxed));
  const double step = std::min(1.0, done / static_cast<double>(total_));
  const double stage = from_ + (to_ - from_) * step;
  listener_({scope_.from + (scope_.to - scope_.from) * stage, phrase_, part_});
}

}  // namespace bosk
