#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bosk {

struct ProgramEnd {
  int status = -1;  // exit status; 128 + signal when a signal ended it
  std::string out, err;
};

// The program under test, started as a user would.
class Program {
 public:
  // Working folder `folder`; output goes to files there so that no pipe can fill up.
  Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  void send(int signal) const;
  bool is_running();
  ProgramEnd wait();

 private:
  std::filesystem::path out_, err_;
  pid_t pid_ = -1;
  bool ended_ = false;
  int raw_status_ = 0;
};

// Runs `bosk` with the arguments in the folder and waits for its end.
ProgramEnd run_bosk(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

// Runs `bosk COMMAND` where a tmpfs is mounted, in a mount namespace of the program's own. `mount`
// is "OPTIONS none PLACE", relative to the folder. None where the system grants no namespaces.
std::optional<ProgramEnd> run_on_mount(const std::string& mount, const std::string& command,
                                       const std::filesystem::path& folder);

// The file's bytes as text; empty when it is missing.
std::string content_of(const std::filesystem::path& path);

// A capture of a tiny phantom: SCRATCH/NAME with photos, mattes, scribbles, transforms.json and
// held-out views, as `bosk phantom` lays it out.
void make_tiny_capture(const std::filesystem::path& folder);

// Options that make the whole pipeline take about a second on the tiny capture.
std::vector<std::string> quick_options();

}  // namespace bosk
