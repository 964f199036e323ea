#include <gtest/gtest.h>

#include "core/photo/child_mode.h"

// main() of every test program that reads photos: the program decodes them as a child of itself.
int main(int argc, char** argv) {
  if (const auto status = bosk::run_child_mode(argc, argv)) return *status;
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
