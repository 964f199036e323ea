#pragma once

#include <glm/glm.hpp>
#include <string>

namespace bosk {

// The colour that a point is drawn in, sRGB from 0 to 1: the one that its name tells ("light blue",
// "red foot"), else one of a fixed palette, the same for the same name.
glm::vec3 colour_of_point(const std::string& name);

}  // namespace bosk
