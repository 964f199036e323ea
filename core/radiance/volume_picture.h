#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/image/image.h"
#include "core/photo/camera.h"
#include "core/radiance/volume_snapshot.h"

namespace bosk {

// The volume seen by a pinhole camera of any size, drawn `width_px` x `height_px` large on all
// cores: straight sRGB-encoded colour and alpha. By the emission-absorption sum of the radiance
// stage, with steps of one cell; light below 1/200 is not followed.
Image<glm::u8vec4> volume_picture(const VolumeSnapshot& volume, const Camera& pinhole, int width_px,
                                  int height_px);

// A camera that looks at the centre of the volume's bounds from `distance` longest edges of them
// away, +z up. `elevation` within +-pi/2; `view` is the angle across the picture's shorter edge.
Camera orbit_camera(const VolumeSnapshot& volume, double azimuth, double elevation, double distance,
                    int width_px, int height_px, double view = 0.7);

// A cut through the volume's bounds across `axis` (0 x, 1 y, 2 z) at `position` of them, 0 to 1: a
// square as large as their longest edge, around their centre. Upwards is +z (+y in cuts across z),
// to the right +x (+y in cuts across x). In the calling thread, 1 ms for 192 x 192.
enum class SliceLook {
  extinction,  // opaque: from black, none, over purple and orange to white, light stopped by a cell
  colour,      // the cells' colour, its alpha that of one cell's edge
};
Image<glm::u8vec4> slice_picture(const VolumeSnapshot& volume, int axis, double position,
                                 int size_px, SliceLook look);

}  // namespace bosk
