#include "core/project/cache.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/project/lock.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kSeveralChunks = (std::size_t(9) << 20) + 17;

Bytes noise(std::size_t size) {
  Random random(7);
  Bytes bytes(size);
  for (std::byte& byte : bytes) byte = std::byte(random.bits() & 0x3f);
  return bytes;
}

// Without syncing, unlike the real thing: these tests write hundreds of files.
void overwrite(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::filesystem::remove(path);  // a file cut to nothing first is synced by some systems, and slow
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

const ContentHash kKey{1, 2}, kOther{3, 4};

TEST(Cache, GivesBackWhatWasStored) {
  const ScratchFolder folder;
  const Cache cache(folder / "cache");
  for (const std::size_t size : {std::size_t(0), std::size_t(1), kSeveralChunks}) {
    const Bytes result = noise(size);
    cache.store("opacity", kKey, result, 1.5);
    EXPECT_TRUE(cache.contains("opacity", kKey));
    const auto entry = cache.load("opacity", kKey);
    ASSERT_TRUE(entry) << size;
    EXPECT_EQ(entry->result, result) << size;
    EXPECT_EQ(entry->seconds, 1.5);
    EXPECT_EQ(cache.seconds_spent("opacity", kKey), 1.5);
  }
}

TEST(Cache, MissesWhatWasNeverStored) {
  const ScratchFolder folder;
  const Cache cache(folder / "cache");
  EXPECT_FALSE(cache.contains("opacity", kKey));
  EXPECT_FALSE(cache.load("opacity", kKey));
  cache.store("opacity", kKey, noise(10), 0.0);
  EXPECT_FALSE(cache.load("opacity", kOther));
  EXPECT_FALSE(cache.load("matte", kKey));
}

TEST(Cache, TakesAnEntryUnderAnotherNameForAMiss) {
  const ScratchFolder folder;
  const Cache cache(folder.path());
  cache.store("opacity", kKey, noise(10), 0.0);
  std::filesystem::rename(cache.path("opacity", kKey), cache.path("opacity", kOther));
  EXPECT_FALSE(cache.load("opacity", kOther));
}

TEST(Cache, TakesEveryFlippedBitForAMiss) {
  const ScratchFolder folder;
  const Cache cache(folder.path());
  cache.store("opacity", kKey, noise(300), 0.0);
  const Bytes sound = read_file(cache.path("opacity", kKey), 1 << 20);
  for (std::size_t bit = 0; bit < 8 * sound.size(); bit += 5) {
    Bytes damaged = sound;
    damaged[bit / 8] ^= std::byte(1u << (bit % 8));
    overwrite(cache.path("opacity", kKey), damaged);
    EXPECT_FALSE(cache.load("opacity", kKey)) << "bit " << bit;
  }
}

TEST(Cache, TakesEveryCutForAMiss) {
  const ScratchFolder folder;
  const Cache cache(folder.path());
  cache.store("opacity", kKey, noise(300), 0.0);
  const Bytes sound = read_file(cache.path("opacity", kKey), 1 << 20);
  for (std::size_t size = 0; size < sound.size(); size += 7) {
    overwrite(cache.path("opacity", kKey), std::span(sound).first(size));
    EXPECT_FALSE(cache.load("opacity", kKey)) << size;
  }
}

TEST(Cache, ForgetsTheOldestEntriesOfOneStageOnly) {
  const ScratchFolder folder;
  const Cache cache(folder.path());
  const auto now = std::filesystem::file_time_type::clock::now();
  for (std::uint64_t i = 0; i < 5; ++i) {
    cache.store("opacity", {i, 0}, noise(10), 0.0);
    std::filesystem::last_write_time(cache.path("opacity", {i, 0}),
                                     now + std::chrono::seconds(i) - std::chrono::hours(1));
  }
  cache.store("matte", kKey, noise(10), 0.0);
  cache.forget_old("opacity", {4, 0}, 2);
  EXPECT_TRUE(cache.contains("opacity", {4, 0}));
  EXPECT_TRUE(cache.contains("opacity", {3, 0}));
  EXPECT_FALSE(cache.contains("opacity", {2, 0}));
  EXPECT_FALSE(cache.contains("opacity", {0, 0}));
  EXPECT_TRUE(cache.contains("matte", kKey));
}

TEST(Cache, NeverForgetsTheEntryJustUsed) {
  const ScratchFolder folder;
  const Cache cache(folder.path());
  cache.store("opacity", {0, 0}, noise(10), 0.0);
  cache.store("opacity", {1, 0}, noise(10), 0.0);
  cache.forget_old("opacity", {0, 0}, 0);
  EXPECT_TRUE(cache.contains("opacity", {0, 0}));
  EXPECT_FALSE(cache.contains("opacity", {1, 0}));
}

TEST(Cache, SweepsHalfWrittenFilesAway) {
  const ScratchFolder folder;
  const Cache cache(folder.path());
  cache.store("opacity", kKey, noise(10), 0.0);
  std::ofstream(folder / ".bosk-1-2-3.tmp") << "half";
  cache.sweep();
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(ProjectLock, RefusesASecondHolderAsTemporary) {
  const ScratchFolder folder;
  const ProjectLock held(folder.path());
  try {
    const ProjectLock second(folder.path());
    FAIL() << "locked twice";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::temporary);
    EXPECT_NE(std::string(error.what()).find("is working on this project"), std::string::npos);
  }
}

TEST(ProjectLock, IsFreeAgainAfterItsHolder) {
  const ScratchFolder folder;
  { const ProjectLock first(folder.path()); }
  EXPECT_NO_THROW(ProjectLock(folder.path()));
}

}  // namespace
}  // namespace bosk
