#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include "core/base/error.h"
#include "core/photo/child_mode.h"
#include "core/photo/decode_protocol.h"
#include "core/photo/gravity.h"

// The child's side of decode_photo: the only code that lets a decoder see a stranger's file.

namespace bosk {
namespace {

// Decoders pile up complaints, one a row; the first says enough.
std::string first_line(const std::string& complaint) {
  return complaint.substr(0, std::min<std::size_t>(complaint.find('\n'), 200));
}

const char* plugin_of(PhotoFormat format) {
  switch (format) {
    case PhotoFormat::jpeg:
      return "jpeg";
    case PhotoFormat::png:
      return "png";
    case PhotoFormat::tiff:
      return "tiff";
    case PhotoFormat::openexr:
      return "openexr";
    case PhotoFormat::raw:
      return "raw";
    case PhotoFormat::heif:
      return "heif";
  }
  return "";
}

std::unique_ptr<OIIO::ImageInput> opened(const std::string& path, PhotoFormat format) {
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);  // -1: none
  auto input = OIIO::ImageInput::create(plugin_of(format));
  if (!input) {
    throw Error("this installation cannot read " + name_of(format) +
                " files; convert it to JPEG, PNG or TIFF");
  }
  input->threads(1);
  OIIO::ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1);  // keep alpha straight
  hints.attribute("raw:user_flip", 0);           // keep the sensor's rows and columns
  OIIO::ImageSpec spec;
  if (!input->open(path, spec, hints)) throw Error(first_line(input->geterror()));
  return input;
}

void check_size(const OIIO::ImageSpec& spec, long long max_pixels) {
  const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height);
  if (spec.width < 1 || spec.height < 1) throw Error("it has no pixels");
  if (1LL * spec.width * spec.height > max_pixels) {
    throw Error(size + " pixels are more than the limit of " +
                std::to_string(max_pixels / 1'000'000) + " megapixels");
  }
  if (spec.depth > 1) throw Error("it is a volume, not a photo");
  if (spec.deep) throw Error("it holds deep pixels; flatten it first");
  if (spec.x != 0 || spec.y != 0 || spec.full_x != 0 || spec.full_y != 0 ||
      spec.full_width != spec.width || spec.full_height != spec.height) {
    throw Error("its data window differs from its display window; save it without cropping");
  }
}

// Channels past the first four, and a fourth that isn't alpha, are left out.
int channels_wanted(const OIIO::ImageSpec& spec, std::vector<std::string>& notes) {
  int wanted = std::min(spec.nchannels, 4);
  if (wanted == 4 && spec.alpha_channel != 3) wanted = 3;
  if (wanted == 2 && spec.alpha_channel != 1) wanted = 1;
  if (wanted < spec.nchannels) {
    notes.push_back(std::to_string(spec.nchannels - wanted) + " extra channels were left out");
  }
  return wanted;
}

PixelKind kind_of(const OIIO::ImageSpec& spec) {
  if (spec.format.is_floating_point() || !spec.channelformats.empty()) return PixelKind::f32_linear;
  return spec.format.size() == 1 ? PixelKind::u8_srgb : PixelKind::u16_srgb;
}

OIIO::TypeDesc type_of(PixelKind kind) {
  if (kind == PixelKind::u8_srgb) return OIIO::TypeDesc::UINT8;
  return kind == PixelKind::u16_srgb ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT;
}

std::optional<double> positive(const OIIO::ImageSpec& spec, const char* name) {
  const float value = spec.get_float_attribute(name, 0.0f);
  if (!(value > 0.0f) || !std::isfinite(value)) return std::nullopt;
  return double(value);
}

PhotoMetadata metadata_of(const OIIO::ImageSpec& spec) {
  PhotoMetadata metadata;
  metadata.focal_mm = positive(spec, "Exif:FocalLength");
  metadata.focal_35mm_equivalent_mm = positive(spec, "Exif:FocalLengthIn35mmFilm");
  metadata.exposure_s = positive(spec, "ExposureTime");
  metadata.iso = positive(spec, "Exif:PhotographicSensitivity");
  if (!metadata.iso) metadata.iso = positive(spec, "Exif:ISOSpeedRatings");
  metadata.f_number = positive(spec, "FNumber");
  metadata.orientation = spec.get_int_attribute("Orientation", 1);
  metadata.make = spec.get_string_attribute("Make").substr(0, 100);
  metadata.model = spec.get_string_attribute("Model").substr(0, 100);
  return metadata;
}

void note_colour(const OIIO::ImageSpec& spec, PixelKind kind, std::vector<std::string>& notes) {
  const std::string profile = spec.get_string_attribute("ICCProfile:profile_description");
  if (!profile.empty() && profile.find("sRGB") == std::string::npos) {
    notes.push_back("its colour profile (" + profile.substr(0, 60) + ") was read as sRGB");
  }
  const std::string space = spec.get_string_attribute("oiio:ColorSpace");
  if (kind != PixelKind::f32_linear && OIIO::Strutil::iequals(space, "linear")) {
    notes.push_back("its linear light was read as sRGB");
  }
  for (const char* device : {"tiff:ColorSpace", "jpeg:ColorSpace"}) {
    if (OIIO::Strutil::icontains(spec.get_string_attribute(device), "CMYK")) {
      notes.push_back("its CMYK inks were turned to RGB");
    }
  }
}

// Divides colour by alpha, in the values as stored: what the programs that premultiply undo.
template <class T>
void unpremultiply(std::vector<std::byte>& pixels, int channels) {
  const float top = std::is_floating_point_v<T> ? 1.0f : float(std::numeric_limits<T>::max());
  T* values = reinterpret_cast<T*>(pixels.data());
  const std::size_t count = pixels.size() / sizeof(T);
  const auto step = std::size_t(channels);
  for (std::size_t at = 0; at + step <= count; at += step) {
    const float alpha = float(values[at + step - 1]) / top;
    if (!(alpha > 0.0f) || alpha >= 1.0f) continue;
    for (std::size_t c = 0; c + 1 < step; ++c) {
      const float straight = float(values[at + c]) / alpha;
      values[at + c] =
          std::is_floating_point_v<T> ? T(straight) : T(std::min(straight + 0.5f, top));
    }
  }
}

void make_straight(DecodedPhoto& photo) {
  if (photo.kind == PixelKind::u8_srgb) {
    unpremultiply<std::uint8_t>(photo.pixels, photo.channels);
  } else if (photo.kind == PixelKind::u16_srgb) {
    unpremultiply<std::uint16_t>(photo.pixels, photo.channels);
  } else {
    unpremultiply<float>(photo.pixels, photo.channels);
  }
}

// What is missing is filled with grey, and the reader only mumbles about it. JPEG has complaints
// that harm no pixel, such as a few bytes too many.
void check_complaint(const std::string& complaint, const char* format,
                     std::vector<std::string>& notes) {
  if (complaint.empty()) return;
  if (OIIO::Strutil::icontains(complaint, "premature end")) throw Error("the file is cut short");
  if (std::strcmp(format, "jpeg") != 0) throw Error(first_line(complaint));
  notes.push_back("the decoder complained: " + first_line(complaint));
}

void read_pixels(OIIO::ImageInput& input, DecodedPhoto& photo) {
  const std::size_t values =
      std::size_t(photo.width_px) * std::size_t(photo.height_px) * std::size_t(photo.channels);
  photo.pixels.reserve(values * bytes_per_value(photo.kind) + 8192);  // room for the header
  photo.pixels.resize(values * bytes_per_value(photo.kind));
  if (!input.read_image(0, 0, 0, photo.channels, type_of(photo.kind), photo.pixels.data())) {
    throw Error(first_line(input.geterror()));
  }
  check_complaint(input.geterror(), input.format_name(), photo.notes);
}

// A small header that keeps a decoder busy is an attack; a big photo takes its time.
double cpu_allowance_s(const DecodedPhoto& photo, PhotoFormat format) {
  const double megapixels = 1e-6 * double(photo.width_px) * double(photo.height_px);
  return 4.0 + megapixels * (format == PhotoFormat::raw ? 1.0 : 0.25);
}

}  // namespace

std::vector<std::byte> decode_in_this_process(const std::vector<std::string>& arguments) {
  if (arguments.size() != 3) throw Error("the decoder was called wrongly");
  const auto format = PhotoFormat(std::stoi(arguments[1]));
  set_child_cpu_limit(4.0);
  const auto input = opened(arguments[0], format);
  const OIIO::ImageSpec& spec = input->spec();
  check_size(spec, std::stoll(arguments[2]));

  DecodedPhoto photo;
  photo.width_px = spec.width;
  photo.height_px = spec.height;
  photo.channels = channels_wanted(spec, photo.notes);
  photo.kind = kind_of(spec);
  photo.metadata = metadata_of(spec);
  if (format == PhotoFormat::jpeg) {
    photo.metadata.up_in_camera = up_from_maker_note(arguments[0]);
  }
  note_colour(spec, photo.kind, photo.notes);
  set_child_cpu_limit(cpu_allowance_s(photo, format));
  read_pixels(*input, photo);
  if (photo.has_alpha() && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0) {
    make_straight(photo);
  }
  std::vector<std::byte> message = std::move(photo.pixels);
  append_header(photo, message);
  return message;
}

std::optional<int> run_child_mode(int argc, char** argv) {
  if (argc < 2 || std::strcmp(argv[1], kDecodeMode) != 0) return std::nullopt;
  return serve_as_child(argc, argv, decode_in_this_process);
}

}  // namespace bosk
