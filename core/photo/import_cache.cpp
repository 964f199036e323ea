#include "core/photo/import.h"

namespace bosk {
namespace {

void write(BinaryWriter& writer, const Lens& lens) {
  writer.value(lens.model);
  writer.value(lens.width_px);
  writer.value(lens.height_px);
  writer.value(lens.focal_px);
  writer.value(lens.principal_px);
  writer.value(lens.distortion);
}

Lens read_lens(BinaryReader& reader) {
  Lens lens;
  lens.model = reader.value<LensModel>();
  lens.width_px = reader.value<int>();
  lens.height_px = reader.value<int>();
  lens.focal_px = reader.value<glm::dvec2>();
  lens.principal_px = reader.value<glm::dvec2>();
  lens.distortion = reader.value<std::array<double, 8>>();
  return lens;
}

void write(BinaryWriter& writer, const Camera& camera) {
  writer.text(camera.name);
  write(writer, camera.lens);
  writer.value(camera.camera_from_world);
}

Camera read_camera(BinaryReader& reader) {
  Camera camera;
  camera.name = reader.text();
  camera.lens = read_lens(reader);
  camera.camera_from_world = reader.value<RigidTransform>();
  return camera;
}

template <class T>
void write(BinaryWriter& writer, const Image<T>& image) {
  writer.value(image.width());
  writer.value(image.height());
  writer.array(image.pixels());
}

template <class T>
Image<T> read_image(BinaryReader& reader) {
  const int width = reader.value<int>(), height = reader.value<int>();
  std::vector<T> pixels = reader.array<T>();
  if (width < 0 || height < 0 || pixels.size() != std::size_t(width) * std::size_t(height)) {
    throw Error("stored photo has another size than its pixels");
  }
  Image<T> image(width, height);
  image.pixels() = std::move(pixels);
  return image;
}

void write(BinaryWriter& writer, const PhotoVerdict& verdict) {
  writer.text(verdict.file);
  writer.text(verdict.name);
  writer.value(verdict.accepted);
  writer.text(verdict.reason);
  writer.value(verdict.width_px);
  writer.value(verdict.height_px);
  write(writer, verdict.metadata);
  writer.value(verdict.content);
}

PhotoVerdict read_verdict(BinaryReader& reader) {
  PhotoVerdict verdict;
  verdict.file = reader.text();
  verdict.name = reader.text();
  verdict.accepted = reader.value<std::uint8_t>() != 0;
  verdict.reason = reader.text();
  verdict.width_px = reader.value<int>();
  verdict.height_px = reader.value<int>();
  verdict.metadata = read_photo_metadata(reader);
  verdict.content = reader.value<ContentHash>();
  return verdict;
}

// A count larger than the bytes that are left could make would only fail later, and slower.
std::size_t read_count(BinaryReader& reader) {
  const auto count = reader.value<std::uint64_t>();
  if (count > 1'000'000) throw Error("stored result has an impossible count");
  return std::size_t(count);
}

}  // namespace

void write(BinaryWriter& writer, const Photos& photos) {
  writer.value(std::uint64_t(photos.size()));
  for (const Photo& photo : photos) {
    writer.text(photo.name);
    write(writer, photo.camera);
    write(writer, photo.original_camera);
    write(writer, photo.srgb);
  }
}

Photos read_photos(BinaryReader& reader) {
  Photos photos;
  for (std::size_t left = read_count(reader); left > 0; --left) {
    Photo photo;
    photo.name = reader.text();
    photo.camera = read_camera(reader);
    photo.original_camera = read_camera(reader);
    photo.srgb = read_image<glm::vec3>(reader);
    photos.push_back(std::move(photo));
  }
  return photos;
}

void write(BinaryWriter& writer, const PhotoImport& import) {
  write(writer, import.photos);
  for (const Image<glm::vec4>& rgba : import.rgba) write(writer, rgba);
  writer.value(std::uint64_t(import.verdicts.size()));
  for (const PhotoVerdict& verdict : import.verdicts) write(writer, verdict);
}

PhotoImport read_photo_import(BinaryReader& reader) {
  PhotoImport import;
  import.photos = read_photos(reader);
  for (std::size_t i = 0; i < import.photos.size(); ++i) {
    import.rgba.push_back(read_image<glm::vec4>(reader));
  }
  for (std::size_t left = read_count(reader); left > 0; --left) {
    import.verdicts.push_back(read_verdict(reader));
  }
  return import;
}

}  // namespace bosk
