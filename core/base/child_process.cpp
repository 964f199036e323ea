#include "core/base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>

#include "core/base/child_protocol.h"
#include "core/base/file_descriptor.h"
#include "core/base/system_error.h"

namespace bosk {
namespace {

using Clock = std::chrono::steady_clock;

Error cannot_start(int code) {
  return Error("a child process cannot be started: " + std::string(std::strerror(code)) +
                   "; close other programs or raise the limit on processes (ulimit -u)",
               ErrorKind::resource);
}

// A started child; killed and reaped when it goes out of scope before `wait`.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (pid_ < 0) return;
    kill();
    wait();
  }
  void kill() const { ::kill(pid_, SIGKILL); }
  // Its exit status; kills it when it lives on for a second after it closed its pipe.
  int wait_briefly() {
    for (int attempt = 0; attempt < 100; ++attempt) {
      int status = 0;
      if (::waitpid(pid_, &status, WNOHANG) == pid_) {
        pid_ = -1;
        return status;
      }
      ::usleep(10'000);
    }
    kill();
    return wait();
  }

 private:
  int wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
  }

  pid_t pid_;
};

// Of a spawn's settings, freed at the end of scope.
struct SpawnSettings {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;

  SpawnSettings() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
};

// Decoders chat on standard output and error; only the pipe reaches us, and no other open file
// reaches them. A process group of its own, so that Ctrl-C asks us alone.
void set_up(SpawnSettings& settings, int pipe_write) {
  posix_spawn_file_actions_addopen(&settings.files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&settings.files, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&settings.files, 2, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&settings.files, pipe_write, kChildPipe);
  posix_spawn_file_actions_addclosefrom_np(&settings.files, kChildPipe + 1);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&settings.attributes, &none);
  posix_spawnattr_setsigdefault(&settings.attributes, &all);
  posix_spawnattr_setpgroup(&settings.attributes, 0);
  posix_spawnattr_setflags(&settings.attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

std::vector<std::string> child_environment() {
  // One heap arena and no helper threads: each would reserve address space out of the limit
  std::vector<std::string> all{std::string(kChildVariable) + "=1", "MALLOC_ARENA_MAX=1",
                               "OMP_NUM_THREADS=1"};
  for (char** variable = environ; *variable != nullptr; ++variable) all.emplace_back(*variable);
  return all;
}

pid_t spawn(std::vector<std::string> command, int pipe_write) {
  SpawnSettings settings;
  set_up(settings, pipe_write);
  std::vector<std::string> environment = child_environment();
  pid_t pid = -1;
  const int code = posix_spawn(&pid, "/proc/self/exe", &settings.files, &settings.attributes,
                               pointers(command).data(), pointers(environment).data());
  if (code != 0) throw cannot_start(code);
  return pid;
}

enum class ReadEnd { complete, closed, timed_out };

// Fills `target` from the pipe; looks up every 20 ms whether the job was cancelled or time is over.
ReadEnd read_exactly(int pipe, std::span<std::byte> target, Clock::time_point deadline,
                     const Progress& progress) {
  while (!target.empty()) {
    progress.check();
    if (Clock::now() >= deadline) return ReadEnd::timed_out;
    pollfd waiting{pipe, POLLIN, 0};
    if (::poll(&waiting, 1, 20) <= 0) continue;
    const ssize_t got = ::read(pipe, target.data(), target.size());
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (got <= 0) return ReadEnd::closed;
    target = target.subspan(std::size_t(got));
  }
  return ReadEnd::complete;
}

std::string how_it_ended(int status) {
  if (!WIFSIGNALED(status)) return "the program ended without a result";
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU) return "the program used up its CPU time";
  return "the program crashed (signal " + std::to_string(signal) + ")";
}

ChildOutcome timed_out(double wall_s) {
  return {ChildEnd::timed_out,
          "the program took longer than " + std::to_string(int(wall_s)) + " s",
          {}};
}

// A header that no child of ours would send counts as a crash.
bool plausible(const ChildMessage& message, const ChildLimits& limits) {
  if (message.magic != kChildMagic || message.is_result > 1) return false;
  return message.size <= (message.is_result == 1 ? limits.result_bytes : kMaxReasonBytes);
}

ChildOutcome outcome_of(const ChildMessage& message, std::vector<std::byte> body) {
  if (message.is_result == 1) return {ChildEnd::result, "", std::move(body)};
  const std::string reason(reinterpret_cast<const char*>(body.data()), body.size());
  return {ChildEnd::refused, printable(reason), {}};
}

}  // namespace

ChildOutcome run_self_in_child(const std::string& mode, const std::vector<std::string>& arguments,
                               const ChildLimits& limits, const Progress& progress) {
  // A program whose main() doesn't know `mode` would start itself over and over
  if (std::getenv(kChildVariable) != nullptr) throw Error("a child process may not start another");
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw cannot_start(errno);
  const FileDescriptor pipe_read(ends[0]);
  FileDescriptor pipe_write(ends[1]);

  std::vector<std::string> command{"bosk", mode, child_settings_text(limits, ::getpid())};
  command.insert(command.end(), arguments.begin(), arguments.end());
  Child child(spawn(std::move(command), pipe_write.get()));
  pipe_write.close();

  const auto wall = std::chrono::duration<double>(limits.wall_s);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(wall);
  ChildMessage message;
  ReadEnd end = read_exactly(pipe_read.get(), std::as_writable_bytes(std::span(&message, 1)),
                             deadline, progress);
  std::vector<std::byte> body;
  if (end == ReadEnd::complete && plausible(message, limits)) {
    body.resize(std::size_t(message.size));
    end = read_exactly(pipe_read.get(), body, deadline, progress);
    if (end == ReadEnd::complete) return outcome_of(message, std::move(body));
  }
  if (end == ReadEnd::timed_out) return timed_out(limits.wall_s);
  if (end == ReadEnd::complete) child.kill();
  return {ChildEnd::stopped, how_it_ended(child.wait_briefly()), {}};
}

}  // namespace bosk
