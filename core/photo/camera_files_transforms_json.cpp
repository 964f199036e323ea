#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/photo/camera_files_parts.h"

// transforms.json of NeRF, instant-ngp and nerfstudio: {lens keys, "frames": [{"file_path",
// "transform_matrix", lens keys of this frame alone}]}. The matrix is world_from_camera for
// OpenGL's camera (x right, y up, z backward); pixels count from the corner. nerfstudio's
// applied_transform and applied_scale, which lead from the reconstruction's world to the file's,
// are undone, so that the cameras are those of the COLMAP model they came from.
namespace bosk::camera_files {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::uint64_t kMaxBytes = std::uint64_t(64) << 20;
constexpr int kMaxDepth = 64;
constexpr double kPi = 3.14159265358979323846;

json parse(const std::filesystem::path& file) {
  const std::string text = read_text(file, kMaxBytes);
  const auto limit_depth = [&file](int depth, json::parse_event_t, json&) {
    if (depth > kMaxDepth) refuse(file.string(), "nested deeper than 64 levels; export it again");
    return true;
  };
  try {
    return json::parse(text, limit_depth);
  } catch (const json::exception& failure) {
    std::string reason =
        failure.what();  // "[json.exception...] parse error at line 1, column 2: ..."
    reason.erase(0, reason.find(']') + 1);
    refuse(file.string(), "no valid JSON:" + reason.substr(0, 200) + "; export it again");
  }
}

// One frame with what the file says for all of them.
struct Keys {
  const json& frame;
  const json& root;
  std::string place;

  const json* find(const char* key) const {
    for (const json* object : {&frame, &root})
      if (const auto found = object->find(key); found != object->end() && !found->is_null())
        return &*found;
    return nullptr;
  }
  std::string place_of(const char* key) const { return place + ", key \"" + key + "\""; }

  std::optional<double> number(const char* key) const {
    const json* value = find(key);
    if (!value) return std::nullopt;
    if (!value->is_number() || !std::isfinite(value->get<double>()))
      refuse(place_of(key), "a finite number must stand here; correct it");
    return value->get<double>();
  }
  double number_or_zero(const char* key) const { return number(key).value_or(0.0); }

  std::string text(const char* key) const {
    const json* value = find(key);
    if (!value) return {};
    if (!value->is_string()) refuse(place_of(key), "a text must stand here; correct it");
    return value->get<std::string>();
  }
  bool flag(const char* key) const {
    const json* value = find(key);
    return value && value->is_boolean() && value->get<bool>();
  }
};

// A matrix of 3 or 4 rows of 4 numbers, the last row 0 0 0 1, as its 3 x 3 part and last column.
struct Affine {
  glm::dmat3 linear{1.0};
  glm::dvec3 shift{0.0};
};

Affine affine_from(const json& rows, const std::string& place) {
  glm::dmat4 matrix(1.0);
  const auto is_row = [](const json& row) {
    return row.is_array() && row.size() == 4 &&
           std::all_of(row.begin(), row.end(), [](const json& x) { return x.is_number(); });
  };
  if (!rows.is_array() || rows.size() < 3 || rows.size() > 4 ||
      !std::all_of(rows.begin(), rows.end(), is_row))
    refuse(place, "a list of 4 rows of 4 numbers must stand here; correct it");
  for (int row = 0; row < int(rows.size()); ++row)
    for (int column = 0; column < 4; ++column)
      matrix[column][row] = rows[std::size_t(row)][std::size_t(column)].get<double>();
  for (int column = 0; column < 4; ++column)
    if (!(std::abs(matrix[column][3] - (column == 3 ? 1.0 : 0.0)) < 1e-6))
      refuse(place, "the last row must be 0 0 0 1; correct it");
  return {glm::dmat3(matrix), glm::dvec3(matrix[3])};
}

RigidTransform rigid_from(const json& rows, const std::string& place) {
  const Affine affine = affine_from(rows, place);
  return {rotation_from(affine.linear, place), affine.shift};
}

const glm::dmat3 kCameraFromGl(1, 0, 0, 0, -1, 0, 0, 0, -1);

RigidTransform camera_from_world(const Keys& keys) {
  const json* matrix = keys.find("transform_matrix");
  if (!matrix) refuse(keys.place, "no \"transform_matrix\"; add it");
  const RigidTransform file_from_gl = rigid_from(*matrix, keys.place_of("transform_matrix"));
  const double scale = keys.number("applied_scale").value_or(1.0);
  if (!(scale > 0.0)) refuse(keys.place_of("applied_scale"), "not above zero; correct it");
  const json* applied = keys.find("applied_transform");
  const RigidTransform file_from_world =
      applied ? rigid_from(*applied, keys.place_of("applied_transform")) : RigidTransform{};
  const RigidTransform unscaled{file_from_gl.rotation * kCameraFromGl,
                                file_from_gl.translation / scale};
  return inverse(unscaled) * file_from_world;
}

void set_model(Lens& lens, const Keys& keys) {
  constexpr std::array kPerspective{"",       "PINHOLE",       "SIMPLE_PINHOLE", "PERSPECTIVE",
                                    "OPENCV", "SIMPLE_RADIAL", "RADIAL",         "FULL_OPENCV"};
  const std::string model = keys.text("camera_model");
  if (model == "OPENCV_FISHEYE" || keys.flag("is_fisheye")) {
    lens.model = LensModel::opencv_fisheye;
    lens.distortion = {keys.number_or_zero("k1"), keys.number_or_zero("k2"),
                       keys.number_or_zero("k3"), keys.number_or_zero("k4")};
    return;
  }
  if (std::find(kPerspective.begin(), kPerspective.end(), model) == kPerspective.end())
    refuse(keys.place_of("camera_model"), in_quotes(model) +
                                              " is not supported; undistort the photos or use "
                                              "PINHOLE, OPENCV, FULL_OPENCV or OPENCV_FISHEYE");
  const char* order[] = {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
  for (std::size_t i = 0; i < 8; ++i) lens.distortion[i] = keys.number_or_zero(order[i]);
  const bool bends = lens.distortion != decltype(lens.distortion){};
  const bool rational =
      lens.distortion[5] != 0.0 || lens.distortion[6] != 0.0 || lens.distortion[7] != 0.0;
  if (rational && model != "FULL_OPENCV")
    refuse(keys.place,
           "k4 to k6 mean different things in different programs; set them to 0, or, if "
           "they are OpenCV's, set camera_model to FULL_OPENCV");
  lens.model = bends || model.ends_with("OPENCV") ? LensModel::opencv : LensModel::pinhole;
}

void set_size_of(Lens& lens, const Keys& keys, const std::filesystem::path& image,
                 const ImageSizeLookup& size_of_image) {
  const std::optional<double> width = keys.number("w"), height = keys.number("h");
  if (width && height) return set_size(lens, *width, *height, keys.place);
  const std::optional<glm::ivec2> size =
      size_of_image ? size_of_image(image) : std::optional<glm::ivec2>();
  if (!size)
    refuse(keys.place, "neither \"w\" and \"h\" nor the image " + in_quotes(image.string()) +
                           " gives the image's size; add w and h");
  set_size(lens, size->x, size->y, keys.place);
}

std::optional<double> focal_from_angle(const Keys& keys, const char* key, double size_px) {
  const std::optional<double> angle = keys.number(key);
  if (!angle) return std::nullopt;
  if (!(*angle > 0.0 && *angle < kPi))
    refuse(keys.place_of(key), "not between 0 and pi; correct it");
  return 0.5 * size_px / std::tan(0.5 * *angle);
}

void set_focal_length(Lens& lens, const Keys& keys) {
  std::optional<double> x = keys.number("fl_x"), y = keys.number("fl_y");
  if (!x && !y) {
    x = focal_from_angle(keys, "camera_angle_x", lens.width_px);
    y = focal_from_angle(keys, "camera_angle_y", lens.height_px);
  }
  if (!x && !y)
    refuse(keys.place, "no focal length; add fl_x (pixels) or camera_angle_x (radians)");
  lens.focal_px = {x ? *x : *y, y ? *y : *x};
}

Lens lens_from(const Keys& keys, const std::filesystem::path& image,
               const ImageSizeLookup& size_of_image) {
  Lens lens;
  set_model(lens, keys);
  set_size_of(lens, keys, image, size_of_image);
  set_focal_length(lens, keys);
  lens.principal_px = centre_from_corner({keys.number("cx").value_or(0.5 * lens.width_px),
                                          keys.number("cy").value_or(0.5 * lens.height_px)});
  return lens;
}

// NeRF's own files leave the ending out.
std::filesystem::path with_ending(const std::filesystem::path& image) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(image, ignored)) return image;
  for (const char* ending : {".png", ".jpg", ".jpeg", ".JPG", ".exr", ".tif", ".tiff", ".PNG"}) {
    std::filesystem::path candidate = image;
    candidate += ending;
    if (std::filesystem::is_regular_file(candidate, ignored)) return candidate;
  }
  return image;
}

std::filesystem::path beside(const std::filesystem::path& file, std::string listed,
                             const std::string& place) {
  if (has_control_characters(listed)) refuse(place, in_quotes(listed) + " is no path; correct it");
  std::replace(listed.begin(), listed.end(), '\\', '/');
  return (file.parent_path() / listed).lexically_normal();
}

void read_frame(CameraFile& result, const Keys& keys, const std::filesystem::path& file,
                const ImageSizeLookup& size_of_image) {
  const std::string listed = keys.text("file_path"), mask = keys.text("mask_path");
  if (listed.empty()) refuse(keys.place, "no \"file_path\"; add it");
  const std::filesystem::path image = with_ending(beside(file, listed, keys.place));
  Camera camera;
  camera.name = camera_name(image.string(), keys.place_of("file_path"));
  camera.lens = lens_from(keys, image, size_of_image);
  camera.camera_from_world = camera_from_world(keys);
  check(camera, keys.place);
  result.cameras.push_back(camera);
  result.images.push_back(image);
  result.masks.push_back(mask.empty() ? std::filesystem::path() : beside(file, mask, keys.place));
}

std::string model_name(const Lens& lens) {
  if (lens.model == LensModel::pinhole) return "PINHOLE";
  if (lens.model == LensModel::opencv_fisheye) return "OPENCV_FISHEYE";
  const bool rational = std::any_of(lens.distortion.begin() + 5, lens.distortion.end(),
                                    [](double k) { return k != 0.0; });
  return rational ? "FULL_OPENCV" : "OPENCV";
}

void write_lens(ordered_json& target, const Lens& lens) {
  const glm::dvec2 principal = corner_from_centre(lens.principal_px);
  const std::string model = model_name(lens);
  target["camera_model"] = model;
  target["w"] = lens.width_px;
  target["h"] = lens.height_px;
  target["fl_x"] = lens.focal_px.x;
  target["fl_y"] = lens.focal_px.y;
  target["cx"] = principal.x;
  target["cy"] = principal.y;
  const std::vector<const char*> order =
      model == "PINHOLE"          ? std::vector<const char*>{}
      : model == "OPENCV_FISHEYE" ? std::vector{"k1", "k2", "k3", "k4"}
      : model == "OPENCV"         ? std::vector{"k1", "k2", "p1", "p2", "k3"}
                                  : std::vector{"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
  for (std::size_t i = 0; i < order.size(); ++i) target[order[i]] = lens.distortion[i];
}

ordered_json matrix_of(const RigidTransform& camera_from_world) {
  const RigidTransform world_from_camera = inverse(camera_from_world);
  const glm::dmat3 world_from_gl = world_from_camera.rotation * kCameraFromGl;
  ordered_json rows = ordered_json::array();
  for (int row = 0; row < 3; ++row)
    rows.push_back({world_from_gl[0][row], world_from_gl[1][row], world_from_gl[2][row],
                    world_from_camera.translation[row]});
  rows.push_back({0.0, 0.0, 0.0, 1.0});
  return rows;
}

}  // namespace

CameraFile read_transforms_json(const std::filesystem::path& file,
                                const ImageSizeLookup& size_of_image) {
  const json root = parse(file);
  const auto frames = root.is_object() ? root.find("frames") : root.end();
  if (!root.is_object() || frames == root.end() || !frames->is_array())
    refuse(file.string(),
           "no list \"frames\" in it, so it is no transforms.json; give another file");
  CameraFile result;
  for (std::size_t i = 0; i < frames->size(); ++i) {
    const std::string place = file.string() + ", frame " + std::to_string(i);
    if (!(*frames)[i].is_object()) refuse(place, "an object must stand here; correct it");
    read_frame(result, {(*frames)[i], root, place}, file, size_of_image);
  }
  check_set(result.cameras, file.string());
  return result;
}

void write_transforms_json(std::span<const Camera> cameras, const std::filesystem::path& path,
                           Images images) {
  const Lens& first = cameras.front().lens;
  const bool shared = std::all_of(cameras.begin(), cameras.end(),
                                  [&first](const Camera& camera) { return camera.lens == first; });
  ordered_json root, frames = ordered_json::array();
  if (shared) write_lens(root, first);
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    ordered_json frame;
    frame["file_path"] = images[i].generic_string();
    if (!shared) write_lens(frame, cameras[i].lens);
    frame["transform_matrix"] = matrix_of(cameras[i].camera_from_world);
    frames.push_back(std::move(frame));
  }
  root["frames"] = std::move(frames);
  const bool is_file = path.extension() == ".json";
  try {
    write_file_atomically(is_file ? path : path / "transforms.json", root.dump(1) + "\n");
  } catch (const json::exception&) {
    refuse(path.string(), "an image's name is no valid UTF-8, which JSON asks for; rename it");
  }
}

}  // namespace bosk::camera_files
