#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace bosk {

// A name of each colour: the word nearest to it ("red", "light blue"), all different. Of two
// colours that one word fits, the nearer keeps it and the other becomes "dark ..." or "bright ...",
// then
// "... 2". `xy` of a colour is saturation, z is L*: see saturation_from_lab.
std::vector<std::string> colour_words(std::span<const glm::vec3> colours);

}  // namespace bosk
