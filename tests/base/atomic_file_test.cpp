#include "core/base/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <string>

#include "core/base/error.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string text_of(const fs::path& path) {
  const auto bytes = read_file(path, 1 << 20);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

ErrorKind kind_of_failure(const std::function<void()>& action, std::string& message) {
  try {
    action();
  } catch (const Error& error) {
    message = error.what();
    return error.kind();
  }
  ADD_FAILURE() << "nothing was refused";
  return ErrorKind::temporary;
}

TEST(AtomicFile, WritesAndReplacesWithNothingBeside) {
  const ScratchFolder folder;
  write_file_atomically(folder / "tree.bosk", "first");
  write_file_atomically(folder / "tree.bosk", "second, longer");
  EXPECT_EQ(text_of(folder / "tree.bosk"), "second, longer");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFile, WithoutSyncingReplacesTheSameWay) {
  const ScratchFolder folder;
  const fs::path path = folder / "a";
  write_file_atomically(path, "old");
  const std::string text = "new and longer";
  write_file_unsynced(path, std::as_bytes(std::span(text.data(), text.size())));
  EXPECT_EQ(read_file(path, 100).size(), text.size());
  EXPECT_EQ(folder.file_count(), 1u);
  EXPECT_THROW(write_file_unsynced(folder / "none" / "a", {}), Error);
}

TEST(AtomicFile, GivesNewFilesTheUsualPermissions) {
  const ScratchFolder folder;
  const mode_t mask = ::umask(0022);
  write_file_atomically(folder / "tree.bosk", "x");
  ::umask(mask);
  EXPECT_EQ(fs::status(folder / "tree.bosk").permissions(), fs::perms(0644));
}

TEST(AtomicFile, FollowsALinkAndKeepsIt) {
  const ScratchFolder folder;
  write_file_atomically(folder / "real", "old");
  fs::create_symlink("real", folder / "link");
  write_file_atomically(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(text_of(folder / "real"), "new");
}

TEST(AtomicFile, TakesNamesOfFullLength) {
  const ScratchFolder folder;
  const std::string name(255, 'n');
  write_file_atomically(folder / name, "x");
  EXPECT_EQ(text_of(folder / name), "x");
}

TEST(AtomicFile, RefusesAMissingFolderByName) {
  const ScratchFolder folder;
  std::string message;
  const auto kind =
      kind_of_failure([&] { write_file_atomically(folder / "missing/tree.bosk", "x"); }, message);
  EXPECT_EQ(kind, ErrorKind::bad_input);
  EXPECT_THAT(message, HasSubstr("missing/tree.bosk"));
}

TEST(AtomicFile, RefusesAnUnwritableFolder) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const ScratchFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  std::string message;
  const auto kind =
      kind_of_failure([&] { write_file_atomically(folder / "tree.bosk", "x"); }, message);
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_EQ(kind, ErrorKind::bad_input);
  EXPECT_THAT(message, HasSubstr("permissions"));
}

TEST(AtomicFile, RefusesFoldersAndDevices) {
  const ScratchFolder folder;
  EXPECT_THROW(write_file_atomically(folder.path(), "x"), Error);
  EXPECT_THROW(write_file_atomically("/dev/full", "x"), Error);
  EXPECT_TRUE(fs::exists("/dev/full"));
}

// A limit on the size of files stands for a full disk: write(2) fails halfway in the same way.
TEST(AtomicFile, AFullDiskKeepsTheOldFileAndLeavesNothingBehind) {
  const ScratchFolder folder;
  write_file_atomically(folder / "tree.bosk", "old");
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1000, before.rlim_max};
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  std::string message;
  const auto kind = kind_of_failure(
      [&] { write_file_atomically(folder / "tree.bosk", std::string(5000, 'x')); }, message);
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  EXPECT_EQ(kind, ErrorKind::resource);
  EXPECT_EQ(text_of(folder / "tree.bosk"), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(ReadFile, RefusesWhatIsMissingTooLargeOrNoFile) {
  const ScratchFolder folder;
  write_file_atomically(folder / "ten", "0123456789");
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  EXPECT_THROW(read_file(folder / "missing", 100), Error);
  EXPECT_THROW(read_file(folder / "ten", 9), Error);
  EXPECT_THROW(read_file(folder / "fifo", 100), Error);
  EXPECT_THROW(read_file(folder.path(), 100), Error);
  EXPECT_EQ(read_file(folder / "ten", 10).size(), 10u);
}

TEST(ReadFile, ReadsFilesThatHideTheirSize) {
  EXPECT_FALSE(read_file("/proc/self/stat", 1 << 16).empty());
}

TEST(ReadFile, ShowsNoControlCharactersOfAFileName) {
  std::string message;
  kind_of_failure([] { read_file("evil\x1b[2J.jpg", 10); }, message);
  EXPECT_EQ(message.find('\x1b'), std::string::npos);
}

TEST(RequireWritable, RefusesWhatWritingWouldAndLeavesNothing) {
  const ScratchFolder folder;
  EXPECT_NO_THROW(require_writable(folder / "page.html"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_THROW(require_writable(folder / "none" / "page.html"), Error);
  EXPECT_THROW(require_writable(folder.path()), Error);
}

}  // namespace
}  // namespace bosk
