#pragma once

#include <glm/gtc/type_precision.hpp>
#include <string>
#include <vector>

#include "core/image/image.h"

namespace bosk {

// |rendered - truth| over white, three times as strong, on black: what differs lights up in its
// colour. Same sizes.
Image<glm::u8vec3> difference_picture(const Image<glm::u8vec4>& rendered,
                                      const Image<glm::u8vec4>& truth);

struct SheetRow {
  std::string caption;  // under the row: the view's name and figures; ASCII
  Image<glm::u8vec4> truth, rendered;
};

// A picture of rows "photo | Bosk | difference" with headings, each picture cut to what either
// shows and 8 px around it, then shrunk (area means, never enlarged) to at most `cell_px` in width
// and height. Error when a row's sizes differ.
Image<glm::u8vec3> contact_sheet(const std::vector<SheetRow>& rows, int cell_px);

}  // namespace bosk
