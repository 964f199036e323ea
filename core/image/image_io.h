#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "core/image/image.h"

namespace bosk {

// PNG, 8 bit per channel, sRGB-encoded; alpha is straight. The file is replaced atomically. Error
// when the image is empty or the file cannot be written.
void write_png(const std::filesystem::path& path, const Image<glm::u8vec4>& rgba);
void write_png(const std::filesystem::path& path, const Image<glm::u8vec3>& rgb);
void write_png(const std::filesystem::path& path, const Image<std::uint8_t>& grey);

// A JPEG file's bytes, sRGB, colour at full resolution. `quality`: 1 to 100. Error when the image
// is empty.
std::vector<std::byte> jpeg_bytes(const Image<glm::u8vec3>& rgb, int quality);
// A PNG file's bytes, as write_png.
std::vector<std::byte> png_bytes(const Image<glm::u8vec3>& rgb);

// 0 to 1 becomes 0 to 255, to the nearest; values outside are clamped, NaN becomes 0.
std::uint8_t byte_from_unit(float value);
Image<glm::u8vec4> rgba8_from_straight(const Image<glm::vec4>& straight);
Image<glm::u8vec3> rgb8_from_srgb(const Image<glm::vec3>& srgb);
Image<std::uint8_t> grey8_from_unit(const Image<float>& grey);

// What a viewer would show over one colour: blended in the encoded values, as published figures
// are.
Image<glm::vec3> over_colour(const Image<glm::vec4>& straight, const glm::vec3& background_srgb);

}  // namespace bosk
