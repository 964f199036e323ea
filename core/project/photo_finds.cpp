#include "core/project/photo_finds.h"

#include <algorithm>
#include <chrono>

#include "core/base/error.h"
#include "core/photo/import.h"
#include "core/photo/verdicts.h"
#include "core/project/binary_items.h"
#include "core/project/each_photo.h"

namespace bosk {
namespace {

constexpr int kVersion = 2;  // raised whenever the same photo gives other finds
constexpr const char* kEntry = "find";
constexpr int kFewestEntriesKept = 64;

ContentHash key_of(const SourceFile& photo, const LookFor& wanted) {
  ContentHasher hasher;
  hasher.text(kEntry).value(kVersion).value(photo.content.high).value(photo.content.low);
  hasher.value(std::uint8_t(wanted.balls.has_value())).text(wanted.tags);
  if (wanted.balls) {
    const BallOptions& balls = *wanted.balls;
    hasher.value(balls.smallest_diameter_px).value(balls.largest_diameter_px);
    hasher.value(balls.least_visible);
  }
  hasher.value(std::uint8_t(wanted.board.has_value()));
  if (wanted.board) {
    const BoardShape& board = *wanted.board;
    hasher.value(board.kind).value(board.columns).value(board.rows).value(board.square_m);
    hasher.text(board.dictionary).value(board.marker_share);
  }
  return hasher.finish();
}

// None where EXIF says nothing of it; guessed_lens would guess then.
std::optional<double> exif_focal_px(const DecodedPhoto& photo) {
  if (!photo.metadata.focal_35mm_equivalent_mm) return std::nullopt;
  return guessed_lens(photo).focal_px.x;
}

PhotoFinds look_at(const SourceFile& file, const LookFor& wanted, PhotoDecoder& decoder,
                   const Progress& progress) {
  PhotoFinds finds;
  finds.name = file.name;
  DecodedPhoto decoded = decoder.decode(file.path, progress);
  finds.width_px = decoded.width_px;
  finds.height_px = decoded.height_px;
  finds.exif_focal_px = exif_focal_px(decoded);
  finds.up_in_camera = decoded.metadata.up_in_camera;
  finds.taken_with = identity_of(decoded.metadata);
  const Image<glm::vec3> srgb = srgb_of(decoded);
  decoded = {};
  if (wanted.balls) finds.balls = find_balls(srgb, *wanted.balls, progress);
  if (!wanted.tags.empty()) finds.tags = find_tags(srgb, wanted.tags, progress);
  if (wanted.board) finds.corners = find_board(grey_of(srgb), *wanted.board, progress);
  return finds;
}

// What can't be read isn't kept: the next run may find it mended.
PhotoFinds looked_at(const SourceFile& file, const LookFor& wanted, PhotoDecoder& decoder,
                     const Cache& cache, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  PhotoFinds finds;
  try {
    finds = look_at(file, wanted, decoder, progress);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    PhotoVerdict verdict;
    reject(verdict, error);
    finds = {};
    finds.name = file.name;
    finds.trouble = verdict.reason;
    return finds;
  }
  BinaryWriter writer;
  write(writer, finds);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  cache.store(kEntry, key_of(file, wanted), writer.bytes(), spent.count());
  return finds;
}

std::optional<PhotoFinds> kept_finds(const SourceFile& file, const LookFor& wanted,
                                     const Cache& cache) {
  const auto entry = cache.load(kEntry, key_of(file, wanted));
  if (!entry) return std::nullopt;
  try {
    PhotoFinds finds = read_all<PhotoFinds>(entry->result, read_photo_finds);
    finds.name = file.name;  // the same photo may go by another name now
    return finds;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<PhotoFinds> find_in_photos(const std::vector<SourceFile>& photos, const LookFor& wanted,
                                       const DecodeLimits& limits, const Cache& cache,
                                       Progress& progress) {
  progress.begin("looking through photos", photos.size());
  std::vector<PhotoFinds> all(photos.size());
  for_each_photo(photos.size(), limits, progress, [&](std::size_t i, PhotoDecoder& decoder) {
    const auto kept = kept_finds(photos[i], wanted, cache);
    all[i] = kept ? *kept : looked_at(photos[i], wanted, decoder, cache, progress);
  });
  const int keep = std::max(kFewestEntriesKept, 8 * int(photos.size()));
  if (!photos.empty()) cache.forget_old(kEntry, key_of(photos.front(), wanted), keep);
  return all;
}

void write(BinaryWriter& writer, const PhotoFinds& finds) {
  writer.text(finds.name);
  writer.value(glm::ivec2(finds.width_px, finds.height_px));
  write_optional(writer, finds.exif_focal_px);
  write_optional(writer, finds.up_in_camera);
  write_lens_identity(writer, finds.taken_with);
  writer.array(finds.balls);
  writer.array(finds.tags);
  writer.array(finds.corners);
}

PhotoFinds read_photo_finds(BinaryReader& reader) {
  PhotoFinds finds;
  finds.name = reader.text();
  const auto size_px = reader.value<glm::ivec2>();
  finds.width_px = size_px.x;
  finds.height_px = size_px.y;
  finds.exif_focal_px = read_optional<double>(reader);
  finds.up_in_camera = read_optional<glm::dvec3>(reader);
  finds.taken_with = read_lens_identity(reader);
  finds.balls = reader.array<SightedBall>();
  finds.tags = reader.array<SightedTag>();
  finds.corners = reader.array<BoardCorner>();
  return finds;
}

}  // namespace bosk
