#include "core/photo/decode.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <span>

#include "core/base/file_descriptor.h"
#include "core/base/system_error.h"
#include "core/photo/decode_protocol.h"
#include "core/photo/pixel_source.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

std::string shown(const fs::path& path) { return printable(path.filename().string()); }

// The format by the first bytes; a folder, FIFO or device is refused before anything is read.
PhotoFormat format_of(const fs::path& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file) throw system_error(path, "read", errno);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw system_error(path, "read", errno);
  if (S_ISDIR(status.st_mode)) throw Error(shown(path) + ": is a folder; give the photos in it");
  if (!S_ISREG(status.st_mode)) throw Error(shown(path) + ": is no regular file; give a photo");
  if (status.st_size == 0) throw Error(shown(path) + ": is empty; copy it again from the camera");
  std::array<std::byte, 64> head{};
  const ssize_t got = ::read(file.get(), head.data(), head.size());
  if (got < 0) throw system_error(path, "read", errno);
  const auto format =
      photo_format(std::span(head).first(std::size_t(got)), path.extension().string());
  if (!format) {
    throw Error(shown(path) +
                ": is no JPEG, PNG, TIFF, OpenEXR, camera raw or HEIF file; convert it to one");
  }
  return *format;
}

Error damaged(const fs::path& path, const ChildOutcome& outcome) {
  if (outcome.end == ChildEnd::refused) {
    return Error(shown(path) + ": cannot be decoded: " + outcome.reason);
  }
  return Error(shown(path) + ": this photo is damaged (the decoder stopped: " + outcome.reason +
               "); copy it again from the camera or leave it out");
}

bool is_grey(const glm::vec4& pixel) { return pixel.r == pixel.g && pixel.g == pixel.b; }

}  // namespace

PhotoDecoder::PhotoDecoder(const DecodeLimits& limits) : limits_(limits), child_(kDecodeMode) {}

DecodedPhoto PhotoDecoder::decode(const fs::path& path, const Progress& progress) {
  const PhotoFormat format = format_of(path);
  const std::vector<std::string> arguments{
      fs::absolute(path).string(), std::to_string(int(format)),
      std::to_string(std::llround(1e6 * limits_.max_megapixels))};
  ChildOutcome outcome = child_.run(arguments, limits_.child, progress);
  if (outcome.end != ChildEnd::result) throw damaged(path, outcome);
  try {
    DecodedPhoto photo = decoded_photo(std::move(outcome.result), limits_);
    photo.format = format;
    if (!is_usual_ending(format, path.extension().string())) {
      photo.notes.push_back("it is a " + name_of(format) + " file whatever its ending says");
    }
    return photo;
  } catch (const Error& error) {
    throw Error(shown(path) + ": this photo is damaged (" + error.what() + ")");
  }
}

std::optional<glm::ivec2> PhotoDecoder::size(const fs::path& path, const Progress& progress) {
  try {
    const DecodedPhoto photo = decode(path, progress);
    return glm::ivec2(photo.width_px, photo.height_px);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    return std::nullopt;
  }
}

Image<glm::vec4> straight_of(const DecodedPhoto& photo) {
  Image<glm::vec4> straight(photo.width_px, photo.height_px);
  visit_pixels(photo, [&](const auto& source) {
    for (int y = 0; y < photo.height_px; ++y) {
      for (int x = 0; x < photo.width_px; ++x) straight(x, y) = source.straight_srgb(x, y);
    }
  });
  return straight;
}

Image<glm::vec3> srgb_of(const DecodedPhoto& photo) {
  Image<glm::vec3> srgb(photo.width_px, photo.height_px);
  visit_pixels(photo, [&](const auto& source) {
    for (int y = 0; y < photo.height_px; ++y) {
      for (int x = 0; x < photo.width_px; ++x) srgb(x, y) = glm::vec3(source.straight_srgb(x, y));
    }
  });
  return srgb;
}

DecodedMatte PhotoDecoder::decode_matte(const fs::path& path, const Progress& progress) {
  const DecodedPhoto file = decode(path, progress);
  DecodedMatte matte{straight_of(file), file.has_alpha()};
  if (file.has_alpha()) return matte;
  auto& pixels = matte.rgba.pixels();
  if (file.channels == 3 && !std::all_of(pixels.begin(), pixels.end(), is_grey)) {
    throw Error(shown(path) + ": has colour but no alpha; give RGBA with straight alpha, or grey");
  }
  const bool linear = file.kind == PixelKind::f32_linear;
  for (glm::vec4& pixel : pixels) {
    // straight_srgb has put linear numbers through the sRGB curve, which is wrong for an opacity
    pixel = {0.0f, 0.0f, 0.0f, linear ? linear_from_srgb(pixel.r) : pixel.r};
  }
  return matte;
}

DecodedPhoto decode_photo(const fs::path& path, const DecodeLimits& limits,
                          const Progress& progress) {
  return PhotoDecoder(limits).decode(path, progress);
}

DecodedMatte decode_matte(const fs::path& path, const DecodeLimits& limits,
                          const Progress& progress) {
  return PhotoDecoder(limits).decode_matte(path, progress);
}

}  // namespace bosk
