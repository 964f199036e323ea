#include "core/image/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/system_error.h"

namespace bosk {
namespace {

// Encodes into memory, so that only whole, checked files reach the disk. `format`: png, jpg.
std::vector<unsigned char> encoded(const std::string& format, const OIIO::ImageSpec& spec,
                                   const void* pixels) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput sink(bytes);
  auto output = OIIO::ImageOutput::create(format, &sink);
  if (!output) {
    throw Error(format +
                " files cannot be written: OpenImageIO has no support for them: install it");
  }
  output->threads(1);
  if (!output->open("image." + format, spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, pixels) || !output->close()) {
    throw Error(format + " encoding failed: " + output->geterror(), ErrorKind::resource);
  }
  return bytes;
}

OIIO::ImageSpec srgb_spec(int width, int height, int channels) {
  OIIO::ImageSpec spec(width, height, channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  return spec;
}

std::vector<unsigned char> png_bytes(const void* pixels, int width, int height, int channels) {
  OIIO::ImageSpec spec = srgb_spec(width, height, channels);
  spec.attribute("oiio:UnassociatedAlpha", 1);  // else OpenImageIO would divide colour by alpha
  return encoded("png", spec, pixels);
}

void require_pixels(const Image<glm::u8vec3>& rgb) {
  if (rgb.empty()) throw Error("an image without pixels cannot be written");
}

std::vector<std::byte> as_bytes(const std::vector<unsigned char>& bytes) {
  const auto view = std::as_bytes(std::span(bytes));
  return {view.begin(), view.end()};
}

void write_png(const std::filesystem::path& path, const void* pixels, int width, int height,
               int channels) {
  if (width < 1 || height < 1) {
    throw Error(printable(path.string()) + ": an image without pixels cannot be written");
  }
  const std::vector<unsigned char> bytes = png_bytes(pixels, width, height, channels);
  write_file_atomically(path, std::as_bytes(std::span(bytes)));
}

}  // namespace

void write_png(const std::filesystem::path& path, const Image<glm::u8vec4>& rgba) {
  write_png(path, rgba.data(), rgba.width(), rgba.height(), 4);
}

void write_png(const std::filesystem::path& path, const Image<glm::u8vec3>& rgb) {
  write_png(path, rgb.data(), rgb.width(), rgb.height(), 3);
}

void write_png(const std::filesystem::path& path, const Image<std::uint8_t>& grey) {
  write_png(path, grey.data(), grey.width(), grey.height(), 1);
}

std::vector<std::byte> jpeg_bytes(const Image<glm::u8vec3>& rgb, int quality) {
  require_pixels(rgb);
  OIIO::ImageSpec spec = srgb_spec(rgb.width(), rgb.height(), 3);
  spec.attribute("Compression", "jpeg:" + std::to_string(quality));
  spec.attribute("jpeg:subsampling", "4:4:4");
  return as_bytes(encoded("jpg", spec, rgb.data()));
}

std::vector<std::byte> png_bytes(const Image<glm::u8vec3>& rgb) {
  require_pixels(rgb);
  return as_bytes(png_bytes(rgb.data(), rgb.width(), rgb.height(), 3));
}

std::uint8_t byte_from_unit(float value) {
  if (!(value > 0.0f)) return 0;
  return static_cast<std::uint8_t>(std::floor(std::min(value, 1.0f) * 255.0f + 0.5f));
}

Image<glm::u8vec4> rgba8_from_straight(const Image<glm::vec4>& straight) {
  Image<glm::u8vec4> bytes(straight.width(), straight.height());
  std::transform(straight.pixels().begin(), straight.pixels().end(), bytes.pixels().begin(),
                 [](const glm::vec4& v) {
                   return glm::u8vec4(byte_from_unit(v.r), byte_from_unit(v.g), byte_from_unit(v.b),
                                      byte_from_unit(v.a));
                 });
  return bytes;
}

Image<glm::u8vec3> rgb8_from_srgb(const Image<glm::vec3>& srgb) {
  Image<glm::u8vec3> bytes(srgb.width(), srgb.height());
  std::transform(
      srgb.pixels().begin(), srgb.pixels().end(), bytes.pixels().begin(), [](const glm::vec3& v) {
        return glm::u8vec3(byte_from_unit(v.r), byte_from_unit(v.g), byte_from_unit(v.b));
      });
  return bytes;
}

Image<std::uint8_t> grey8_from_unit(const Image<float>& grey) {
  Image<std::uint8_t> bytes(grey.width(), grey.height());
  std::transform(grey.pixels().begin(), grey.pixels().end(), bytes.pixels().begin(),
                 byte_from_unit);
  return bytes;
}

Image<glm::vec3> over_colour(const Image<glm::vec4>& straight, const glm::vec3& background_srgb) {
  Image<glm::vec3> shown(straight.width(), straight.height());
  std::transform(straight.pixels().begin(), straight.pixels().end(), shown.pixels().begin(),
                 [&](const glm::vec4& v) { return glm::mix(background_srgb, glm::vec3(v), v.a); });
  return shown;
}

}  // namespace bosk
