#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>

#include "core/base/child_process.h"

namespace bosk {

// Between child_process.cpp (parent) and child_serve.cpp (child) only.
//   command line:  bosk MODE SETTINGS ARGUMENT...
//   through the pipe, host byte order:  [ChildMessage][size bytes: the result, or the reason as
//   text]
inline constexpr int kChildPipe = 3;  // number of the pipe's end in the child
inline constexpr const char* kChildVariable = "BOSK_CHILD";
inline constexpr std::uint32_t kChildMagic = 0x4b534f42;
inline constexpr std::uint64_t kMaxReasonBytes = 4096;

struct ChildMessage {
  std::uint32_t magic = kChildMagic;
  std::uint32_t is_result = 0;
  std::uint64_t size = 0;
};

// "MEMORY_BYTES CPU_SECONDS PARENT_PID"
std::string child_settings_text(const ChildLimits& limits, pid_t parent);

}  // namespace bosk
