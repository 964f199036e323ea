#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace bosk {

// The formats that photos may come in; nothing else is handed to a decoder.
enum class PhotoFormat { jpeg, png, tiff, openexr, raw, heif };

// "JPEG", "camera raw", ...: for sentences.
std::string name_of(PhotoFormat format);

// What the first bytes of a file (64 suffice) say that it is; none for anything else. The ending,
// ".NEF" say, only tells a camera raw file from the TIFF that it looks like.
std::optional<PhotoFormat> photo_format(std::span<const std::byte> first_bytes,
                                        const std::string& ending);

// Whether the ending is one that such files usually have.
bool is_usual_ending(PhotoFormat format, const std::string& ending);
// The same of any of the formats.
bool has_photo_ending(const std::filesystem::path& path);

}  // namespace bosk
