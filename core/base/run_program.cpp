#include "core/base/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "core/base/system_error.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

// Ends and reaps the program unless its end was seen.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (ended_) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, &raw_, 0);
  }
  bool has_ended() {
    ended_ = ::waitpid(pid_, &raw_, WNOHANG) == pid_;
    return ended_;
  }
  int status() const { return WIFEXITED(raw_) ? WEXITSTATUS(raw_) : 128 + WTERMSIG(raw_); }

 private:
  pid_t pid_;
  int raw_ = 0;
  bool ended_ = false;
};

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (folder.empty()) continue;
    const fs::path candidate = fs::path(folder) / name;
    std::error_code none;
    if (fs::is_regular_file(candidate, none) && ::access(candidate.c_str(), X_OK) == 0) {
      return fs::absolute(candidate, none);
    }
  }
  return std::nullopt;
}

int run_program(const fs::path& program, const std::vector<std::string>& arguments,
                const fs::path& folder, const fs::path& log, const Progress& progress) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::string log_path = fs::absolute(log).string();
  for (const int stream : {1, 2}) {
    posix_spawn_file_actions_addopen(&actions, stream, log_path.c_str(),
                                     O_WRONLY | O_CREAT | O_APPEND, 0666);
  }
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  pid_t pid = -1;
  const int failure = ::posix_spawn(&pid, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw system_error(program, "started", failure);
  Child child(pid);
  while (!child.has_ended()) {
    progress.check();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return child.status();
}

}  // namespace bosk
