#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <thread>

#include "core/base/content_hash.h"
#include "core/base/file_descriptor.h"
#include "core/base/system_error.h"
#include "core/project/edit_bytes.h"
#include "core/project/journal.h"
#include "core/project/journal_record.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

// Gathers what is drawn in quick succession; well within the second that is promised.
constexpr std::chrono::milliseconds kSyncDelay(250);

FileDescriptor open_for_writing(const fs::path& path, const JournalPlace& place) {
  FileDescriptor file(::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC));
  if (!file) throw system_error(path, "written", errno);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw system_error(path, "read", errno);
  if (std::uint64_t(status.st_size) > place.end && ::ftruncate(file.get(), off_t(place.end)) != 0) {
    throw system_error(path, "written", errno);
  }
  return file;
}

// 0 or an errno.
int write_at(int file, std::uint64_t place, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), off_t(place));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written == 0 ? EIO : errno;
    bytes = bytes.subspan(std::size_t(written));
    place += std::uint64_t(written);
  }
  return 0;
}

int sync_file(int file) {
  // Some file systems cannot sync (EINVAL); what was written stands all the same
  return ::fdatasync(file) == 0 || errno == EINVAL ? 0 : errno;
}

}  // namespace

std::uint64_t record_checksum(std::uint64_t journal_id, std::uint64_t place, const RecordHead& head,
                              std::span<const std::byte> payload) {
  ContentHasher hasher;
  hasher.value(journal_id).value(place).value(head.length).value(head.step).bytes(payload);
  return hasher.finish().low;
}

// Brings the file to the disk behind the writer's back, on a thread of its own.
struct JournalWriter::Syncer {
  explicit Syncer(FileDescriptor opened) : file(std::move(opened)), thread([this] { run(); }) {}
  ~Syncer() {
    {
      const std::lock_guard lock(mutex);
      stopping = true;
    }
    wake.notify_all();
    thread.join();
  }

  void run() {
    std::unique_lock lock(mutex);
    while (true) {
      wake.wait(lock, [&] { return dirty || stopping; });
      if (!dirty) return;
      wake.wait_for(lock, kSyncDelay, [&] { return stopping; });
      dirty = false;
      lock.unlock();
      const int code = sync_file(file.get());
      lock.lock();
      if (code != 0) failure = code;
    }
  }

  void mark_dirty() {
    {
      const std::lock_guard lock(mutex);
      dirty = true;
    }
    wake.notify_all();
  }

  int take_failure() {
    const std::lock_guard lock(mutex);
    return std::exchange(failure, 0);
  }

  FileDescriptor file;
  std::mutex mutex;
  std::condition_variable wake;
  bool dirty = false, stopping = false;
  int failure = 0;     // errno of a sync that failed
  std::thread thread;  // last: it uses all the others
};

JournalWriter::JournalWriter(const fs::path& folder, const JournalPlace& place)
    : path_(journal_file(folder)),
      place_(place),
      syncer_(std::make_unique<Syncer>(open_for_writing(path_, place))) {}

JournalWriter::~JournalWriter() = default;

std::uint64_t JournalWriter::append(StepKind kind, const Edit* edit) {
  const std::vector<std::byte> payload = edit ? bytes_of_edit(*edit) : std::vector<std::byte>();
  if (payload.size() > kMaxRecordBytes) {
    throw Error(printable(path_.string()) + ": cannot hold an edit of more than 256 MiB");
  }
  RecordHead head{std::uint32_t(payload.size()), std::uint32_t(kind), 0};
  head.checksum = record_checksum(place_.id, place_.end, head, payload);
  std::vector<std::byte> record(sizeof(head) + payload.size());
  std::memcpy(record.data(), &head, sizeof(head));
  if (!payload.empty()) std::memcpy(record.data() + sizeof(head), payload.data(), payload.size());
  if (const int code = write_at(syncer_->file.get(), place_.end, record)) {
    // Half a record would be overwritten by the next one anyway, or end a replay
    (void)!::ftruncate(syncer_->file.get(), off_t(place_.end));
    throw system_error(path_, "written", code);
  }
  place_.end += record.size();
  syncer_->mark_dirty();
  return place_.end;
}

void JournalWriter::sync() {
  const int earlier = syncer_->take_failure();
  const int code = sync_file(syncer_->file.get());
  if (earlier != 0 || code != 0) throw system_error(path_, "synced", code != 0 ? code : earlier);
}

}  // namespace bosk
