// phantom_benchmark DIR [option=value ...]: makes and writes a phantom, prints where the time went.
#include <chrono>
#include <cstdio>
#include <string>

#include "core/phantom/phantom.h"

namespace {

bosk::PhantomOptions options_from(int argc, char** argv) {
  bosk::PhantomOptions options;
  for (int i = 2; i < argc; ++i) {
    const std::string text = argv[i];
    const auto equals = text.find('=');
    if (text == "tiny") options = bosk::tiny_phantom();
    if (equals == std::string::npos) continue;
    for (const bosk::Option& option : bosk::describe(options)) {
      if (option.name == text.substr(0, equals)) bosk::set_value(option, text.substr(equals + 1));
    }
  }
  return options;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  bosk::Progress progress;
  const auto start = std::chrono::steady_clock::now();
  const bosk::Phantom phantom = bosk::make_phantom(options_from(argc, argv), progress);
  std::printf("made in %.2f s, %zu leaves\n", seconds_since(start), phantom.leaves);
  const auto written = std::chrono::steady_clock::now();
  bosk::write_phantom(argv[1], phantom, progress);
  std::printf("written in %.2f s\n", seconds_since(written));
}
