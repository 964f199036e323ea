#pragma once

#include "ui/widgets/pictures.h"

namespace bosk {

// Textures of the OpenGL context that is current whenever the device is used: linear filtering,
// with the nearest texel when enlarged. What the driver cannot hold is shown as nothing.
PictureDevice gl_picture_device();

}  // namespace bosk
