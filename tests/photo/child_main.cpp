#include <gtest/gtest.h>

#include "core/photo/child_mode.h"

// The packaged HEIF encoder, which only the tests use, leaks a kilobyte; the leak sanitizer asks
// here.
extern "C" const char* __lsan_default_suppressions() { return "leak:libx265\n"; }

// main() of every test program that reads photos: the program decodes them as a child of itself.
int main(int argc, char** argv) {
  if (const auto status = bosk::run_child_mode(argc, argv)) return *status;
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
