// write_sample_package FILE.bosk: a made-up tree, for the program in example/.

#include "core/base/progress.h"
#include "core/package/writer.h"
#include "tests/package/sample_tree.h"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  bosk::Progress quiet;
  bosk::SampleTreeOptions options;
  options.levels = {3, 4};
  bosk::write_package(arguments[1], bosk::sample_tree(options), quiet);
  return 0;
}
