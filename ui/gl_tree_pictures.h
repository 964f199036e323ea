#pragma once

#include <string>

#include "ui/workstation/preview/tree_pictures.h"

namespace bosk {

// Pictures drawn in the OpenGL context that is current whenever it is used, its last copy's end
// included. `driver` is told in the figures.
TreePictures gl_tree_pictures(const std::string& driver);

}  // namespace bosk
