#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/phantom/phantom.h"
#include "tests/base/scratch_folder.h"
#include "tests/ui/workstation/hand.h"

namespace bosk {

// A phantom of ten small photos with their cameras, laid out in a folder of its own.
struct SmallCapture {
  SmallCapture() {
    PhantomOptions options = tiny_phantom();
    options.samples = 2;  // coarse: only names, sizes and places count here
    options.distortion = 0.0;
    Progress quiet;
    write_phantom(scratch / "phantom", make_phantom(options, quiet), quiet);
  }
  std::filesystem::path photos() const { return scratch / "phantom" / "photos"; }
  std::filesystem::path photo(const std::string& name) const { return photos() / (name + ".jpg"); }
  std::filesystem::path cameras() const { return scratch / "phantom" / "transforms.json"; }

  const ScratchFolder scratch;
};

// A file that begins like a JPEG and is none.
inline std::filesystem::path write_broken_photo(const std::filesystem::path& path) {
  std::ofstream(path) << "\xff\xd8\xff and no more";
  return path;
}

inline void make_project_by_hand(Hand& hand, const std::filesystem::path& folder) {
  hand.click("start/folder");
  hand.type(folder.string());
  hand.click("start/make");
}

// A hand in a new project beside such a capture, still without photos.
class SmallCaptureStep : public testing::Test {
 protected:
  SmallCaptureStep() { make_project_by_hand(hand, capture.scratch / "oak"); }

  Workspace& workspace() { return hand.workspace(); }
  static void expect_told(const Notices& notices, const std::string& words) {
    using testing::Contains, testing::Field, testing::HasSubstr;
    EXPECT_THAT(notices, Contains(Field(&Notice::text, HasSubstr(words))));
  }

  const SmallCapture capture;
  Hand hand;
};

}  // namespace bosk
