#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/binary.h"
#include "core/base/child_process.h"
#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/photo/photo_format.h"

namespace bosk {

// What one photo may cost. The defaults hold a 150 megapixel photo of 16 bits with alpha.
struct DecodeLimits {
  double max_megapixels = 150.0;
  ChildLimits child;
};

// What the camera wrote beside the pixels; none where it wrote nothing or nonsense.
struct PhotoMetadata {
  std::optional<double> focal_mm, focal_35mm_equivalent_mm;
  std::optional<double> exposure_s, iso, f_number;
  int orientation = 1;  // EXIF, 1 to 8: how to turn the pixels for display; they come unturned
  std::optional<glm::dvec3> up_in_camera;  // of unit length, by a phone's accelerometer (gravity.h)
  std::string make, model;
};

void write(BinaryWriter& writer, const PhotoMetadata& metadata);
PhotoMetadata read_photo_metadata(BinaryReader& reader);  // numbers and texts come out plausible

enum class PixelKind : std::uint8_t { u8_srgb, u16_srgb, f32_linear };

// Pixels as the sensor delivered them (a HEIF decoder alone turns them by itself), in the precision
// of the file: rows from the top, channels interleaved, host byte order, alpha straight.
struct DecodedPhoto {
  PhotoFormat format = PhotoFormat::jpeg;
  int width_px = 0, height_px = 0;
  int channels = 3;  // 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha
  PixelKind kind = PixelKind::u8_srgb;
  std::vector<std::byte> pixels;
  PhotoMetadata metadata;
  std::vector<std::string> notes;  // clauses about what was odd but was read all the same

  bool has_alpha() const { return channels == 2 || channels == 4; }
};

// A matte: alpha from the file's alpha channel, or from its only channel.
struct DecodedMatte {
  Image<glm::vec4> rgba;    // straight, sRGB-encoded
  bool has_colour = false;  // false: the file had one channel, and rgb is 0
};

// Reads photos in a child process that stays between them: whatever is in a file, this process
// lives on, and no photo sees another's remains. The content, not the ending, decides the format;
// only those of PhotoFormat are read. For one thread at a time.
class PhotoDecoder {
 public:
  explicit PhotoDecoder(const DecodeLimits& limits = {});

  // Throws Error (bad_input), naming the file and the reason, for all that is no photo; Cancelled.
  DecodedPhoto decode(const std::filesystem::path& path, const Progress& progress);
  // The same. RGB without alpha counts as one channel when it is grey, and is refused otherwise.
  DecodedMatte decode_matte(const std::filesystem::path& path, const Progress& progress);
  // Width and height; none where decode would refuse. Decodes the whole photo: for the few camera
  // files that leave the size out.
  std::optional<glm::ivec2> size(const std::filesystem::path& path, const Progress& progress);

 private:
  DecodeLimits limits_;
  ChildServer child_;
};

// For one photo; for several, a PhotoDecoder saves starting a child for each (0.2 s of CPU time).
DecodedPhoto decode_photo(const std::filesystem::path& path, const DecodeLimits& limits,
                          const Progress& progress);
DecodedMatte decode_matte(const std::filesystem::path& path, const DecodeLimits& limits,
                          const Progress& progress);

// Colour 0 to 1, sRGB-encoded; NaN is 0, and linear light beyond 0 to 1 is clamped.
Image<glm::vec3> srgb_of(const DecodedPhoto& photo);
// The same with straight alpha, 1 where the photo has none.
Image<glm::vec4> straight_of(const DecodedPhoto& photo);

}  // namespace bosk
