// Links the runtime and nothing else of Bosk's: what a game does. Its CMake target is the test.

#include <cstdio>
#include <exception>
#include <span>
#include <string>

#include "core/package/reader.h"

int main() {
  const std::string nonsense = "no package";
  try {
    bosk::read_tree(std::as_bytes(std::span(nonsense)), "nonsense");
  } catch (const std::exception& error) {
    std::puts(error.what());
    return 0;
  }
  return 1;
}
