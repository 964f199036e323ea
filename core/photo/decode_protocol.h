#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/photo/decode.h"

namespace bosk {

// Between decode.cpp (parent) and decode_child.cpp (child) only. The child's arguments are
// [PATH, FORMAT NUMBER, MAX PIXELS]; its result is [pixels][header][8 bytes: size of the header],
// the header last so that the parent needn't copy the pixels.
inline constexpr const char* kDecodeMode = "--decode-photo";

std::vector<std::byte> decode_in_this_process(const std::vector<std::string>& arguments);

// Written by the child about its DecodedPhoto, all but the pixels; appended to them.
void append_header(const DecodedPhoto& photo, std::vector<std::byte>& pixels);
// Checks every number: the child has read a stranger's file and may have gone wrong. Throws Error.
DecodedPhoto decoded_photo(std::vector<std::byte> message, const DecodeLimits& limits);

std::size_t bytes_per_value(PixelKind kind);

}  // namespace bosk
