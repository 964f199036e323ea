#include "core/project/cache.h"

#include <tbb/parallel_for.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <limits>
#include <span>

#include "core/base/atomic_file.h"
#include "core/base/binary.h"
#include "core/base/error.h"
#include "core/base/system_error.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::array<char, 8> kMagic = {'B', 'O', 'S', 'K', 'r', 'e', 's', '\n'};
constexpr std::size_t kChunk = std::size_t(4) << 20;
constexpr int kZstdLevel = 1;  // noise hardly packs at any level, and time matters more than disk

struct Header {
  std::array<char, 8> magic = kMagic;
  ContentHash rest;  // of all that follows
  ContentHash key;
  std::uint64_t raw_bytes = 0;
  std::uint64_t chunks = 0;
  double seconds = 0.0;
};
static_assert(sizeof(Header) == 64);
constexpr std::size_t kUnchecked = offsetof(Header, key);  // bytes before what the checksum covers

std::size_t chunk_count(std::size_t raw_bytes) { return (raw_bytes + kChunk - 1) / kChunk; }

std::span<const std::byte> chunk_of(std::span<const std::byte> raw, std::size_t chunk) {
  return raw.subspan(chunk * kChunk, std::min(kChunk, raw.size() - chunk * kChunk));
}

Bytes packed_chunk(std::span<const std::byte> raw) {
  Bytes packed(ZSTD_compressBound(raw.size()));
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), raw.data(), raw.size(), kZstdLevel);
  if (ZSTD_isError(size)) throw std::runtime_error("a stage's result could not be compressed");
  packed.resize(size);
  return packed;
}

Bytes packed_entry(const ContentHash& key, std::span<const std::byte> raw, double seconds) {
  std::vector<Bytes> chunks(chunk_count(raw.size()));
  tbb::parallel_for(std::size_t(0), chunks.size(),
                    [&](std::size_t i) { chunks[i] = packed_chunk(chunk_of(raw, i)); });
  Bytes entry(sizeof(Header));
  const auto append = [&](const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    entry.insert(entry.end(), first, first + size);
  };
  for (const Bytes& chunk : chunks) {
    const std::uint64_t size = chunk.size();
    append(&size, sizeof(size));
  }
  for (const Bytes& chunk : chunks) append(chunk.data(), chunk.size());
  Header header{kMagic, {}, key, raw.size(), chunks.size(), seconds};
  std::memcpy(entry.data(), &header, sizeof(header));
  header.rest = content_hash(std::span(entry).subspan(kUnchecked));
  std::memcpy(entry.data(), &header, sizeof(header));
  return entry;
}

// The chunks' places in the entry; throws Error when they don't fill it exactly.
std::vector<std::span<const std::byte>> chunk_table(std::span<const std::byte> rest,
                                                    std::size_t count) {
  if (count > rest.size() / sizeof(std::uint64_t)) throw Error("cut short");
  std::vector<std::span<const std::byte>> chunks(count);
  auto data = rest.subspan(count * sizeof(std::uint64_t));
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t size = 0;
    std::memcpy(&size, rest.data() + i * sizeof(size), sizeof(size));
    if (size > data.size()) throw Error("cut short");
    chunks[i] = data.first(size);
    data = data.subspan(size);
  }
  if (!data.empty()) throw Error("longer than it says");
  return chunks;
}

CacheEntry unpacked_entry(const ContentHash& key, std::span<const std::byte> entry) {
  BinaryReader reader(entry);
  const auto header = reader.value<Header>();
  if (header.magic != kMagic || header.key != key) throw Error("not this result");
  if (content_hash(entry.subspan(kUnchecked)) != header.rest) throw Error("damaged");
  if (header.chunks != chunk_count(header.raw_bytes)) throw Error("damaged");
  const auto chunks = chunk_table(entry.subspan(sizeof(Header)), header.chunks);
  Bytes raw(header.raw_bytes);
  tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t i) {
    const auto target = chunk_of(raw, i);
    const std::size_t size =
        ZSTD_decompress(raw.data() + i * kChunk, target.size(), chunks[i].data(), chunks[i].size());
    if (ZSTD_isError(size) || size != target.size()) throw Error("damaged");
  });
  return {std::move(raw), header.seconds};
}

// Entries of the stage, newest first; ties by name so that the order is settled.
std::vector<fs::path> entries_of(const fs::path& folder, const std::string& stage) {
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().filename().string().rfind(stage + "-", 0) != 0) continue;
    found.emplace_back(entry.last_write_time(none), entry.path());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<fs::path> paths;
  paths.reserve(found.size());
  for (auto& [time, path] : found) paths.push_back(std::move(path));
  return paths;
}

}  // namespace

fs::path Cache::path(const std::string& stage, const ContentHash& key) const {
  return folder_ / (stage + "-" + hex(key));
}

bool Cache::contains(const std::string& stage, const ContentHash& key) const {
  std::error_code none;
  const std::uintmax_t size = fs::file_size(path(stage, key), none);
  return !none && size >= sizeof(Header);
}

std::optional<CacheEntry> Cache::load(const std::string& stage, const ContentHash& key) const {
  if (!contains(stage, key)) return std::nullopt;
  try {
    const Bytes entry = read_file(path(stage, key), std::numeric_limits<std::int64_t>::max());
    return unpacked_entry(key, entry);
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::optional<double> Cache::seconds_spent(const std::string& stage, const ContentHash& key) const {
  Header header;
  std::ifstream file(path(stage, key), std::ios::binary);
  file.read(reinterpret_cast<char*>(&header), sizeof(header));
  if (!file || header.magic != kMagic || header.key != key) return std::nullopt;
  return header.seconds;
}

void Cache::store(const std::string& stage, const ContentHash& key,
                  std::span<const std::byte> result, double seconds) const {
  std::error_code failure;
  fs::create_directories(folder_, failure);
  if (failure) throw system_error(folder_, "created", failure.value());
  // A power cut may leave it damaged: then it is a miss, and nobody has to wait for the disk
  write_file_unsynced(path(stage, key), packed_entry(key, result, seconds));
}

void Cache::forget_old(const std::string& stage, const ContentHash& key, int keep) const {
  std::error_code none;
  int kept = 0;
  for (const fs::path& entry : entries_of(folder_, stage)) {
    if (entry == path(stage, key) || kept < keep) {
      ++kept;
    } else {
      fs::remove(entry, none);
    }
  }
}

void Cache::sweep() const {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder_, none)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(".bosk-", 0) == 0) fs::remove(entry.path(), none);
  }
}

}  // namespace bosk
