#include "core/project/lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>

#include "core/base/error.h"
#include "core/base/system_error.h"

namespace bosk {
namespace {

// The number that the holder wrote, or "unknown".
std::string holder_of(int file) {
  std::array<char, 32> text{};
  const ssize_t size = ::pread(file, text.data(), text.size() - 1, 0);
  return size > 0 ? std::string(text.data()) : "unknown";
}

void write_holder(int file) {
  const std::string pid = std::to_string(::getpid());
  // Only for the message to others; a failure changes nothing
  if (::ftruncate(file, 0) == 0) (void)!::pwrite(file, pid.data(), pid.size(), 0);
}

}  // namespace

ProjectLock::ProjectLock(const std::filesystem::path& project_folder) {
  const std::filesystem::path path = project_folder / ".lock";
  file_ = FileDescriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (!file_) throw system_error(path, "written", errno);
  if (::flock(file_.get(), LOCK_EX | LOCK_NB) == 0) {
    write_holder(file_.get());
  } else if (errno == EWOULDBLOCK) {
    throw Error(printable(project_folder.string()) + ": process " + holder_of(file_.get()) +
                    " is working on this project; wait for it or stop it",
                ErrorKind::temporary);
  }
}

}  // namespace bosk
