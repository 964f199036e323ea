#include "app/threads.h"

#include <tbb/info.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

namespace bosk {
namespace {

// 0: not set or no number.
int slurm_threads() {
  const char* text = std::getenv("SLURM_CPUS_PER_TASK");
  return text == nullptr ? 0 : std::atoi(text);
}

// Control group version 2: "max 100000" or "200000 100000" (microseconds per period); 0: no limit.
int quota_threads() {
  std::ifstream file("/sys/fs/cgroup/cpu.max");
  std::string quota;
  long long period = 0;
  if (!(file >> quota >> period) || quota == "max" || period <= 0) return 0;
  return int((std::atoll(quota.c_str()) + period - 1) / period);
}

}  // namespace

int default_threads() {
  const int machine = tbb::info::default_concurrency();
  if (const int threads = slurm_threads(); threads > 0) return std::min(threads, machine);
  if (const int threads = quota_threads(); threads > 0) return std::min(threads, machine);
  return machine;
}

}  // namespace bosk
