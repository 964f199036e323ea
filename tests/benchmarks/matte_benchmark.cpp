// Time and error of mattes together.
//
//   matte_benchmark PHOTOS STROKES TRUTH [OUT] [--cameras=FILE] [--matte.option=value ...]
//
// Folders of images that match by name without ending. TRUTH holds one channel or RGBA. Photos
// without strokes are matted from those that have some. Prints CPU and wall seconds per megapixel
// and, per photo, SAD per megapixel / 1000, MSE * 1000 and mean (alpha - truth). With OUT, writes
// RGBA PNGs there.

#include <OpenImageIO/imageio.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/matte/matte.h"
#include "core/photo/camera_files.h"

namespace {

namespace fs = std::filesystem;
using namespace bosk;

struct Channels {
  int width = 0, height = 0, count = 0;
  std::vector<float> values;  // 0 to 1, interleaved
  float at(std::size_t pixel, int channel) const {
    return values[pixel * std::size_t(count) + std::size_t(channel)];
  }
};

Channels read_channels(const fs::path& path) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw Error(path.string() + ": " + OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  Channels image{spec.width, spec.height, spec.nchannels, {}};
  image.values.resize(std::size_t(spec.width) * std::size_t(spec.height) *
                      std::size_t(spec.nchannels));
  input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data());
  return image;
}

std::map<std::string, fs::path> files_by_name(const fs::path& folder) {
  std::map<std::string, fs::path> files;
  if (folder.empty()) return files;
  for (const auto& entry : fs::directory_iterator(folder))
    files[entry.path().stem().string()] = entry.path();
  return files;
}

Photo read_photo(const std::string& name, const fs::path& path) {
  const Channels channels = read_channels(path);
  Photo photo;
  photo.name = name;
  photo.srgb = Image<glm::vec3>(channels.width, channels.height);
  for (std::size_t i = 0; i < photo.srgb.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      photo.srgb.data()[i][c] = channels.at(i, channels.count >= 3 ? c : 0);
    }
  }
  photo.camera.lens.width_px = channels.width;
  photo.camera.lens.height_px = channels.height;
  photo.original_camera = photo.camera;
  return photo;
}

Image<std::uint8_t> read_strokes(const fs::path& path) {
  const Channels channels = read_channels(path);
  Image<std::uint8_t> strokes(channels.width, channels.height, kNoStroke);
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const float value = channels.at(i, 0);
    if (value < 0.1f) strokes.data()[i] = kBackgroundStroke;
    if (value > 0.9f) strokes.data()[i] = kForegroundStroke;
  }
  return strokes;
}

struct Score {
  double sad = 0.0, mse = 0.0, bias = 0.0;
};

Score score(const Matte& matte, const fs::path& truth_path) {
  const Channels truth = read_channels(truth_path);
  const int channel = truth.count == 4 ? 3 : 0;
  Score sum;
  for (std::size_t i = 0; i < matte.rgba.size(); ++i) {
    const double error = matte.rgba.data()[i].a - truth.at(i, channel);
    sum.sad += std::abs(error);
    sum.mse += error * error;
    sum.bias += error;
  }
  const double pixels = double(matte.rgba.size());
  return {1000.0 * sum.sad / pixels, 1000.0 * sum.mse / pixels, sum.bias / pixels};
}

void apply_option(MatteOptions& options, const std::string& argument) {
  const auto equals = argument.find('=');
  for (const Option& option : describe(options)) {
    if ("--matte." + option.name == argument.substr(0, equals)) {
      return set_value(option, argument.substr(equals + 1));
    }
  }
  throw Error(argument + ": no such option");
}

// The poses; the lens only as a pinhole, since the photos are used as they are.
void place(Photos& photos, const std::string& cameras_path) {
  for (const Camera& camera : read_cameras(cameras_path)) {
    for (Photo& photo : photos) {
      if (photo.name != camera.name) continue;
      photo.camera = camera;
      photo.camera.lens = undistorted(scaled(camera.lens, photo.srgb.width(), photo.srgb.height()));
    }
  }
}

void run(const std::vector<std::string>& folders, const std::string& cameras_path,
         const MatteOptions& options) {
  Photos photos;
  Scribbles scribbles;
  double megapixels = 0.0;
  for (const auto& [name, path] : files_by_name(folders[0])) {
    photos.push_back(read_photo(name, path));
    megapixels += double(photos.back().srgb.size()) / 1e6;
  }
  if (!cameras_path.empty()) place(photos, cameras_path);
  for (const auto& [name, path] : files_by_name(folders[1])) scribbles[name] = read_strokes(path);
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
  std::vector<std::string> folders;
  std::string cameras;
  MatteOptions options;
  try {
    for (int i = 1; i < argc; ++i) {
      const std::string argument = argv[i];
      if (argument.starts_with("--cameras=")) {
        cameras = argument.substr(10);
      } else if (argument.starts_with("--")) {
        apply_option(options, argument);
      } else {
        folders.push_back(argument);
      }
    }
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
