#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/radiance/volume_picture.h"
#include "ui/widgets/image_view.h"
#include "ui/workstation/volume/volume_look.h"

namespace bosk {

struct Workspace;

// What a picture of the volume shows.
struct VolumeView {
  std::uint64_t look = 0;                                  // its revision
  int photo = -1;                                          // the camera; -1: the orbiting one
  double azimuth = 0.6, elevation = 0.15, distance = 1.6;  // of that; see orbit_camera
  int height_px = 0;
  bool in_motion = false;  // under the hand: coarser
  bool operator==(const VolumeView&) const = default;
};

// A picture that a worker draws, as it is now.
struct VolumePicture {
  Image<glm::u8vec4> pixels;
  std::uint64_t revision = 0;
  VolumeView shown;  // what it shows
  int job = 0;       // that draws a newer one
};

// What the step remembers between frames.
struct VolumeStepState {
  std::shared_ptr<VolumeWatch> watch;      // of the newest run; null: none since the project opened
  std::shared_ptr<const VolumeLook> look;  // that is shown; null: none yet
  std::uint64_t look_revision = 0;
  std::map<std::string, std::vector<VolumePass>> passes;  // of the newest run of each stage
  std::string stage = "radiance";  // whose result is shown while nothing is made
  // The results that `look` was asked for; null: none.
  std::shared_ptr<const void> looked_at, looked_with;
  int look_job = 0;

  glm::dvec3 cut{0.5};  // positions of the slices, 0 to 1 of the volume's bounds
  SliceLook slice_look = SliceLook::extinction;
  VolumeView orbit;
  bool orbiting = false;  // under the hand: drawn smaller
  int photo = 0;          // chosen, among the photos of the look
  VolumePicture orbit_picture, photo_picture;
  ImageView photo_view;  // of the photo and of the rendering beside it
};

void draw_volume_step(Workspace& workspace);

// Brings the look up to date with the run at work or else with the results; once a frame.
void follow_volume(Workspace& workspace);
// The slices, the orbiting view, and a photo beside the volume: volume_views.cpp.
void draw_volume_views(Workspace& workspace);

}  // namespace bosk
