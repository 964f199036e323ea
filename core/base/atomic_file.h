#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace bosk {

// Puts `bytes` at `path` so that a reader, a crash or a full disk never sees half a file: written
// beside the target, synced, renamed over it, folder synced. On Error the old file is untouched and
// nothing is left behind. A link is followed; anything but a regular file is refused.
// Full disk or quota: Error of kind resource; missing or unwritable folder: bad_input.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file_atomically(const std::filesystem::path& path, std::string_view text);
// The same without waiting for the disk: for what can be made again and whose reader finds damage,
// since a power cut may leave the name with other bytes behind it. No kill and no full disk can.
void write_file_unsynced(const std::filesystem::path& path, std::span<const std::byte> bytes);

// Throws the Error that write_file_atomically would for the place: before work whose result goes
// there. Leaves nothing behind.
void require_writable(const std::filesystem::path& path);

// The whole file. Error when it is missing, unreadable, no regular file (a FIFO never blocks), or
// larger than `max_bytes`.
std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t max_bytes);

// With all folders above it; nothing where it is there. Throws Error.
void make_folder(const std::filesystem::path& folder);

}  // namespace bosk
