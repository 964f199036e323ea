#pragma once

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <vector>

#include "core/phantom/phantom.h"
#include "core/project/new_project.h"
#include "core/project/run.h"
#include "tests/base/scratch_folder.h"
#include "tests/ui/workstation/hand.h"

namespace bosk {

// The file again with EXIF's orientation in it; the pixels stay as they are.
inline void set_orientation(const std::filesystem::path& jpeg, int orientation) {
  const auto input = OIIO::ImageInput::open(jpeg.string());
  OIIO::ImageSpec spec = input->spec();
  std::vector<unsigned char> pixels(std::size_t(spec.image_pixels()) * std::size_t(spec.nchannels));
  input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data());
  input->close();
  spec.attribute("Orientation", orientation);
  spec.attribute("Compression", "jpeg:95");
  const auto output = OIIO::ImageOutput::create(jpeg.string());
  output->open(jpeg.string(), spec);
  output->write_image(OIIO::TypeDesc::UINT8, pixels.data());
  output->close();
}

// In FOLDER/oak: photos 000 to 005 and cameras of a tiny tree, neither mattes nor strokes. Photo
// 001 was taken with the camera turned: EXIF orientation 6.
inline std::filesystem::path make_matte_project(const std::filesystem::path& folder) {
  PhantomOptions options = tiny_phantom();
  options.photos = 6;
  Progress progress;
  write_phantom(folder / "capture", make_phantom(options, progress), progress);
  set_orientation(folder / "capture" / "photos" / "001.jpg", 6);
  save_project(make_project({folder / "oak",
                             {folder / "capture" / "photos"},
                             folder / "capture" / "transforms.json",
                             {},
                             {}},
                            Recipe(), true, Progress()));
  return folder / "oak";
}

// The same in another folder, with the photos read already: made once for all tests.
inline void copy_matte_project(const std::filesystem::path& to) {
  static const ScratchFolder made;
  static const bool ready = [] {
    const Project project = read_project(make_matte_project(made.path()));
    Progress progress;
    run_stages(project, gather_capture(project), {"photo"}, progress);
    return true;
  }();
  if (ready) std::filesystem::copy(made.path(), to, std::filesystem::copy_options::recursive);
}

}  // namespace bosk
