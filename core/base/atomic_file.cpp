#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <string>

#include "core/base/file_descriptor.h"
#include "core/base/system_error.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

// Removes the temporary file unless it was renamed into place.
struct TemporaryFile {
  fs::path path;
  FileDescriptor file;
  bool kept = false;

  TemporaryFile() = default;
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!path.empty() && !kept) ::unlink(path.c_str());
  }
};

// Where the bytes really go: through links, and never over a device, FIFO or folder.
fs::path resolved_target(const fs::path& path) {
  std::error_code none;
  const fs::path target = fs::is_symlink(path, none) ? fs::weakly_canonical(path, none) : path;
  struct stat status {};
  if (!target.empty() && ::stat(target.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    if (S_ISDIR(status.st_mode)) throw system_error(path, "written", EISDIR);
    throw Error(printable(path.string()) + ": is no regular file; choose another name");
  }
  return target.empty() ? path : target;
}

fs::path folder_of(const fs::path& target) {
  const fs::path folder = target.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

// O_EXCL with the process umask, unlike mkstemp, whose files only their owner may read.
void create_beside(const fs::path& target, TemporaryFile& temporary) {
  const auto ticks = std::chrono::steady_clock::now().time_since_epoch().count();
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::string name = ".bosk-" + std::to_string(::getpid()) + "-" + std::to_string(ticks) +
                             "-" + std::to_string(attempt) + ".tmp";
    const fs::path path = folder_of(target) / name;
    temporary.file = FileDescriptor(
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (temporary.file) {
      temporary.path = path;
      return;
    }
    if (errno != EEXIST) throw system_error(target, "written", errno);
  }
  throw system_error(target, "written", EEXIST);
}

void write_all(const fs::path& target, int file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written =
        ::write(file, bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 30));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw system_error(target, "written", written == 0 ? EIO : errno);
    bytes = bytes.subspan(std::size_t(written));
  }
}

void sync_folder(const fs::path& target) {
  const FileDescriptor folder(
      ::open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Some file systems cannot sync a folder (EINVAL); a folder that may be written but not read
  // cannot be opened. The rename stands in both cases.
  if (folder && ::fsync(folder.get()) != 0 && errno != EINVAL) {
    throw system_error(target, "synced", errno);
  }
}

// Writes beside the target and renames over it.
void replace_file(const fs::path& target, std::span<const std::byte> bytes, bool synced) {
  TemporaryFile temporary;
  create_beside(target, temporary);
  write_all(target, temporary.file.get(), bytes);
  if (synced && ::fsync(temporary.file.get()) != 0) throw system_error(target, "synced", errno);
  if (temporary.file.close() != 0) throw system_error(target, "written", errno);
  if (::rename(temporary.path.c_str(), target.c_str()) != 0) {
    throw system_error(target, "replaced", errno);
  }
  temporary.kept = true;
}

}  // namespace

void require_writable(const fs::path& path) {
  TemporaryFile temporary;
  create_beside(resolved_target(path), temporary);
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  const fs::path target = resolved_target(path);
  replace_file(target, bytes, true);
  sync_folder(target);
}

void write_file_unsynced(const fs::path& path, std::span<const std::byte> bytes) {
  replace_file(resolved_target(path), bytes, false);
}

void write_file_atomically(const fs::path& path, std::string_view text) {
  write_file_atomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

std::vector<std::byte> read_file(const fs::path& path, std::uint64_t max_bytes) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file) throw system_error(path, "read", errno);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw system_error(path, "read", errno);
  if (S_ISDIR(status.st_mode)) throw system_error(path, "read", EISDIR);
  if (!S_ISREG(status.st_mode)) {
    throw Error(printable(path.string()) + ": is no regular file; give a file");
  }
  const auto too_large = [&] {
    return Error(printable(path.string()) + ": is larger than the " + std::to_string(max_bytes) +
                 " bytes expected of such a file; check that it is the right one");
  };
  if (std::uint64_t(status.st_size) > max_bytes) throw too_large();

  // One byte more than its size, so that a file that grew or hides its size (/proc) is noticed
  std::vector<std::byte> bytes(std::size_t(status.st_size) + 1);
  std::size_t filled = 0;
  while (true) {
    if (filled == bytes.size()) bytes.resize(2 * bytes.size());
    const ssize_t got = ::read(file.get(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw system_error(path, "read", errno);
    if (got == 0) break;
    filled += std::size_t(got);
    if (filled > max_bytes) throw too_large();
  }
  bytes.resize(filled);
  return bytes;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure && !std::filesystem::is_directory(folder)) {
    throw system_error(folder, "created", failure.value());
  }
}

}  // namespace bosk
