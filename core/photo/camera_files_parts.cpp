#include "core/photo/camera_files_parts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <system_error>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/geometry/rotation.h"

namespace bosk::camera_files {
namespace {

// Wide enough for every camera, and no product of two such numbers overflows.
constexpr double kLargestNumber = 1e12, kShortestFocalLength_px = 1e-3;
constexpr double kLargestSize_px = 100'000.0;
constexpr std::size_t kLongestName = 200;       // file systems take 255 bytes with an ending
constexpr double kLargestRotationError = 1e-3;  // files with few digits stay below it
constexpr double kRoundingError = 1e-12;        // a rotation as good as that is left as it is

bool usable(double number) { return std::abs(number) <= kLargestNumber; }  // no NaN either
bool usable(const glm::dvec2& v) { return usable(v.x) && usable(v.y); }
bool usable(const glm::dvec3& v) { return usable(v.x) && usable(v.y) && usable(v.z); }

// "view.05" has none: no image format is called by digits alone, and NeRF lists images without.
bool has_ending(const std::filesystem::path& file) {
  return file.extension().string().find_first_not_of(".0123456789") != std::string::npos;
}

bool size_allowed(double size_px) {
  return size_px >= 1.0 && size_px <= kLargestSize_px && size_px == std::floor(size_px);
}

}  // namespace

void refuse(const std::string& place, const std::string& complaint) {
  throw Error(place + ": " + complaint);
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 60)) result += c >= ' ' && c < '\x7f' ? c : '?';
  return result + (text.size() > 60 ? "...\"" : "\"");
}

double number_from(std::string_view text, const std::string& place) {
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(number))
    refuse(place, in_quotes(text) + " is not a number that can be used; correct it");
  return number;
}

std::uint64_t whole_number_from(std::string_view text, const std::string& place) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    refuse(place, in_quotes(text) + " is not a whole number; correct it");
  return number;
}

std::string text_from(double number) {
  char digits[64];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
  return {digits, end};
}

std::string read_text(const std::filesystem::path& path, std::uint64_t max_bytes) {
  const std::vector<std::byte> bytes = read_file(path, max_bytes);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool has_control_characters(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](unsigned char c) { return c < ' ' || c == 0x7f; });
}

std::string camera_name(std::string_view image, const std::string& place) {
  const std::size_t slash = image.find_last_of("/\\");
  const std::filesystem::path file(slash == std::string_view::npos ? image
                                                                   : image.substr(slash + 1));
  std::string name = (has_ending(file) ? file.stem() : file).string();
  if (name.empty() || name == "." || name == ".." || name.size() > kLongestName ||
      has_control_characters(image))
    refuse(place, in_quotes(image) + " is no name of an image; correct it");
  return name;
}

void set_size(Lens& lens, double width_px, double height_px, const std::string& place) {
  if (!size_allowed(width_px) || !size_allowed(height_px))
    refuse(place, "the image size " + text_from(width_px) + " x " + text_from(height_px) +
                      " is not in whole pixels from 1 to 100,000; correct it");
  lens.width_px = int(width_px);
  lens.height_px = int(height_px);
}

void check(const Camera& camera, const std::string& place) {
  Lens lens = camera.lens;
  set_size(lens, lens.width_px, lens.height_px, place);
  if (!usable(lens.focal_px) || !(lens.focal_px.x >= kShortestFocalLength_px) ||
      !(lens.focal_px.y >= kShortestFocalLength_px))
    refuse(place, "the focal length " + text_from(lens.focal_px.x) + ", " +
                      text_from(lens.focal_px.y) + " px is not from 0.001 to 1e12; correct it");
  if (!usable(lens.principal_px))
    refuse(place, "the principal point is not finite or beyond 1e12; correct it");
  for (const double k : lens.distortion)
    if (!usable(k))
      refuse(place, "a distortion parameter is not finite or beyond 1e12; correct it");
  const RigidTransform& pose = camera.camera_from_world;
  if (!usable(pose.translation) || !(rotation_error(pose.rotation) < kLargestRotationError))
    refuse(place, "the pose is not finite, beyond 1e12 or turned by no rotation; correct it");
}

void check_set(std::span<const Camera> cameras, const std::string& place) {
  if (cameras.empty()) refuse(place, "no camera in it; give a file that holds cameras");
  std::map<std::string_view, std::size_t> seen;
  for (std::size_t i = 0; i < cameras.size(); ++i)
    if (!seen.emplace(cameras[i].name, i).second)
      refuse(place,
             "two images are named " + in_quotes(cameras[i].name) +
                 " when folder and ending are left out; rename one, as photos are matched by "
                 "that name");
}

glm::dmat3 rotation_from(const glm::dmat3& matrix, const std::string& place) {
  const double error = rotation_error(matrix);
  if (!(error <= kLargestRotationError))
    refuse(place,
           "the rotation matrix is not orthonormal within 0.001 or mirrors; export it again");
  return error <= kRoundingError ? matrix : nearest_rotation(matrix);
}

glm::dmat3 rotation_from_quaternion(const glm::dvec4& wxyz, const std::string& place) {
  const double length = glm::length(wxyz);
  if (!(std::abs(length - 1.0) <= kLargestRotationError))
    refuse(place, "the quaternion has length " + text_from(length) + ", not 1; export it again");
  const glm::dvec4 q = wxyz / length;
  return glm::mat3_cast(glm::dquat(q[0], q[1], q[2], q[3]));
}

}  // namespace bosk::camera_files
