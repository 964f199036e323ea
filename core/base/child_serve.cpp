#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <span>

#include "core/base/child_protocol.h"
#include "core/base/error.h"

namespace bosk {
namespace {

// The address sanitizer reserves terabytes of addresses, so no limit on them can hold under it.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kLimitAddresses = false;
#else
constexpr bool kLimitAddresses = true;
#endif

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  const rlimit wanted{soft, hard};
  ::setrlimit(resource, &wanted);  // fails only where a limit from outside is lower already
}

rlim_t whole_seconds(double cpu_s) { return rlim_t(std::max(1.0, std::ceil(cpu_s))); }

// Ends with its parent; false when that is gone already.
bool follow(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  return ::getppid() == parent;
}

// No files (a pipe is none), no core dumps, bounded memory and time.
void enter(const ChildRequest& request) {
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_FSIZE, 0, 0);
  limit(RLIMIT_CPU, whole_seconds(request.cpu_s), whole_seconds(request.cpu_s) + 1);
  if (kLimitAddresses) limit(RLIMIT_AS, request.memory_bytes, request.memory_bytes);
}

bool read_exactly(std::span<std::byte> target) {
  while (!target.empty()) {
    const ssize_t got = ::read(kChildInput, target.data(), target.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    target = target.subspan(std::size_t(got));
  }
  return true;
}

bool send(ChildWord word, std::span<const std::byte> body) {
  const ChildMessage message{kChildMagic, word, body.size()};
  return write_to_pipe(kChildPipe, std::as_bytes(std::span(&message, 1))) &&
         write_to_pipe(kChildPipe, body);
}

bool refuse(const std::string& reason) {
  const auto bytes = std::as_bytes(std::span(reason.data(), reason.size()));
  return send(ChildWord::refused,
              bytes.first(std::min<std::size_t>(bytes.size(), kMaxReasonBytes)));
}

bool do_task(const std::vector<std::string>& arguments, ChildWork work) {
  try {
    return send(ChildWord::result, work(arguments));
  } catch (const std::bad_alloc&) {
    return refuse("more memory is needed than it may use");
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}

// Runs the task in a fork and returns how that ended.
int status_of_fork(const ChildRequest& request, const std::vector<std::string>& arguments,
                   ChildWork work) {
  const pid_t server = ::getpid();
  const pid_t pid = ::fork();
  if (pid == 0) {
    enter(request);
    // No destructors: after a damaged file they may crash, and the result has been sent
    std::_Exit(follow(server) && do_task(arguments, work) ? 0 : 1);
  }
  int status = 1 << 8;  // "exited with 1", should fork have failed
  while (pid > 0 && ::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

bool write_to_pipe(int pipe, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::send(pipe, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(std::size_t(written));
  }
  return true;
}

std::vector<std::byte> packed(const std::vector<std::string>& arguments) {
  std::vector<std::byte> bytes;
  for (const std::string& argument : arguments) {
    const auto* first = reinterpret_cast<const std::byte*>(argument.c_str());
    bytes.insert(bytes.end(), first, first + std::strlen(argument.c_str()) + 1);
  }
  return bytes;
}

std::vector<std::string> unpacked(std::span<const std::byte> bytes) {
  std::vector<std::string> arguments;
  while (!bytes.empty()) {
    const auto end = std::find(bytes.begin(), bytes.end(), std::byte(0));
    const auto size = std::size_t(end - bytes.begin());
    arguments.emplace_back(reinterpret_cast<const char*>(bytes.data()), size);
    bytes = bytes.subspan(std::min(size + 1, bytes.size()));
  }
  return arguments;
}

int serve_as_child(int argc, char** argv, ChildWork work) {
  if (argc != 3 || !follow(pid_t(std::atol(argv[2])))) return 2;
  ChildRequest request;
  while (read_exactly(std::as_writable_bytes(std::span(&request, 1)))) {
    if (request.size > kMaxArgumentBytes) return 2;
    std::vector<std::byte> text(std::size_t(request.size));
    if (!read_exactly(text)) return 2;
    const int status = status_of_fork(request, unpacked(text), work);
    const ChildMessage ended{kChildMagic, ChildWord::ended, std::uint64_t(status)};
    if (!write_to_pipe(kChildPipe, std::as_bytes(std::span(&ended, 1)))) return 1;
  }
  return 0;
}

void set_child_cpu_limit(double cpu_s) {
  rlimit now{};
  if (::getrlimit(RLIMIT_CPU, &now) != 0) return;
  limit(RLIMIT_CPU, std::min(whole_seconds(cpu_s), now.rlim_max - 1), now.rlim_max);
}

}  // namespace bosk
