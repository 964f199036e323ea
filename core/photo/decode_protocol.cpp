#include "core/photo/decode_protocol.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include "core/base/binary.h"
#include "core/base/system_error.h"

namespace bosk {
namespace {

constexpr std::size_t kMaxTextBytes = 300;
constexpr std::size_t kMaxNotes = 20;

void write(BinaryWriter& writer, const std::optional<double>& number) {
  writer.value(number.value_or(0.0));  // no quantity of a photo is 0
}

std::optional<double> read_positive(BinaryReader& reader) {
  const double number = reader.value<double>();
  if (!(number > 0.0) || !std::isfinite(number)) return std::nullopt;
  return number;
}

// 0 for none.
std::optional<glm::dvec3> read_direction(BinaryReader& reader) {
  const auto direction = reader.value<glm::dvec3>();
  const double length = glm::length(direction);
  if (!(length > 0.5 && length < 2.0)) return std::nullopt;
  return direction / length;
}

std::string read_text(BinaryReader& reader) {
  return printable(reader.text().substr(0, kMaxTextBytes));
}

// Not a Number and infinity become 0; gives how many there were.
std::size_t clean(std::vector<std::byte>& pixels) {
  std::size_t cleaned = 0;
  for (std::size_t at = 0; at + sizeof(float) <= pixels.size(); at += sizeof(float)) {
    float value = 0.0f;
    std::memcpy(&value, &pixels[at], sizeof(float));
    if (std::isfinite(value)) continue;
    std::memset(&pixels[at], 0, sizeof(float));
    ++cleaned;
  }
  return cleaned;
}

Error implausible() { return Error("the decoder's answer makes no sense"); }

DecodedPhoto read_header(std::span<const std::byte> header) {
  BinaryReader reader(header);
  DecodedPhoto photo;
  photo.width_px = reader.value<int>();
  photo.height_px = reader.value<int>();
  photo.channels = reader.value<int>();
  photo.kind = reader.value<PixelKind>();
  photo.metadata = read_photo_metadata(reader);
  const auto note_count = reader.value<std::uint32_t>();
  if (note_count > kMaxNotes) throw implausible();
  for (std::uint32_t i = 0; i < note_count; ++i) photo.notes.push_back(read_text(reader));
  return photo;
}

bool plausible(const DecodedPhoto& photo, const DecodeLimits& limits) {
  const double megapixels = 1e-6 * double(photo.width_px) * double(photo.height_px);
  return photo.width_px > 0 && photo.height_px > 0 && megapixels <= limits.max_megapixels &&
         photo.channels >= 1 && photo.channels <= 4 && photo.kind <= PixelKind::f32_linear;
}

}  // namespace

void write(BinaryWriter& writer, const PhotoMetadata& metadata) {
  write(writer, metadata.focal_mm);
  write(writer, metadata.focal_35mm_equivalent_mm);
  write(writer, metadata.exposure_s);
  write(writer, metadata.iso);
  write(writer, metadata.f_number);
  writer.value(metadata.orientation);
  writer.value(metadata.up_in_camera.value_or(glm::dvec3(0.0)));
  writer.text(metadata.make);
  writer.text(metadata.model);
}

PhotoMetadata read_photo_metadata(BinaryReader& reader) {
  PhotoMetadata metadata;
  metadata.focal_mm = read_positive(reader);
  metadata.focal_35mm_equivalent_mm = read_positive(reader);
  metadata.exposure_s = read_positive(reader);
  metadata.iso = read_positive(reader);
  metadata.f_number = read_positive(reader);
  metadata.orientation = reader.value<int>();
  if (metadata.orientation < 1 || metadata.orientation > 8) metadata.orientation = 1;
  metadata.up_in_camera = read_direction(reader);
  metadata.make = read_text(reader);
  metadata.model = read_text(reader);
  return metadata;
}

std::size_t bytes_per_value(PixelKind kind) {
  if (kind == PixelKind::u8_srgb) return 1;
  return kind == PixelKind::u16_srgb ? 2 : 4;
}

void append_header(const DecodedPhoto& photo, std::vector<std::byte>& pixels) {
  BinaryWriter writer;
  writer.value(photo.width_px);
  writer.value(photo.height_px);
  writer.value(photo.channels);
  writer.value(photo.kind);
  write(writer, photo.metadata);
  writer.value(std::uint32_t(std::min(photo.notes.size(), kMaxNotes)));
  for (std::size_t i = 0; i < std::min(photo.notes.size(), kMaxNotes); ++i) {
    writer.text(photo.notes[i]);
  }
  writer.value(std::uint64_t(writer.bytes().size()));
  pixels.insert(pixels.end(), writer.bytes().begin(), writer.bytes().end());
}

DecodedPhoto decoded_photo(std::vector<std::byte> message, const DecodeLimits& limits) {
  std::uint64_t header_size = 0;
  if (message.size() < sizeof(header_size)) throw implausible();
  const std::size_t end = message.size() - sizeof(header_size);
  std::memcpy(&header_size, &message[end], sizeof(header_size));
  if (header_size > end) throw implausible();
  const std::size_t pixel_bytes = end - std::size_t(header_size);
  DecodedPhoto photo =
      read_header(std::span(message).subspan(pixel_bytes, std::size_t(header_size)));
  if (!plausible(photo, limits)) throw implausible();
  const std::size_t expected = std::size_t(photo.width_px) * std::size_t(photo.height_px) *
                               std::size_t(photo.channels) * bytes_per_value(photo.kind);
  if (pixel_bytes != expected) throw implausible();
  message.resize(pixel_bytes);
  photo.pixels = std::move(message);
  if (photo.kind == PixelKind::f32_linear) {
    const std::size_t cleaned = clean(photo.pixels);
    if (cleaned > 0) photo.notes.push_back(std::to_string(cleaned) + " values were no numbers");
  }
  return photo;
}

}  // namespace bosk
