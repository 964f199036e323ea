#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "core/base/progress.h"
#include "core/photo/import.h"
#include "ui/workstation/photos/photo_shelf.h"

namespace bosk {

// A job's share of looking through photos: values in, values out.
struct LookRequest {
  struct Named {
    std::filesystem::path photo, file;  // as the project has it; where it is
  };
  std::vector<Named> photos;
  std::map<std::filesystem::path, FileStamp> known;  // files that need no second look
  std::shared_ptr<DecoderPool> decoders;
  PhotoOptions options;
  std::filesystem::path cache_folder;
};

struct Look {
  std::set<std::filesystem::path> missing;
  std::map<std::filesystem::path, ShelvedPhoto> read;  // by file
  std::size_t left = 0;                                // photos that are still to be read
};

// Looks where all files are and which have changed; takes what the cache holds of those, and reads
// the first few of the rest. A cache that can't be written is a warning. Throws Cancelled, and
// Error where memory or processes ran out.
Look look_through(const LookRequest& request, Progress& progress);

}  // namespace bosk
