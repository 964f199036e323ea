#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace bosk {

// Where colours are compared. Log chroma is CIELab whose chroma C is replaced by ln(1 + 0.045 C) /
// 0.045: a Euclidean stand-in for CIE94, which finds differences between vivid colours smaller than
// CIELab does.
enum class ColourSpace { lab, lab_log_chroma, srgb };

using BlockColours = std::array<glm::u8vec3, 16>;

// The 16 texels' coordinates, [texel][channel], about a fixed mid-grey. Encoded sRGB is scaled to
// 0..100. Differs from core/image/colour.h by at most 0.001 in L*, a*, b*: cube roots and
// logarithms are approximated in a form that compilers vectorise.
void write_coordinates(const BlockColours& srgb, ColourSpace space,
                       std::array<float, 48>& coordinates);

}  // namespace bosk
