#include "core/base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <span>
#include <utility>

#include "core/base/child_protocol.h"
#include "core/base/system_error.h"

namespace bosk {
namespace {

using Clock = std::chrono::steady_clock;

Error cannot_start(int code) {
  return Error("a child process cannot be started: " + std::string(std::strerror(code)) +
                   "; close other programs or raise the limit on processes (ulimit -u)",
               ErrorKind::resource);
}

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
// reaches them. A process group of its own, so that Ctrl-C asks us alone and all forks end
// together.
void set_up(SpawnSettings& settings, int requests, int results) {
  // Results first: it may well be number 0 when this program was started with its input closed
  posix_spawn_file_actions_adddup2(&settings.files, results, kChildPipe);
  posix_spawn_file_actions_adddup2(&settings.files, requests, kChildInput);
  posix_spawn_file_actions_addopen(&settings.files, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&settings.files, 2, "/dev/null", O_WRONLY, 0);
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
  all.reserve(texts.size() + 1);
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

std::vector<std::string> child_environment() {
  // One heap arena and no helper threads: each would reserve address space out of the limit
  std::vector<std::string> all{std::string(kChildVariable) + "=1", "MALLOC_ARENA_MAX=1",
                               "OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1"};
  for (char** variable = environ; *variable != nullptr; ++variable) all.emplace_back(*variable);
  return all;
}

// Both ends above the numbers that the child's own ends take, and closed in every other program.
std::array<FileDescriptor, 2> channel() {
  std::array<int, 2> ends{};
  // A socket, unlike a pipe, can be written to without a SIGPIPE when the child has died
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw cannot_start(errno);
  }
  std::array<FileDescriptor, 2> both;
  for (std::size_t i = 0; i < 2; ++i) {
    const FileDescriptor low(ends[i]);
    both[i] = FileDescriptor(::fcntl(low.get(), F_DUPFD_CLOEXEC, kChildPipe + 1));
    if (!both[i]) throw cannot_start(errno);
  }
  return both;
}

enum class ReadEnd { complete, closed, timed_out };

// Fills `target`; looks up every 20 ms whether the job was cancelled or time is over.
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

// A header that no child of ours would send counts as a crash.
bool plausible(const ChildMessage& message, const ChildLimits& limits) {
  if (message.magic != kChildMagic) return false;
  if (message.word == ChildWord::result) return message.size <= limits.result_bytes;
  return message.word == ChildWord::ended || message.size <= kMaxReasonBytes;
}

ChildOutcome stopped(int status) {
  if (!WIFSIGNALED(status)) return {ChildEnd::stopped, "the program ended without a result", {}};
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU) return {ChildEnd::stopped, "the program used up its CPU time", {}};
  return {ChildEnd::stopped, "the program crashed (signal " + std::to_string(signal) + ")", {}};
}

ChildOutcome timed_out(double wall_s) {
  return {ChildEnd::timed_out,
          "the program took longer than " + std::to_string(int(wall_s)) + " s",
          {}};
}

ChildOutcome outcome_of(ChildWord word, std::vector<std::byte> body) {
  if (word == ChildWord::result) return {ChildEnd::result, "", std::move(body)};
  const std::string reason(reinterpret_cast<const char*>(body.data()), body.size());
  return {ChildEnd::refused, printable(reason), {}};
}

}  // namespace

void ChildServer::start() {
  // A program whose main() doesn't know `mode_` would start itself over and over
  if (std::getenv(kChildVariable) != nullptr) throw Error("a child process may not start another");
  auto requests = channel(), results = channel();
  SpawnSettings settings;
  set_up(settings, requests[1].get(), results[1].get());
  std::vector<std::string> command{"bosk", mode_, std::to_string(::getpid())};
  std::vector<std::string> environment = child_environment();
  const int code = posix_spawn(&pid_, "/proc/self/exe", &settings.files, &settings.attributes,
                               pointers(command).data(), pointers(environment).data());
  if (code != 0) {
    pid_ = -1;
    throw cannot_start(code);
  }
  requests_ = std::move(requests[0]);
  results_ = std::move(results[0]);
}

void ChildServer::stop() {
  if (pid_ < 0) return;
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);  // should it not have become the head of its group yet
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  requests_ = FileDescriptor();
  results_ = FileDescriptor();
}

ChildOutcome ChildServer::talk(const std::vector<std::string>& arguments, const ChildLimits& limits,
                               const Progress& progress) {
  const auto wall = std::chrono::duration<double>(limits.wall_s);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(wall);
  const std::vector<std::byte> text = packed(arguments);
  const ChildRequest request{limits.memory_bytes, limits.cpu_s, text.size()};
  ChildOutcome gone{ChildEnd::stopped, "the program ended unexpectedly", {}};
  if (!write_to_pipe(requests_.get(), std::as_bytes(std::span(&request, 1))) ||
      !write_to_pipe(requests_.get(), text)) {
    return gone;
  }
  const auto read = [&](std::span<std::byte> target) {
    return read_exactly(results_.get(), target, deadline, progress);
  };

  ChildMessage message, last;
  ReadEnd end = read(std::as_writable_bytes(std::span(&message, 1)));
  if (end == ReadEnd::timed_out) return timed_out(limits.wall_s);
  if (end == ReadEnd::closed || !plausible(message, limits)) return gone;
  if (message.word == ChildWord::ended) return stopped(int(message.size));
  std::vector<std::byte> body(std::size_t(message.size));
  end = read(body);
  if (end == ReadEnd::complete) end = read(std::as_writable_bytes(std::span(&last, 1)));
  if (end == ReadEnd::timed_out) return timed_out(limits.wall_s);
  if (end == ReadEnd::closed || last.word != ChildWord::ended) return gone;
  return outcome_of(message.word, std::move(body));
}

ChildOutcome ChildServer::run(const std::vector<std::string>& arguments, const ChildLimits& limits,
                              const Progress& progress) {
  if (pid_ < 0) start();
  try {
    ChildOutcome outcome = talk(arguments, limits, progress);
    // After anything but an orderly end the next task gets a program of its own
    if (outcome.end == ChildEnd::stopped || outcome.end == ChildEnd::timed_out) stop();
    return outcome;
  } catch (...) {
    stop();
    throw;
  }
}

}  // namespace bosk
