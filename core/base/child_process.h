#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/file_descriptor.h"
#include "core/base/progress.h"

namespace bosk {

// What one task of a child may use. Limits bind the child alone: the decoders of strangers' files
// crash, hang or eat all memory there instead of here.
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

// This very program, started again (/proc/self/exe) with `mode` as its first argument, which does
// one task after another, each in a fork of its own: no task sees another's remains, and the
// program's hundreds of libraries are loaded once. Safe beside any threads, since nothing of ours
// runs between fork and exec and the started program has one thread. Its main() must hand over to
// serve_as_child when it sees `mode` (for photos: run_child_mode in core/photo/child_mode.h). Not
// for two threads at once; give each its own.
class ChildServer {
 public:
  explicit ChildServer(std::string mode) : mode_(std::move(mode)) {}
  ChildServer(const ChildServer&) = delete;
  ChildServer& operator=(const ChildServer&) = delete;
  ~ChildServer() { stop(); }

  // Starts the program where none is running, and runs one task. Throws Cancelled within about 20
  // ms of the request, with the child gone; Error (resource) when no child can be started.
  ChildOutcome run(const std::vector<std::string>& arguments, const ChildLimits& limits,
                   const Progress& progress);

 private:
  void start();
  void stop();
  ChildOutcome talk(const std::vector<std::string>& arguments, const ChildLimits& limits,
                    const Progress& progress);

  std::string mode_;
  pid_t pid_ = -1;
  FileDescriptor requests_, results_;
};

// The child's side: takes the command line that ChildServer made, and for each task applies the
// limits and sends what `work` returns or, for an Error, its sentence. Returns the exit status for
// main().
using ChildWork = std::vector<std::byte> (*)(const std::vector<std::string>& arguments);
int serve_as_child(int argc, char** argv, ChildWork work);

// For work that learns how big its task is: lowers or raises the CPU time of the task, up to
// ChildLimits::cpu_s.
void set_child_cpu_limit(double cpu_s);

}  // namespace bosk
