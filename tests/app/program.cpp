#include "tests/app/program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace bosk {
namespace {

namespace fs = std::filesystem;

std::string unique_name() {
  static std::atomic<int> count{0};
  return ".output-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
}

int exit_status(int raw) { return WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw); }

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const fs::path& folder) {
  const fs::path temporary = fs::temp_directory_path() / unique_name();
  out_ = temporary.string() + ".out";
  err_ = temporary.string() + ".err";
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  std::vector<char*> argv = {const_cast<char*>("bosk")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const int failure = ::posix_spawn(&pid_, BOSK_PROGRAM, &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::runtime_error("bosk cannot be started");
}

Program::~Program() {
  if (!ended_) {
    send(SIGKILL);
    wait();
  }
  std::error_code none;
  fs::remove(out_, none);
  fs::remove(err_, none);
}

void Program::send(int signal) const { ::kill(pid_, signal); }

bool Program::is_running() {
  if (!ended_) ended_ = ::waitpid(pid_, &raw_status_, WNOHANG) == pid_;
  return !ended_;
}

ProgramEnd Program::wait() {
  if (!ended_) {
    ::waitpid(pid_, &raw_status_, 0);
    ended_ = true;
  }
  return {exit_status(raw_status_), content_of(out_), content_of(err_)};
}

ProgramEnd run_bosk(const std::vector<std::string>& arguments, const fs::path& folder) {
  return Program(arguments, folder).wait();
}

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void make_tiny_capture(const fs::path& folder) {
  std::vector<std::string> arguments = {"phantom", folder.string(), "--quiet"};
  for (const std::string option :
       {"--photos=6", "--held_out=2", "--width_px=72", "--height_px=96", "--height_m=2.5",
        "--detail=0.02", "--density_side=16", "--markers=0"}) {
    arguments.push_back(option);
  }
  const ProgramEnd end = run_bosk(arguments, folder.parent_path());
  if (end.status != 0) throw std::runtime_error("no capture for the test: " + end.err);
}

std::optional<ProgramEnd> run_on_mount(const std::string& mount, const std::string& command,
                                       const fs::path& folder) {
  const std::string space = "cd " + folder.string() + " && unshare --map-root-user --mount sh -c ";
  const std::string mounted = "mount -t tmpfs -o " + mount;
  if (std::system((space + "'" + mounted + "' 2>/dev/null").c_str()) != 0) return std::nullopt;
  const std::string script = mounted + " && exec " BOSK_PROGRAM " " + command;
  const int raw = std::system((space + "'" + script + "' >out 2>err").c_str());
  return ProgramEnd{exit_status(raw), content_of(folder / "out"), content_of(folder / "err")};
}

std::vector<std::string> quick_options() {
  return {"--opacity.finest_level=5", "--compress.colour_codewords=64",
          "--compress.alpha_codewords=64"};
}

}  // namespace bosk
