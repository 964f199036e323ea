#pragma once

#include <time.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace bosk {

using Clock = std::chrono::steady_clock;

inline double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Of the calling thread alone.
inline double thread_cpu_ms() {
  timespec spent{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return 1e3 * double(spent.tv_sec) + 1e-6 * double(spent.tv_nsec);
}

inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

// What frames took, in milliseconds.
struct FrameTimes {
  std::vector<double> wall, cpu;

  void add(const std::function<void()>& work) {
    const auto start = Clock::now();
    const double before = thread_cpu_ms();
    work();
    cpu.push_back(thread_cpu_ms() - before);
    wall.push_back(ms_since(start));
  }
};

}  // namespace bosk
