#pragma once

// What the camera file formats share. For camera_files*.cpp alone.

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/photo/camera.h"
#include "core/photo/camera_files.h"

namespace bosk::camera_files {

// COLMAP and transforms.json count pixels from the corner of the first, Bosk from its centre.
inline glm::dvec2 centre_from_corner(const glm::dvec2& pixel) { return pixel - 0.5; }
inline glm::dvec2 corner_from_centre(const glm::dvec2& pixel) { return pixel + 0.5; }

// Throws Error "<place>: <complaint>". A place is a file, and a line, key or entry in it.
[[noreturn]] void refuse(const std::string& place, const std::string& complaint);
// The text in quotes, cut to 60 bytes, with what isn't printable ASCII as '?': it may be binary.
std::string in_quotes(std::string_view text);

// The whole text as a finite number, '.' as the decimal point whatever the locale.
double number_from(std::string_view text, const std::string& place);
std::uint64_t whole_number_from(std::string_view text, const std::string& place);
// The shortest text that reads back as the same number.
std::string text_from(double number);

std::string read_text(const std::filesystem::path& path, std::uint64_t max_bytes);

bool has_control_characters(std::string_view text);
// The file name without folder (either slash) and ending. Refuses what can't name a file.
std::string camera_name(std::string_view image, const std::string& place);
// `w` and `h` as the lens's size, refused unless 1 to 100,000.
void set_size(Lens& lens, double width_px, double height_px, const std::string& place);
// Refuses numbers that are not finite or absurd, focal lengths not above zero and sizes out of
// range.
void check(const Camera& camera, const std::string& place);
// Refuses no camera at all and two of one name.
void check_set(std::span<const Camera> cameras, const std::string& place);

// The rotation, freed from rounding; refused when it is off by more than 1e-3.
glm::dmat3 rotation_from(const glm::dmat3& matrix, const std::string& place);
glm::dmat3 rotation_from_quaternion(const glm::dvec4& wxyz, const std::string& place);

CameraFile read_colmap_text(const std::filesystem::path& folder);
CameraFile read_colmap_binary(const std::filesystem::path& folder);
CameraFile read_transforms_json(const std::filesystem::path& file, const ImageSizeLookup&);
CameraFile read_cameramodel(std::span<const std::filesystem::path> files);

// As write_cameras; cameras and names are checked already, `images` as many as cameras.
using Images = std::span<const std::filesystem::path>;
void write_colmap_text(std::span<const Camera>, const std::filesystem::path& folder, Images);
void write_colmap_binary(std::span<const Camera>, const std::filesystem::path& folder, Images);
void write_transforms_json(std::span<const Camera>, const std::filesystem::path&, Images);
void write_cameramodel(std::span<const Camera>, const std::filesystem::path&, Images);

}  // namespace bosk::camera_files
