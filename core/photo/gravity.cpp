#include "core/photo/gravity.h"

#include <libexif/exif-data.h>
#include <libexif/exif-utils.h>

#include <array>
#include <cmath>
#include <memory>
#include <string_view>

namespace bosk {
namespace {

constexpr unsigned kAccelerationVector = 8;  // of Apple's maker notes
constexpr std::size_t kDirectory = 14;       // its place in them
constexpr std::size_t kEntryBytes = 12, kRationalBytes = 8;
constexpr double kLargestShake = 0.1;  // of the length, in g

struct Release {
  void operator()(ExifData* data) const { exif_data_unref(data); }
};
using Exif = std::unique_ptr<ExifData, Release>;

std::string text_of(ExifData* data, ExifIfd ifd, ExifTag tag) {
  ExifEntry* entry = exif_content_get_entry(data->ifd[ifd], tag);
  if (entry == nullptr) return "";
  std::array<char, 200> text{};
  exif_entry_get_value(entry, text.data(), unsigned(text.size()));
  return text.data();
}

// Apple's note: "Apple iOS", a version, the byte order, a directory as in TIFF whose offsets count
// from the note's beginning. (libexif 0.6.24 knows such notes but misreads this entry.)
struct AppleNote {
  std::string_view bytes;
  ExifByteOrder order = EXIF_BYTE_ORDER_MOTOROLA;

  // Null where the note ends before.
  const unsigned char* at(std::size_t place, std::size_t size) const {
    const bool fits = place <= bytes.size() && size <= bytes.size() - place;
    return fits ? reinterpret_cast<const unsigned char*>(bytes.data()) + place : nullptr;
  }
};

std::optional<AppleNote> apple_note(const ExifEntry& entry) {
  AppleNote note{{reinterpret_cast<const char*>(entry.data), entry.size}};
  if (note.bytes.size() < kDirectory || note.bytes.substr(0, 9) != "Apple iOS") return std::nullopt;
  const std::string_view order = note.bytes.substr(kDirectory - 2, 2);
  if (order == "II") note.order = EXIF_BYTE_ORDER_INTEL;
  return order == "II" || order == "MM" ? std::optional(note) : std::nullopt;
}

std::optional<glm::dvec3> vector_at(const AppleNote& note, std::size_t place) {
  const unsigned char* bytes = note.at(place, 3 * kRationalBytes);
  if (bytes == nullptr) return std::nullopt;
  glm::dvec3 vector(0.0);
  for (int i = 0; i < 3; ++i) {
    const ExifSRational number =
        exif_get_srational(bytes + kRationalBytes * std::size_t(i), note.order);
    vector[i] = number.denominator == 0 ? 0.0 : double(number.numerator) / number.denominator;
  }
  return vector;
}

std::optional<glm::dvec3> acceleration_of(const AppleNote& note) {
  const unsigned char* counted = note.at(kDirectory, 2);
  const unsigned count = counted != nullptr ? exif_get_short(counted, note.order) : 0u;
  for (unsigned i = 0; i < count; ++i) {
    const unsigned char* entry = note.at(kDirectory + 2 + kEntryBytes * i, kEntryBytes);
    if (entry == nullptr) return std::nullopt;
    if (exif_get_short(entry, note.order) != kAccelerationVector ||
        exif_get_short(entry + 2, note.order) != EXIF_FORMAT_SRATIONAL ||
        exif_get_long(entry + 4, note.order) != 3) {
      continue;
    }
    return vector_at(note, exif_get_long(entry + 8, note.order));
  }
  return std::nullopt;
}

}  // namespace

std::optional<glm::dvec3> up_from_phone_gravity(const glm::dvec3& gravity_in_phone) {
  const double length = glm::length(gravity_in_phone);
  if (!(std::abs(length - 1.0) <= kLargestShake)) return std::nullopt;
  // Right is the phone's -y, down its -x, forward its -z; up is against gravity
  const glm::dvec3& g = gravity_in_phone;
  return glm::dvec3(g.y, g.x, g.z) / length;
}

std::optional<glm::dvec3> up_from_maker_note(const std::string& path) {
  const Exif exif(exif_data_new_from_file(path.c_str()));
  if (!exif || text_of(exif.get(), EXIF_IFD_0, EXIF_TAG_MAKE) != "Apple") return std::nullopt;
  const std::string lens = text_of(exif.get(), EXIF_IFD_EXIF, ExifTag(0xa434));  // LensModel
  if (lens.find("front") != std::string::npos) return std::nullopt;
  const ExifEntry* entry = exif_content_get_entry(exif->ifd[EXIF_IFD_EXIF], EXIF_TAG_MAKER_NOTE);
  const auto note = entry != nullptr ? apple_note(*entry) : std::nullopt;
  const auto gravity = note ? acceleration_of(*note) : std::nullopt;
  return gravity ? up_from_phone_gravity(*gravity) : std::nullopt;
}

}  // namespace bosk
