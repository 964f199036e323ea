#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/child_process.h"

namespace bosk {

// Between child_process.cpp (parent) and child_serve.cpp (child) only.
//   command line            bosk MODE PARENT_PID
//   to the child's input    [ChildRequest][size bytes: the arguments, each ended by a 0 byte]
//   from its pipe           [ChildMessage][size bytes: the result, or the reason as text]
//                           [ChildMessage `ended`], alone when the task died without a word
// all in host byte order.
inline constexpr int kChildInput = 0, kChildPipe = 3;  // numbers of the pipes' ends in the child
inline constexpr const char* kChildVariable = "BOSK_CHILD";
inline constexpr std::uint32_t kChildMagic = 0x4b534f42;
inline constexpr std::uint64_t kMaxReasonBytes = 4096;
inline constexpr std::uint64_t kMaxArgumentBytes = 1 << 20;

struct ChildRequest {
  std::uint64_t memory_bytes = 0;
  double cpu_s = 0.0;
  std::uint64_t size = 0;
};

enum class ChildWord : std::uint32_t { result, refused, ended };

struct ChildMessage {
  std::uint32_t magic = kChildMagic;
  ChildWord word = ChildWord::ended;
  std::uint64_t size = 0;  // `ended`: the status that waitpid(2) gives
};

// Writes all of it; false when the other end is gone. SIGPIPE must be ignored or cannot come.
bool write_to_pipe(int pipe, std::span<const std::byte> bytes);

std::vector<std::byte> packed(const std::vector<std::string>& arguments);
std::vector<std::string> unpacked(std::span<const std::byte> bytes);

}  // namespace bosk
