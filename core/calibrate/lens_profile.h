#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/image/image.h"
#include "core/photo/camera.h"
#include "core/photo/decode.h"

namespace bosk {

// What a photo was taken with, as EXIF says: a lens profile is good for photos of the same camera
// at the same focal length. Empty or none where EXIF is silent.
struct LensIdentity {
  std::string make, model;
  std::optional<double> focal_mm;

  bool operator==(const LensIdentity&) const = default;
};
LensIdentity identity_of(const PhotoMetadata& metadata);
// "Canon EOS R5 at 35 mm"; "a camera that EXIF doesn't name".
std::string identity_text(const LensIdentity& identity);

// A calibrated lens, kept for later captures. Maps cover the frame: each of their pixels stands for
// an equal share of it.
struct LensProfile {
  LensIdentity taken_with;
  Lens lens;  // at the size of the photos it was calibrated with
  double rms_px = 0.0;
  int boards = 0, corners = 0;
  Image<float> coverage;        // corners used in each cell
  Image<float> uncertainty_px;  // one sigma of the projection at each cell's centre
};

// JSON, replaced atomically. Throws Error where it can't be written.
void save_lens_profile(const std::filesystem::path& path, const LensProfile& profile);
// Throws Error that names file, key and remedy for all that is no such profile.
LensProfile read_lens_profile(const std::filesystem::path& path);

// The profile's lens for a photo of `width_px` x `height_px`: scaled where the photo has another
// size of the same shape (half a pixel of rounding allowed). Throws Error, in words, when the photo
// has another shape (cropped or turned), or names another camera or a focal length that differs by
// over 1 %; a photo or profile whose EXIF is silent on one of these passes it.
Lens lens_for_photo(const LensProfile& profile, const LensIdentity& photo_taken_with, int width_px,
                    int height_px);

}  // namespace bosk
