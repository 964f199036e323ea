#include "core/calibrate/lens_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/number_text.h"

// {"bosk_lens_profile": 1, "taken_with": {"make", "model", "focal_mm"}, "lens": {"model",
// "width_px", "height_px", "focal_px": [x, y], "principal_px": [x, y], "distortion": [8 numbers]},
// "rms_px", "boards", "corners", "coverage": {"columns", "rows", "values"}, "uncertainty_px": the
// same}
namespace bosk {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr std::uint64_t kMaxBytes = std::uint64_t(4) << 20;
constexpr int kMaxDepth = 8;
constexpr int kMaxMapSide = 200;
constexpr double kFocalAgreement = 0.01;  // relative: what EXIF rounds away

constexpr std::pair<LensModel, std::string_view> kModels[] = {
    {LensModel::pinhole, "pinhole"},
    {LensModel::opencv, "opencv"},
    {LensModel::opencv_fisheye, "opencv_fisheye"},
};

ordered_json json_of(const glm::dvec2& pair) { return {pair.x, pair.y}; }

ordered_json json_of(const Image<float>& map) {
  return {{"columns", map.width()}, {"rows", map.height()}, {"values", map.pixels()}};
}

ordered_json json_of(const Lens& lens) {
  const auto* model = std::find_if(std::begin(kModels), std::end(kModels),
                                   [&](const auto& entry) { return entry.first == lens.model; });
  return {{"model", model->second},
          {"width_px", lens.width_px},
          {"height_px", lens.height_px},
          {"focal_px", json_of(lens.focal_px)},
          {"principal_px", json_of(lens.principal_px)},
          {"distortion", lens.distortion}};
}

ordered_json json_of(const LensIdentity& identity) {
  ordered_json result{{"make", identity.make}, {"model", identity.model}};
  if (identity.focal_mm) result["focal_mm"] = *identity.focal_mm;
  return result;
}

// A value of the file with the place that errors name.
struct Node {
  const json& value;
  std::string place;

  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(place + ": " + reason + "; calibrate the lens again or mend the file");
  }
  Node at(const char* key) const {
    if (!value.is_object()) refuse("an object must stand here");
    const auto found = value.find(key);
    if (found == value.end()) refuse("no \"" + std::string(key) + "\" in it");
    return {*found, place + ", \"" + key + "\""};
  }
  bool has(const char* key) const { return value.is_object() && value.contains(key); }
  double number(double least, double most) const {
    if (!value.is_number()) refuse("a number must stand here");
    const double number = value.get<double>();
    if (!(number >= least && number <= most))
      refuse(number_text(number, 3) + " is not from " + number_text(least, 0) + " to " +
             number_text(most, 0));
    return number;
  }
  int whole(int least, int most) const {
    if (!value.is_number_integer()) refuse("a whole number must stand here");
    return int(number(least, most));
  }
  std::string text() const {
    if (!value.is_string()) refuse("a text must stand here");
    return value.get<std::string>();
  }
  // Exactly `count` numbers.
  std::vector<double> numbers(std::size_t count, double least, double most) const {
    if (!value.is_array() || value.size() != count)
      refuse("a list of " + std::to_string(count) + " numbers must stand here");
    std::vector<double> numbers;
    for (const json& entry : value) numbers.push_back(Node{entry, place}.number(least, most));
    return numbers;
  }
};

json parse(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = read_file(path, kMaxBytes);
  const auto* text = reinterpret_cast<const char*>(bytes.data());
  const auto limit_depth = [&path](int depth, json::parse_event_t, json&) {
    if (depth > kMaxDepth) throw Error(path.string() + ": nested too deep to be a lens profile");
    return true;
  };
  try {
    return json::parse(text, text + bytes.size(), limit_depth);
  } catch (const json::exception&) {
    throw Error(path.string() +
                ": damaged, no valid JSON; calibrate the lens again or take an older copy");
  }
}

glm::dvec2 pair_from(const Node& node, double least, double most) {
  const std::vector<double> numbers = node.numbers(2, least, most);
  return {numbers[0], numbers[1]};
}

Lens lens_from(const Node& node) {
  const std::string name = node.at("model").text();
  const auto* model = std::find_if(std::begin(kModels), std::end(kModels),
                                   [&](const auto& entry) { return entry.second == name; });
  if (model == std::end(kModels)) node.at("model").refuse("no lens model of this name");
  Lens lens;
  lens.model = model->first;
  lens.width_px = node.at("width_px").whole(1, 100'000);
  lens.height_px = node.at("height_px").whole(1, 100'000);
  lens.focal_px = pair_from(node.at("focal_px"), 1e-3, 1e7);
  lens.principal_px = pair_from(node.at("principal_px"), -1e6, 1e6);
  const std::vector<double> terms = node.at("distortion").numbers(8, -1e6, 1e6);
  std::copy(terms.begin(), terms.end(), lens.distortion.begin());
  return lens;
}

Image<float> map_from(const Node& node) {
  Image<float> map(node.at("columns").whole(0, kMaxMapSide), node.at("rows").whole(0, kMaxMapSide));
  const std::vector<double> values = node.at("values").numbers(map.size(), 0.0, 1e9);
  std::transform(values.begin(), values.end(), map.pixels().begin(),
                 [](double value) { return float(value); });
  return map;
}

LensIdentity identity_from(const Node& node) {
  LensIdentity identity{node.at("make").text(), node.at("model").text(), {}};
  if (node.has("focal_mm")) identity.focal_mm = node.at("focal_mm").number(1e-3, 1e5);
  return identity;
}

std::string focal_text(double focal_mm) {
  const bool whole = std::abs(focal_mm - std::round(focal_mm)) < 0.005;
  return number_text(focal_mm, whole ? 0 : 2) + " mm";
}

void check_same_camera(const LensIdentity& profile, const LensIdentity& photo) {
  const auto differs = [](const std::string& a, const std::string& b) {
    return !a.empty() && !b.empty() && a != b;
  };
  if (differs(profile.make, photo.make) || differs(profile.model, photo.model))
    throw Error("the lens profile is of " + identity_text(profile) + ", the photo of " +
                identity_text(photo) + "; choose that camera's profile or calibrate it");
  if (!profile.focal_mm || !photo.focal_mm) return;
  if (std::abs(*profile.focal_mm - *photo.focal_mm) > kFocalAgreement * *profile.focal_mm)
    throw Error("the lens profile is for " + focal_text(*profile.focal_mm) +
                ", the photo was taken at " + focal_text(*photo.focal_mm) +
                "; choose a profile of that focal length or calibrate it");
}

}  // namespace

LensIdentity identity_of(const PhotoMetadata& metadata) {
  return {metadata.make, metadata.model, metadata.focal_mm};
}

std::string identity_text(const LensIdentity& identity) {
  const bool repeats = identity.model.starts_with(identity.make);
  std::string text =
      repeats || identity.make.empty() ? identity.model : identity.make + " " + identity.model;
  if (text.empty()) text = "a camera that EXIF doesn't name";
  return identity.focal_mm ? text + " at " + focal_text(*identity.focal_mm) : text;
}

void save_lens_profile(const std::filesystem::path& path, const LensProfile& profile) {
  const ordered_json root{{"bosk_lens_profile", kVersion},
                          {"taken_with", json_of(profile.taken_with)},
                          {"lens", json_of(profile.lens)},
                          {"rms_px", profile.rms_px},
                          {"boards", profile.boards},
                          {"corners", profile.corners},
                          {"coverage", json_of(profile.coverage)},
                          {"uncertainty_px", json_of(profile.uncertainty_px)}};
  // EXIF may hold any bytes; what is no UTF-8 is replaced.
  const std::string text = root.dump(1, ' ', false, ordered_json::error_handler_t::replace);
  write_file_atomically(path, text + "\n");
}

LensProfile read_lens_profile(const std::filesystem::path& path) {
  const json root = parse(path);
  const Node node{root, path.string()};
  if (!node.has("bosk_lens_profile"))
    throw Error(path.string() + ": no lens profile; give a file that a calibration has saved");
  if (node.at("bosk_lens_profile").whole(1, 1'000'000) > kVersion)
    throw Error(path.string() + ": a lens profile of a newer Bosk; update this one");
  LensProfile profile;
  profile.taken_with = identity_from(node.at("taken_with"));
  profile.lens = lens_from(node.at("lens"));
  profile.rms_px = node.at("rms_px").number(0.0, 1e6);
  profile.boards = node.at("boards").whole(0, 1'000'000);
  profile.corners = node.at("corners").whole(0, 1'000'000'000);
  profile.coverage = map_from(node.at("coverage"));
  profile.uncertainty_px = map_from(node.at("uncertainty_px"));
  return profile;
}

Lens lens_for_photo(const LensProfile& profile, const LensIdentity& photo_taken_with, int width_px,
                    int height_px) {
  check_same_camera(profile.taken_with, photo_taken_with);
  const Lens& lens = profile.lens;
  const double height_of_same_shape = double(width_px) * lens.height_px / lens.width_px;
  const double width_of_same_shape = double(height_px) * lens.width_px / lens.height_px;
  const auto rounds_to = [](double exact, int rounded) {
    return std::abs(exact - rounded) <= 0.51;
  };
  if (!rounds_to(height_of_same_shape, height_px) && !rounds_to(width_of_same_shape, width_px))
    throw Error("the lens profile is for pictures of " + std::to_string(lens.width_px) + " x " +
                std::to_string(lens.height_px) + ", which " + std::to_string(width_px) + " x " +
                std::to_string(height_px) +
                " is no smaller or larger copy of; give photos as the camera made them, neither "
                "cropped nor turned");
  return scaled(lens, width_px, height_px);
}

}  // namespace bosk
