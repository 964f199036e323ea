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

// A camera that looks at the volume's centre from `distance` cube edges away, +z up.
// `vertical_view` is the angle of view from the top edge to the bottom edge.
Camera orbit_camera(const VolumeSnapshot& volume, double azimuth, double elevation, double distance,
                    int width_px, int height_px, double vertical_view = 0.7);

// A cut through the volume across `axis` (0 x, 1 y, 2 z) at `position`, 0 to 1 of the cube's edge.
// Rows run down along -z (across z: along -y), columns along +y for x, along +x else.
enum class SliceLook {
  extinction,  // opaque: black for none, over blue, red and yellow to white
  colour,      // the cells' colour, its alpha that of one cell's edge
};
Image<glm::u8vec4> slice_picture(const VolumeSnapshot& volume, int axis, double position,
                                 int size_px, SliceLook look);

}  // namespace bosk
