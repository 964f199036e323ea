#include "core/photo/photo_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace bosk {
namespace {

using std::operator""sv;

constexpr auto kJpegEndings = {".jpg"sv, ".jpeg"sv, ".jpe"sv, ".jfif"sv};
constexpr auto kTiffEndings = {".tif"sv, ".tiff"sv};
constexpr auto kHeifEndings = {".heic"sv, ".heif"sv, ".hif"sv, ".avif"sv};
constexpr auto kRawEndings = {".3fr"sv, ".arw"sv, ".cr2"sv, ".cr3"sv, ".crw"sv, ".dcr"sv, ".dng"sv,
                              ".erf"sv, ".fff"sv, ".iiq"sv, ".kdc"sv, ".mef"sv, ".mos"sv, ".mrw"sv,
                              ".nef"sv, ".nrw"sv, ".orf"sv, ".pef"sv, ".raf"sv, ".raw"sv, ".rw2"sv,
                              ".rwl"sv, ".sr2"sv, ".srf"sv, ".srw"sv, ".x3f"sv};
constexpr auto kHeifBrands = {"heic"sv, "heix"sv, "heim"sv, "heis"sv, "hevc"sv,
                              "mif1"sv, "msf1"sv, "avif"sv, "avis"sv};

// Starts that only camera raw files have: Fujifilm, Panasonic, Olympus, Minolta, Sigma, Canon.
constexpr auto kRawStarts = {
    "FUJIFILMCCD-RAW"sv,     "IIU\0"sv, "IIRO"sv, "IIRS"sv, "MMOR"sv, "\0MRM"sv, "FOVb"sv,
    "II\x1a\0\0\0HEAPCCDR"sv};

template <class List>
bool any_of(const List& list, std::string_view text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// ISO base media: [size 4][ftyp][major brand 4][version 4][compatible brands 4 ...]
std::optional<PhotoFormat> media_format(std::string_view head) {
  const auto size = std::size_t(static_cast<unsigned char>(head[2])) * 256 +
                    std::size_t(static_cast<unsigned char>(head[3]));
  const std::string_view box = head.substr(0, std::min(size, head.size()));
  for (std::size_t at = 8; at + 4 <= box.size(); at += at == 8 ? 8 : 4) {
    const std::string_view brand = box.substr(at, 4);
    if (brand == "crx ") return PhotoFormat::raw;
    if (any_of(kHeifBrands, brand)) return PhotoFormat::heif;
  }
  return std::nullopt;
}

}  // namespace

std::string name_of(PhotoFormat format) {
  switch (format) {
    case PhotoFormat::jpeg:
      return "JPEG";
    case PhotoFormat::png:
      return "PNG";
    case PhotoFormat::tiff:
      return "TIFF";
    case PhotoFormat::openexr:
      return "OpenEXR";
    case PhotoFormat::raw:
      return "camera raw";
    case PhotoFormat::heif:
      return "HEIF";
  }
  return "unknown";
}

std::optional<PhotoFormat> photo_format(std::span<const std::byte> first_bytes,
                                        const std::string& ending) {
  const std::string_view head(reinterpret_cast<const char*>(first_bytes.data()),
                              first_bytes.size());
  if (head.starts_with("\xff\xd8\xff"sv)) return PhotoFormat::jpeg;
  if (head.starts_with("\x89PNG\r\n\x1a\n"sv)) return PhotoFormat::png;
  if (head.starts_with("\x76\x2f\x31\x01"sv)) return PhotoFormat::openexr;
  for (const std::string_view start : kRawStarts) {
    if (head.starts_with(start)) return PhotoFormat::raw;
  }
  const bool tiff = head.starts_with("II*\0"sv) || head.starts_with("MM\0*"sv) ||
                    head.starts_with("II+\0"sv) || head.starts_with("MM\0+"sv);
  if (tiff) return any_of(kRawEndings, lower(ending)) ? PhotoFormat::raw : PhotoFormat::tiff;
  if (head.size() >= 16 && head.substr(4, 4) == "ftyp") return media_format(head);
  return std::nullopt;
}

bool is_usual_ending(PhotoFormat format, const std::string& ending) {
  const std::string low = lower(ending);
  switch (format) {
    case PhotoFormat::jpeg:
      return any_of(kJpegEndings, low);
    case PhotoFormat::png:
      return low == ".png";
    case PhotoFormat::tiff:
      return any_of(kTiffEndings, low);
    case PhotoFormat::openexr:
      return low == ".exr";
    case PhotoFormat::raw:
      return any_of(kRawEndings, low);
    case PhotoFormat::heif:
      return any_of(kHeifEndings, low);
  }
  return false;
}

bool has_photo_ending(const std::filesystem::path& path) {
  constexpr std::array kFormats = {PhotoFormat::jpeg,    PhotoFormat::png, PhotoFormat::tiff,
                                   PhotoFormat::openexr, PhotoFormat::raw, PhotoFormat::heif};
  return std::any_of(kFormats.begin(), kFormats.end(), [&](PhotoFormat format) {
    return is_usual_ending(format, path.extension().string());
  });
}

}  // namespace bosk
