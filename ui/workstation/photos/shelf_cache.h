#pragma once

#include <filesystem>
#include <optional>

#include "core/base/content_hash.h"
#include "core/project/cache.h"
#include "ui/workstation/photos/photo_shelf.h"

namespace bosk {

// Photos that were looked through, in the project's cache, so that a project opened again shows
// them at once. An entry that is missing or doesn't read is a miss.

// `photo` as the project names it, so that entries move with the project.
ContentHash shelf_key(const std::filesystem::path& photo, const FileStamp& stamp,
                      const PhotoOptions& limits);
// `file` is where the photo is now.
std::optional<ShelvedPhoto> load_shelved(const Cache& cache, const ContentHash& key,
                                         const std::filesystem::path& file, const FileStamp& stamp);
// Throws Error (disk full, folder not writable).
void store_shelved(const Cache& cache, const ContentHash& key, const ShelvedPhoto& photo);
// Deletes all but the newest entries: `kept`, and that of the key.
void forget_shelved(const Cache& cache, const ContentHash& key, int kept);

}  // namespace bosk
