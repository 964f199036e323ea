#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/content_hash.h"

namespace bosk {

struct CacheEntry {
  std::vector<std::byte> result;
  double seconds = 0.0;  // that making it took, for reports
};

// Results of stages on disk, one file each, found by the key of the stage's inputs, options and
// version. An entry that is missing, cut short or damaged is a miss, never an error: what is lost
// is time. Entry, little-endian:
//   [magic 8 B][xxh3-128 of the rest 16 B][key 16 B][raw bytes u64][chunks u64][seconds f64]
//   [stored bytes of each chunk u64 x chunks][chunks: zstd of 4 MiB of the result each]
class Cache {
 public:
  explicit Cache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // Whether an entry of plausible length is there; its content is only checked by `load`.
  bool contains(const std::string& stage, const ContentHash& key) const;
  std::optional<CacheEntry> load(const std::string& stage, const ContentHash& key) const;
  // What making the entry took, from its header alone; none when it isn't there.
  std::optional<double> seconds_spent(const std::string& stage, const ContentHash& key) const;
  // Makes the folder when it is missing. Throws Error (disk full, folder not writable).
  void store(const std::string& stage, const ContentHash& key, std::span<const std::byte> result,
             double seconds) const;
  // Deletes all but the `keep` newest entries of the stage, and never the entry of `key`.
  void forget_old(const std::string& stage, const ContentHash& key, int keep) const;
  // Deletes what a killed process left half-written. Only for the holder of the project's lock.
  void sweep() const;

  std::filesystem::path path(const std::string& stage, const ContentHash& key) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace bosk
