#pragma once

#include <gtest/gtest.h>

#include "core/phantom/phantom.h"
#include "tests/base/scratch_folder.h"

namespace bosk {

// A tiny capture in *scratch / "capture", made once for a suite: photos 000 to 005, mattes,
// strokes, cameras.
class TinyCaptureTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch = new ScratchFolder;
    PhantomOptions options = tiny_phantom();
    options.photos = 6;
    Progress progress;
    write_phantom(*scratch / "capture", make_phantom(options, progress), progress);
  }
  static void TearDownTestSuite() { delete scratch; }

  inline static ScratchFolder* scratch = nullptr;
};

}  // namespace bosk
