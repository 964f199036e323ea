// Time and error of mattes together.
//
//   matte_benchmark PHOTOS STROKES TRUTH [OUT] [--cameras=FILE] [--matte.option=value ...]
//
// STROKES is a folder, or none: then they are guessed. Folders of images that match by name without
// ending. TRUTH holds one channel or RGBA. Photos without strokes are matted from those that have
// some. Prints CPU and wall seconds per megapixel and, per photo, SAD per megapixel / 1000, MSE *
// 1000 and mean (alpha - truth). With OUT, writes RGBA PNGs there.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/matte/first_guess.h"
#include "core/matte/matte.h"
#include "matte_folders.h"

namespace {

namespace fs = std::filesystem;
using namespace bosk;

struct Score {
  double sad = 0.0, mse = 0.0, bias = 0.0;
};

Score score(const Matte& matte, const fs::path& truth_path) {
  const Image<float> truth = read_alpha(truth_path);
  Score sum;
  for (std::size_t i = 0; i < matte.rgba.size(); ++i) {
    const double error = matte.rgba.data()[i].a - truth.data()[i];
    sum.sad += std::abs(error);
    sum.mse += error * error;
    sum.bias += error;
  }
  const double pixels = double(matte.rgba.size());
  return {1000.0 * sum.sad / pixels, 1000.0 * sum.mse / pixels, sum.bias / pixels};
}

void run(const std::vector<std::string>& folders, const std::string& cameras_path,
         const MatteOptions& options) {
  const Photos photos = read_photos(folders[0], cameras_path);
  Progress quiet;
  const Scribbles scribbles =
      folders[1] == "none" ? guess_strokes(photos, quiet) : read_scribbles(folders[1]);
  double megapixels = 0.0;
  for (const Photo& photo : photos) megapixels += double(photo.srgb.size()) / 1e6;
  Progress progress(
      {}, [](const std::string& sentence) { std::printf("warning: %s\n", sentence.c_str()); });
  const std::clock_t cpu = std::clock();
  const auto start = std::chrono::steady_clock::now();
  const Mattes mattes = matte_photos(photos, scribbles, options, progress);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  std::printf("%zu photos, %.2f MP: CPU %.2f s/MP, wall %.2f s/MP\n", photos.size(), megapixels,
              double(std::clock() - cpu) / CLOCKS_PER_SEC / megapixels, wall.count() / megapixels);
  const auto truths = files_by_name(folders[2]);
  Score mean;
  double scored = 0.0;
  for (const Matte& matte : mattes) {
    if (folders.size() > 3)
      write_png(fs::path(folders[3]) / (matte.name + ".png"), rgba8_from_straight(matte.rgba));
    if (!truths.contains(matte.name)) continue;
    const Score s = score(matte, truths.at(matte.name));
    std::printf("%-12s sad %8.2f  mse %8.2f  bias %+.4f\n", matte.name.c_str(), s.sad, s.mse,
                s.bias);
    mean = {mean.sad + s.sad, mean.mse + s.mse, mean.bias + s.bias};
    scored += 1.0;
  }
  if (scored > 0.0) {
    std::printf("%-12s sad %8.2f  mse %8.2f  bias %+.4f\n", "mean", mean.sad / scored,
                mean.mse / scored, mean.bias / scored);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto [folders, cameras, options] = matte_arguments(argc, argv);
    if (folders.size() < 3)
      throw Error(
          "usage: matte_benchmark PHOTOS STROKES TRUTH [OUT] [--cameras=FILE] "
          "[--matte.option=value ...]");
    run(folders, cameras, options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "matte_benchmark: %s\n", error.what());
    return 1;
  }
  return 0;
}
