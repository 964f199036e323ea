#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace bosk {

// The journal's layout (journal.h draws it), for its reader and its writer.
inline constexpr std::array<char, 8> kJournalMagic{'B', 'O', 'S', 'K', 'E', 'D', 'I', 'T'};
inline constexpr std::uint64_t kJournalHeaderBytes = 16;
inline constexpr std::uint64_t kMaxRecordBytes = std::uint64_t(256) << 20;

struct RecordHead {
  std::uint32_t length = 0, step = 0;
  std::uint64_t checksum = 0;
};
inline constexpr std::uint64_t kRecordHeadBytes = sizeof(RecordHead);
static_assert(kRecordHeadBytes == 16);

// Of a record at this place of this journal; what the head has as checksum does not count. A record
// copied elsewhere is damaged.
std::uint64_t record_checksum(std::uint64_t journal_id, std::uint64_t place, const RecordHead& head,
                              std::span<const std::byte> payload);

}  // namespace bosk
