#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/progress.h"

namespace bosk {

// What a child may use. Limits bind the child alone: the decoders of strangers' files crash, hang
// or eat all memory there instead of here.
struct ChildLimits {
  std::uint64_t memory_bytes = std::uint64_t(4) << 30;  // address space, libraries included
  double cpu_s = 30.0;
  double wall_s = 60.0;
  std::uint64_t result_bytes = std::uint64_t(2) << 30;
};

enum class ChildEnd {
  result,     // it gave a result
  refused,    // it ended in order and said why it gives none
  stopped,    // it crashed, was killed or used up its CPU time
  timed_out,  // it was killed because `wall_s` had passed
};

struct ChildOutcome {
  ChildEnd end = ChildEnd::stopped;
  std::string
      reason;  // empty for a result; else one clause, such as "the program crashed (signal 11)"
  std::vector<std::byte> result;
};

// Runs this very program again (/proc/self/exe) with `mode` as first argument and waits for it.
// Safe beside any threads, since nothing runs between fork and exec. The program's main() must hand
// over to serve_as_child when it sees `mode` (for photos: run_child_mode in
// core/photo/child_mode.h). Throws Cancelled within about 20 ms of the request, with the child
// gone; Error (resource) when no child can be started.
ChildOutcome run_self_in_child(const std::string& mode, const std::vector<std::string>& arguments,
                               const ChildLimits& limits, const Progress& progress);

// The child's side: takes the command line that run_self_in_child made, applies the limits, and
// sends what `work` returns or, for an Error, its sentence. Returns the exit status for main().
using ChildWork = std::vector<std::byte> (*)(const std::vector<std::string>& arguments);
int serve_as_child(int argc, char** argv, ChildWork work);

// For work that learns how big its task is: lowers or raises the CPU time the child may use, up to
// ChildLimits::cpu_s. Counts from the child's start.
void set_child_cpu_limit(double cpu_s);

}  // namespace bosk
