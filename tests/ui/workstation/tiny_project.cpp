#include "tests/ui/workstation/tiny_project.h"

#include "core/phantom/phantom.h"
#include "core/project/new_project.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

const fs::path& first_capture() {
  static const ScratchFolder scratch;
  static const fs::path folder = [] {
    Progress quiet;
    write_phantom(scratch.path() / "capture", make_phantom(tiny_capture(), quiet), quiet);
    return scratch.path() / "capture";
  }();
  return folder;
}

}  // namespace

PhantomOptions tiny_capture() {
  PhantomOptions options = tiny_phantom();
  options.preset = "sparse";
  options.photos = 8;
  options.width_px = 64;
  options.height_px = 80;
  options.density_side = 16;
  options.markers = 0;
  options.samples = 4;
  return options;
}

void write_tiny_capture(const fs::path& folder) {
  fs::create_directories(folder.parent_path());
  fs::copy(first_capture(), folder, fs::copy_options::recursive);
}

Recipe tiny_recipe() {
  Recipe recipe;
  set_option(recipe, "opacity.finest_level", "5");
  set_option(recipe, "compress.colour_codewords", "64");
  set_option(recipe, "compress.alpha_codewords", "64");
  return recipe;
}

Project make_tiny_project(const fs::path& folder, TinyStart start) {
  write_tiny_capture(folder / "capture");
  NewProject wanted;
  wanted.folder = folder / "tree";
  wanted.photos = {folder / "capture" / "photos"};
  wanted.cameras = folder / "capture" / "transforms.json";
  if (start == TinyStart::mattes) wanted.mattes = folder / "capture" / "mattes";
  if (start == TinyStart::scribbles) wanted.scribbles = folder / "capture" / "scribbles";
  return make_project(wanted, tiny_recipe(), false, Progress());
}

}  // namespace bosk
