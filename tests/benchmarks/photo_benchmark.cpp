#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/photo/child_mode.h"
#include "core/photo/import.h"
#include "tests/base/scratch_folder.h"
#include "tests/hostile_input/damaged_photos.h"
#include "tests/photo/photo_writer.h"

// How long photos take to import, and how long the slowest damaged file of the hostile-input test.
//   photo_benchmark [COUNT [MEGAPIXELS]]     default: 8 JPEGs of 24 megapixels

namespace bosk {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Waves of many sizes: about as hard to decode as a photo of leaves.
float leafy(int x, int y, int channel) {
  const double wave =
      std::sin(0.9 * x + channel) * std::sin(0.7 * y) + std::sin(0.05 * x * y / 900);
  return float(0.5 + 0.2 * wave);
}

Camera camera_of(const std::string& name, int width, int height) {
  Lens lens;
  lens.model = LensModel::opencv;
  lens.width_px = width;
  lens.height_px = height;
  lens.focal_px = glm::dvec2(width);
  lens.principal_px = 0.5 * (glm::dvec2(width, height) - 1.0);
  lens.distortion[0] = -0.1;
  return {name, lens, {}};
}

void time_import(int count, double megapixels) {
  const ScratchFolder folder;
  const int height = int(std::sqrt(megapixels * 1e6 / 1.5)), width = height * 3 / 2;
  std::vector<std::filesystem::path> files;
  std::vector<Camera> cameras;
  for (int i = 0; i < count; ++i) {
    files.push_back(folder / (std::to_string(i) + ".jpg"));
    PhotoFile file{.width = width, .height = height, .value = leafy};
    file.attributes.attribute("ImageDescription", std::to_string(i));
    if (i == 0) {
      write_photo(files[0], file);
    } else {
      // The same picture with another end, so that it isn't taken for a copy
      std::filesystem::copy_file(files[0], files.back());
      std::filesystem::resize_file(files.back(),
                                   std::filesystem::file_size(files[0]) + std::size_t(i));
    }
    cameras.push_back(camera_of(std::to_string(i), width, height));
  }
  Progress quiet;
  const auto start = Clock::now();
  const std::clock_t cpu_start = std::clock();
  const PhotoImport import = import_photos(files, cameras, {}, quiet);
  std::printf("%zu JPEGs of %d x %d to 1 megapixel, undistorted: %.2f s, %.2f s of CPU time here\n",
              import.photos.size(), width, height, seconds_since(start),
              double(std::clock() - cpu_start) / CLOCKS_PER_SEC);
}

void time_damaged_photos() {
  const ScratchFolder folder;
  const Progress quiet;
  PhotoDecoder decoder;
  double slowest_s = 0.0;
  std::string slowest;
  const std::vector<DamagedPhoto> photos = make_damaged_photos(folder.path());
  for (const DamagedPhoto& photo : photos) {
    const auto start = Clock::now();
    try {
      decoder.decode(folder / photo.name, quiet);
    } catch (const Error&) {
    }
    if (seconds_since(start) <= slowest_s) continue;
    slowest_s = seconds_since(start);
    slowest = photo.name;
  }
  std::printf("%zu damaged or odd files: the slowest, %s, took %.2f s\n", photos.size(),
              slowest.c_str(), slowest_s);
}

}  // namespace
}  // namespace bosk

int main(int argc, char** argv) {
  if (const auto status = bosk::run_child_mode(argc, argv)) return *status;
  bosk::time_import(argc > 1 ? std::stoi(argv[1]) : 8, argc > 2 ? std::stod(argv[2]) : 24.0);
  bosk::time_damaged_photos();
}
