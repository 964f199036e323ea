#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/phantom/phantom.h"
#include "core/project/new_project.h"
#include "tests/base/scratch_folder.h"
#include "tests/ui/workstation/hand.h"

namespace bosk {

// A project with photos, cameras and mattes of a tiny tree, in FOLDER/oak; its capture lies beside
// it. Opacity has four passes and radiance five, so that a run is done in seconds.
inline std::filesystem::path make_phantom_project(const std::filesystem::path& folder) {
  PhantomOptions options = tiny_phantom();
  options.photos = 6;
  Progress progress;
  write_phantom(folder / "capture", make_phantom(options, progress), progress);
  Recipe recipe;
  recipe.opacity.finest_level = 6;
  recipe.opacity.passes = 2;
  recipe.radiance.finer_levels = 0;
  save_project(make_project({folder / "oak",
                             {folder / "capture" / "photos"},
                             folder / "capture" / "transforms.json",
                             folder / "capture" / "mattes",
                             {}},
                            recipe, true, Progress()));
  return folder / "oak";
}

// A hand in one step of such a project, of its own for each test; the capture is made once.
class PhantomStep : public testing::Test {
 protected:
  explicit PhantomStep(const std::string& step) {
    const std::filesystem::path folder = scratch() / std::to_string(++copies());
    std::filesystem::copy(scratch() / "oak", folder, std::filesystem::copy_options::recursive);
    open_project(hand.workspace(), folder);
    hand.frame();
    hand.click("step/" + step);
    hand.settle();
  }

  static std::filesystem::path scratch() {
    static const ScratchFolder folder;
    static const bool made = !make_phantom_project(folder.path()).empty();
    (void)made;
    return folder.path();
  }

  Hand hand;

 private:
  static int& copies() {
    static int count = 0;
    return count;
  }
};

}  // namespace bosk
