#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace bosk {

// Which way is up, of unit length in the camera's axes (x right, y down, z forward, of the pixels
// as stored), where a phone's accelerometer wrote it into a JPEG: Apple's maker note, tag 8. None
// for other files, front cameras, and a phone that was shaken.
std::optional<glm::dvec3> up_from_maker_note(const std::string& path);

// From what such a note says: gravity in units of g, in the phone's own axes held upright (x to its
// right edge, y to its top, z out of the screen; Core Motion's). The sensor's rows run along the
// phone, so that an unturned photo is one taken with its top to the left. None where the length is
// not within a tenth of 1 g.
std::optional<glm::dvec3> up_from_phone_gravity(const glm::dvec3& gravity_in_phone);

}  // namespace bosk
