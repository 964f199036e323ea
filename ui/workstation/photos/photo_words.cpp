#include "ui/workstation/photos/photo_words.h"

#include <cmath>
#include <cstdio>
#include <map>

#include "core/base/system_error.h"
#include "core/image/orientation.h"

namespace bosk {
namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string size_words(const DecodedPhoto& photo) {
  return std::to_string(photo.width_px) + " x " + std::to_string(photo.height_px);
}

std::string camera_words(const PhotoMetadata& metadata) {
  // Many makers begin the model with their own name
  const bool twice = metadata.model.starts_with(metadata.make);
  const std::string between = metadata.make.empty() || metadata.model.empty() ? "" : " ";
  return printable(twice ? metadata.model : metadata.make + between + metadata.model);
}

std::string lens_words(const DecodedPhoto& photo) {
  const PhotoMetadata& metadata = photo.metadata;
  const std::string camera = camera_words(metadata);
  std::string words = camera.empty() ? "unnamed camera" : camera;
  if (metadata.focal_mm) words += formatted(" at %.3g mm", *metadata.focal_mm);
  return words;
}

bool stands(const DecodedPhoto& photo) {
  const glm::ivec2 shown =
      upright_size({photo.width_px, photo.height_px}, photo.metadata.orientation);
  return shown.y > shown.x;
}

// "22 of 6000 x 4000, 2 of 4000 x 6000"
std::string list_words(const std::map<std::string, std::size_t>& counts) {
  std::string words;
  for (const auto& [what, count] : counts) {
    words += (words.empty() ? "" : ", ") + std::to_string(count) + " of " + what;
  }
  return words;
}

std::string exposure_words(double seconds) {
  if (seconds >= 0.4) return formatted("%.3g s", seconds);
  return formatted("1/%.0f s", 1.0 / seconds);
}

std::string orientation_words(int orientation) {
  static constexpr const char* kWords[] = {"upright as delivered",
                                           "mirrored for display",
                                           "turned half round for display",
                                           "mirrored upside down for display",
                                           "mirrored and turned for display",
                                           "turned a quarter to the right for display",
                                           "mirrored and turned for display",
                                           "turned a quarter to the left for display"};
  const bool known = orientation >= 1 && orientation <= 8;
  return known ? std::to_string(orientation) + ", " + kWords[orientation - 1]
               : "not known, shown as delivered";
}

std::string focal_words(const PhotoMetadata& metadata) {
  std::string words;
  if (metadata.focal_mm) words = formatted("%.4g mm", *metadata.focal_mm);
  if (metadata.focal_35mm_equivalent_mm) {
    words += (words.empty() ? "" : ", ") +
             formatted("%.4g mm on 35 mm film", *metadata.focal_35mm_equivalent_mm);
  }
  return words;
}

}  // namespace

std::string count_of(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

VerdictWord word_of(const PhotoVerdict& verdict, const PhotoFacts& facts, bool cameras_known) {
  if (!verdict.accepted) return {Tone::bad, "left out"};
  const bool guessed = !cameras_known && !facts.decoded.metadata.focal_35mm_equivalent_mm;
  if (guessed) return {Tone::note, "usable, with a guess"};
  if (!facts.decoded.notes.empty()) return {Tone::note, "usable, see why"};
  return {Tone::good, "usable"};
}

std::vector<std::string> set_remarks(std::span<const PhotoFacts* const> accepted) {
  std::map<std::string, std::size_t> sizes, lenses;
  std::size_t standing = 0;
  for (const PhotoFacts* facts : accepted) {
    ++sizes[size_words(facts->decoded)];
    ++lenses[lens_words(facts->decoded)];
    standing += stands(facts->decoded) ? 1 : 0;
  }
  std::vector<std::string> remarks;
  if (sizes.size() > 1) {
    remarks.push_back("Pictures of " + std::to_string(sizes.size()) +
                      " sizes: " + list_words(sizes) +
                      ". One lens gives one size; leave out crops, and pictures that a program "
                      "has turned.");
  }
  if (lenses.size() > 1) {
    remarks.push_back("Pictures of " + std::to_string(lenses.size()) +
                      " lenses: " + list_words(lenses) + ". Each needs a calibration of its own.");
  }
  if (standing > 0 && standing < accepted.size()) {
    remarks.push_back(count_of(standing, "photo") + " upright beside " +
                      std::to_string(accepted.size() - standing) +
                      " across: all are shown as they were held, and used as the sensor delivered "
                      "them.");
  }
  return remarks;
}

Details details_of(const PhotoFacts& facts, std::uintmax_t bytes) {
  const DecodedPhoto& photo = facts.decoded;
  const PhotoMetadata& metadata = photo.metadata;
  const auto or_none = [](const std::string& text) {
    return text.empty() ? std::string("not in the file") : text;
  };
  const double megapixels = 1e-6 * photo.width_px * photo.height_px;
  Details details;
  details.emplace_back("Camera", or_none(camera_words(metadata)));
  details.emplace_back("Focal length", or_none(focal_words(metadata)));
  details.emplace_back("Exposure",
                       or_none(metadata.exposure_s ? exposure_words(*metadata.exposure_s) : ""));
  details.emplace_back("Aperture",
                       or_none(metadata.f_number ? formatted("f/%.3g", *metadata.f_number) : ""));
  details.emplace_back("ISO", or_none(metadata.iso ? formatted("%.0f", *metadata.iso) : ""));
  details.emplace_back("Size", size_words(photo) + formatted(", %.1f megapixels", megapixels));
  details.emplace_back("Orientation", orientation_words(metadata.orientation));
  details.emplace_back("File",
                       name_of(photo.format) + formatted(", %.1f MB", 1e-6 * double(bytes)));
  return details;
}

}  // namespace bosk
