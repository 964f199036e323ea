#include "ui/workstation/photos/shelf_cache.h"

#include <memory>

#include "core/base/binary.h"
#include "core/base/error.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

constexpr const char* kStage = "shelf";
constexpr int kVersion = 2;  // raised whenever the same file gives another entry

void write(BinaryWriter& writer, const DecodedPhoto& photo) {
  writer.value(photo.format);
  writer.value(photo.width_px);
  writer.value(photo.height_px);
  writer.value(photo.channels);
  writer.value(photo.kind);
  write(writer, photo.metadata);
  writer.value(std::uint64_t(photo.notes.size()));
  for (const std::string& note : photo.notes) writer.text(note);
}

DecodedPhoto read_decoded(BinaryReader& reader) {
  DecodedPhoto photo;
  photo.format = reader.value<PhotoFormat>();
  photo.width_px = reader.value<int>();
  photo.height_px = reader.value<int>();
  photo.channels = reader.value<int>();
  photo.kind = reader.value<PixelKind>();
  photo.metadata = read_photo_metadata(reader);
  for (auto left = reader.value<std::uint64_t>(); left > 0; --left) {
    photo.notes.push_back(reader.text());
  }
  return photo;
}

void write(BinaryWriter& writer, const Image<glm::u8vec4>& picture) {
  writer.value(picture.width());
  writer.value(picture.height());
  writer.array(picture.pixels());
}

std::shared_ptr<const Image<glm::u8vec4>> read_picture(BinaryReader& reader) {
  const int width = reader.value<int>(), height = reader.value<int>();
  auto pixels = reader.array<glm::u8vec4>();
  if (pixels.empty()) return nullptr;
  if (width < 0 || height < 0 || pixels.size() != std::size_t(width) * std::size_t(height)) {
    throw Error("stored picture has another size than its pixels");
  }
  auto picture = std::make_shared<Image<glm::u8vec4>>(width, height);
  picture->pixels() = std::move(pixels);
  return picture;
}

ShelvedPhoto read_shelved(BinaryReader& reader) {
  ShelvedPhoto photo;
  if (reader.value<std::uint8_t>() != 0) photo.facts.content = reader.value<ContentHash>();
  photo.facts.decoded = read_decoded(reader);
  photo.facts.trouble = reader.text();
  photo.thumbnail = read_picture(reader);
  return photo;
}

}  // namespace

ContentHash shelf_key(const fs::path& photo, const FileStamp& stamp, const PhotoOptions& limits) {
  ContentHasher hasher;
  hasher.value(kVersion).text(photo.string()).value(stamp.bytes);
  hasher.value(stamp.changed.time_since_epoch().count());
  hasher.value(limits.max_megapixels).value(limits.memory_gib).value(limits.seconds);
  return hasher.finish();
}

std::optional<ShelvedPhoto> load_shelved(const Cache& cache, const ContentHash& key,
                                         const fs::path& file, const FileStamp& stamp) {
  const auto entry = cache.load(kStage, key);
  if (!entry) return std::nullopt;
  try {
    BinaryReader reader(entry->result);
    ShelvedPhoto photo = read_shelved(reader);
    photo.stamp = stamp;
    photo.facts.file = file;
    return photo;
  } catch (const Error&) {
    return std::nullopt;  // another version wrote it; it is read anew
  }
}

void store_shelved(const Cache& cache, const ContentHash& key, const ShelvedPhoto& photo) {
  BinaryWriter writer;
  writer.value(std::uint8_t(photo.facts.content.has_value()));
  if (photo.facts.content) writer.value(*photo.facts.content);
  write(writer, photo.facts.decoded);
  writer.text(photo.facts.trouble);
  write(writer, photo.thumbnail ? *photo.thumbnail : Image<glm::u8vec4>());
  cache.store(kStage, key, writer.bytes(), 0.0);
}

void forget_shelved(const Cache& cache, const ContentHash& key, int kept) {
  cache.forget_old(kStage, key, kept);
}

}  // namespace bosk
