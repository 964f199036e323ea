#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/photo/camera.h"

namespace bosk {

// What a camera file says. The three lists run in parallel.
struct CameraFile {
  std::vector<Camera> cameras;  // at least one; names are all different
  // The photo of each camera: in transforms.json, joined with its folder and, where the file leaves
  // the ending out, completed from what lies there; in COLMAP's model, as listed, relative to a
  // folder of photos that the model doesn't name; empty in a .cameramodel.
  std::vector<std::filesystem::path> images;
  std::vector<std::filesystem::path>
      masks;  // transforms.json's mask_path, joined likewise; else empty
};

// Width and height of a photo that the file lists, none when it can't be found. Asked only where a
// transforms.json has no w and h (NeRF's own).
using ImageSizeLookup =
    std::function<std::optional<glm::ivec2>(const std::filesystem::path& image)>;

// Reads a COLMAP model (a folder with cameras.txt and images.txt or cameras.bin and images.bin, or
// one of these files), a transforms.json (or the folder it lies in), a .cameramodel or a folder of
// them; of a folder also sparse/0, sparse and colmap/sparse/0 below it. The format is recognised.
// Throws Error, naming file, line or key and the remedy.
CameraFile read_camera_file(const std::filesystem::path& file_or_folder,
                            const ImageSizeLookup& size_of_image = {});
std::vector<Camera> read_cameras(const std::filesystem::path& file_or_folder,
                                 const ImageSizeLookup& size_of_image = {});

// "colmap" (text), "colmap-binary", "transforms", "cameramodel".
std::vector<std::string> camera_format_names();

// Writes the cameras so that read_cameras gives them back (pixels agree to 1e-6). `path` is a
// folder, made when missing; a path that ends in .json or .cameramodel is the file itself.
// `images`, as many as cameras or none, are the photo paths to list; without them NAME.png, as
// rendered views are called. Throws Error for an unknown format (listing the known), for a lens
// that the format can't hold (fisheye in .cameramodel) and for names that are no file names or not
// all different.
void write_cameras(std::span<const Camera> cameras, std::string_view format,
                   const std::filesystem::path& path,
                   std::span<const std::filesystem::path> images = {});

}  // namespace bosk
