// sample_package FILE: writes the package of a small made-up tree.

#include <cstdio>

#include "core/base/progress.h"
#include "core/package/writer.h"
#include "tests/package/sample_tree.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: sample_package FILE\n", stderr);
    return 2;
  }
  bosk::Progress quiet;
  bosk::TreeModel tree = bosk::sample_tree({.levels = {2, 3, 4}});
  tree.metadata.height_m = tree.origin.z + tree.size_m;
  bosk::write_package(argv[1], tree, quiet);
}
