#include "matte_folders.h"

#include <OpenImageIO/imageio.h>

#include <vector>

#include "core/base/error.h"
#include "core/photo/camera_files.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

std::map<std::string, fs::path> files_by_name(const fs::path& folder) {
  std::map<std::string, fs::path> files;
  if (folder.empty()) return files;
  for (const auto& entry : fs::directory_iterator(folder))
    files[entry.path().stem().string()] = entry.path();
  return files;
}

Image<float> read_alpha(const fs::path& path) {
  const Channels channels = read_channels(path);
  Image<float> alpha(channels.width, channels.height);
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    alpha.data()[i] = channels.at(i, channels.count == 4 ? 3 : 0);
  }
  return alpha;
}

Photos read_photos(const fs::path& folder, const std::string& cameras_path) {
  Photos photos;
  for (const auto& [name, path] : files_by_name(folder)) photos.push_back(read_photo(name, path));
  if (!cameras_path.empty()) place(photos, cameras_path);
  return photos;
}

Scribbles read_scribbles(const fs::path& folder) {
  Scribbles scribbles;
  for (const auto& [name, path] : files_by_name(folder)) scribbles[name] = read_strokes(path);
  return scribbles;
}

namespace {

void apply_option(MatteOptions& options, const std::string& argument) {
  const auto equals = argument.find('=');
  for (const Option& option : describe(options)) {
    if ("--matte." + option.name == argument.substr(0, equals)) {
      return set_value(option, argument.substr(equals + 1));
    }
  }
  throw Error(argument + ": no such option");
}

}  // namespace

MatteArguments matte_arguments(int argc, char** argv) {
  MatteArguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.starts_with("--cameras=")) {
      arguments.cameras = argument.substr(10);
    } else if (argument.starts_with("--")) {
      apply_option(arguments.options, argument);
    } else {
      arguments.folders.push_back(argument);
    }
  }
  return arguments;
}

}  // namespace bosk
