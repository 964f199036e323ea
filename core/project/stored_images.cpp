#include "core/project/stored_images.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdint>
#include <glm/gtc/type_precision.hpp>

#include "core/base/error.h"
#include "core/project/binary_items.h"

namespace bosk {
namespace {

constexpr float kLargest = 65535.0f;
constexpr int kMaxEdgePx = 1 << 20;

std::uint16_t short_from_unit(float value) {
  return value > 0.0f ? std::uint16_t(std::lround(std::fmin(value, 1.0f) * kLargest)) : 0;
}

glm::u16vec3 shorts_from_units(const glm::vec3& value) {
  return {short_from_unit(value.x), short_from_unit(value.y), short_from_unit(value.z)};
}

glm::u16vec4 shorts_from_units(const glm::vec4& value) {
  const std::uint16_t alpha = short_from_unit(value.a);
  if (alpha == 0) return glm::u16vec4(0);
  return {shorts_from_units(glm::vec3(value)), alpha};
}

template <class Short, class Pixel>
void write_image(BinaryWriter& writer, const Image<Pixel>& image) {
  std::vector<Short> shorts(image.size());
  tbb::parallel_for(std::size_t(0), image.size(),
                    [&](std::size_t i) { shorts[i] = shorts_from_units(image.data()[i]); });
  writer.value(image.width());
  writer.value(image.height());
  writer.array(shorts);
}

template <class Pixel, class Short>
Image<Pixel> read_image(BinaryReader& reader) {
  const int width = reader.value<int>();
  const int height = reader.value<int>();
  const auto shorts = reader.array<Short>();
  const bool sound = width >= 0 && height >= 0 && width <= kMaxEdgePx && height <= kMaxEdgePx &&
                     std::size_t(width) * std::size_t(height) == shorts.size();
  if (!sound) throw Error("stored image is damaged");
  Image<Pixel> image(width, height);
  tbb::parallel_for(std::size_t(0), image.size(),
                    [&](std::size_t i) { image.data()[i] = Pixel(shorts[i]) / kLargest; });
  return image;
}

}  // namespace

void write_stored(BinaryWriter& writer, const ImportedPhotos& imported) {
  write_stored(writer, imported.photos);
  writer.value(std::uint64_t(imported.verdicts.size()));
  for (const PhotoVerdict& verdict : imported.verdicts) {
    writer.text(verdict.name);
    writer.value(verdict.accepted);
    writer.text(verdict.reason);
    writer.value(glm::ivec2(verdict.width_px, verdict.height_px));
    writer.value(verdict.content);
  }
}

ImportedPhotos read_stored_import(BinaryReader& reader) {
  ImportedPhotos imported;
  imported.photos = read_stored_photos(reader);
  const auto count = reader.value<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    PhotoVerdict verdict;
    verdict.name = verdict.file = reader.text();
    verdict.accepted = reader.value<bool>();
    verdict.reason = reader.text();
    const auto size_px = reader.value<glm::ivec2>();
    verdict.width_px = size_px.x;
    verdict.height_px = size_px.y;
    verdict.content = reader.value<ContentHash>();
    imported.verdicts.push_back(std::move(verdict));
  }
  return imported;
}

void write_stored(BinaryWriter& writer, const Photos& photos) {
  writer.value(std::uint64_t(photos.size()));
  for (const Photo& photo : photos) {
    writer.text(photo.name);
    write_camera(writer, photo.camera);
    write_camera(writer, photo.original_camera);
    write_image<glm::u16vec3>(writer, photo.srgb);
  }
}

Photos read_stored_photos(BinaryReader& reader) {
  Photos photos;
  const auto count = reader.value<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    Photo photo;
    photo.name = reader.text();
    photo.camera = read_camera(reader);
    photo.original_camera = read_camera(reader);
    photo.srgb = read_image<glm::vec3, glm::u16vec3>(reader);
    photos.push_back(std::move(photo));
  }
  return photos;
}

void write_stored(BinaryWriter& writer, const Mattes& mattes) {
  writer.value(std::uint64_t(mattes.size()));
  for (const Matte& matte : mattes) {
    writer.text(matte.name);
    write_image<glm::u16vec4>(writer, matte.rgba);
  }
}

Mattes read_stored_mattes(BinaryReader& reader) {
  Mattes mattes;
  const auto count = reader.value<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    Matte matte;
    matte.name = reader.text();
    matte.rgba = read_image<glm::vec4, glm::u16vec4>(reader);
    mattes.push_back(std::move(matte));
  }
  return mattes;
}

}  // namespace bosk
