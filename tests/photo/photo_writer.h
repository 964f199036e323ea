#pragma once

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace bosk {

// Writes test photos in any format that OpenImageIO writes, by the path's ending or, if given, by
// name.
struct PhotoFile {
  int width = 40, height = 30, channels = 3;
  OIIO::TypeDesc type = OIIO::TypeDesc::UINT8;
  bool straight_alpha = false;  // else OpenImageIO takes it that colour was premultiplied
  OIIO::ParamValueList attributes = {};
  std::string plugin = {};
  // Value of a channel, 0 to 1; the default is a slope, different in each channel
  float (*value)(int x, int y, int channel) = [](int x, int y, int channel) {
    return float(x + 2 * y + 30 * channel) / 255.0f;
  };
};

inline std::vector<float> values_of(const PhotoFile& photo) {
  std::vector<float> values;
  for (int y = 0; y < photo.height; ++y) {
    for (int x = 0; x < photo.width; ++x) {
      for (int c = 0; c < photo.channels; ++c) values.push_back(photo.value(x, y, c));
    }
  }
  return values;
}

// False when this installation cannot write the format.
inline bool write_photo(const std::filesystem::path& path, const PhotoFile& photo) {
  const std::string plugin = photo.plugin.empty() ? path.string() : photo.plugin;
  const auto output = OIIO::ImageOutput::create(plugin);
  if (!output) return false;
  OIIO::ImageSpec spec(photo.width, photo.height, photo.channels, photo.type);
  spec.extra_attribs = photo.attributes;
  if (photo.straight_alpha) spec.attribute("oiio:UnassociatedAlpha", 1);
  const std::vector<float> values = values_of(photo);
  return output->open(path.string(), spec) &&
         output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close();
}

}  // namespace bosk
