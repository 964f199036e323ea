#include <algorithm>
#include <array>
#include <charconv>

#include "core/base/atomic_file.h"
#include "core/geometry/rotation.h"
#include "core/photo/camera_files_parts.h"
#include "core/photo/python_literal.h"

// mrcal's .cameramodel: one camera, a Python dictionary that is read, not run:
//   { 'lensmodel': 'LENSMODEL_OPENCV8', 'intrinsics': [fx, fy, cx, cy, k1, k2, p1, p2, ...],
//     'extrinsics': [Rodrigues vector, translation of camera_from_reference], 'imagersize': [w, h]
//     }
// Pixels count from the centre, as here. Read with an own parser: mrcal's depends on the locale and
// prints to standard error.
namespace bosk::camera_files {
namespace {

constexpr std::uint64_t kMaxBytes = std::uint64_t(256) << 20;  // optimization_inputs can be long

struct MrcalModel {
  std::string_view name;
  LensModel lens;
  std::size_t distortions;
};
constexpr std::array<MrcalModel, 4> kModels{{
    {"LENSMODEL_PINHOLE", LensModel::pinhole, 0},
    {"LENSMODEL_OPENCV4", LensModel::opencv, 4},
    {"LENSMODEL_OPENCV5", LensModel::opencv, 5},
    {"LENSMODEL_OPENCV8", LensModel::opencv, 8},
}};

const MrcalModel& mrcal_model(std::string name, const std::string& place) {
  if (name.starts_with("DISTORTION_")) name.replace(0, 10, "LENSMODEL");  // mrcal before 1.0
  for (const MrcalModel& model : kModels)
    if (model.name == name) return model;
  refuse(place,
         "the lens model " + in_quotes(name) +
             " is not supported; convert it by mrcal-convert-lensmodel to LENSMODEL_OPENCV8");
}

const MrcalModel& mrcal_model_of(const Lens& lens, const std::string& place) {
  if (lens.model == LensModel::opencv_fisheye)
    refuse(place, "mrcal has no fisheye model of OpenCV; choose the format colmap or transforms");
  if (lens.model == LensModel::pinhole) return kModels[0];
  const auto last = std::find_if(lens.distortion.rbegin(), lens.distortion.rend(),
                                 [](double k) { return k != 0.0; });
  const auto used = lens.distortion.rend() - last;
  return kModels[used <= 4 ? 1 : used == 5 ? 2 : 3];
}

struct Parts {
  std::string lensmodel;
  std::vector<double> intrinsics, extrinsics, imagersize;
};

Parts parse(PythonLiteral text) {
  Parts parts;
  text.each_key([&](const std::string& key) {
    if (key == "lensmodel" || key == "lens_model" || key == "distortion_model")
      parts.lensmodel = text.string();
    else if (key == "intrinsics")
      parts.intrinsics = text.numbers();
    else if (key == "extrinsics")
      parts.extrinsics = text.numbers();
    else if (key == "imagersize")
      parts.imagersize = text.numbers();
    else
      text.skip_value();
  });
  return parts;
}

void expect_count(const std::vector<double>& numbers, std::size_t count, const char* key,
                  const std::string& place) {
  if (numbers.size() != count)
    refuse(place, std::string("the key '") + key + "' must hold " + std::to_string(count) +
                      " numbers, not " + std::to_string(numbers.size()) + "; correct it");
}

Camera read_one(const std::filesystem::path& file) {
  const std::string place = file.string(), text = read_text(file, kMaxBytes);
  const Parts parts = parse(PythonLiteral(text, place));
  if (parts.lensmodel.empty()) refuse(place, "the key 'lensmodel' is missing; export it again");
  const MrcalModel& model = mrcal_model(parts.lensmodel, place);
  expect_count(parts.intrinsics, 4 + model.distortions, "intrinsics", place);
  expect_count(parts.extrinsics, 6, "extrinsics", place);
  expect_count(parts.imagersize, 2, "imagersize", place);
  const std::vector<double>& p = parts.intrinsics;
  const std::vector<double>& rt = parts.extrinsics;
  Camera camera;
  camera.name = camera_name(file.filename().string(), place);
  camera.lens.model = model.lens;
  camera.lens.focal_px = {p[0], p[1]};
  camera.lens.principal_px = {p[2], p[3]};
  std::copy(p.begin() + 4, p.end(), camera.lens.distortion.begin());
  set_size(camera.lens, parts.imagersize[0], parts.imagersize[1], place);
  camera.camera_from_world = {rotation_from_rodrigues({rt[0], rt[1], rt[2]}),
                              {rt[3], rt[4], rt[5]}};
  check(camera, place);
  return camera;
}

std::string list_of(std::span<const double> numbers) {
  std::string text = "[";
  for (const double number : numbers) text += " " + text_from(number) + ",";
  return text + "]";
}

std::string text_of(const Camera& camera, const std::string& place) {
  const Lens& lens = camera.lens;
  const MrcalModel& model = mrcal_model_of(lens, place);
  std::vector<double> intrinsics{lens.focal_px.x, lens.focal_px.y, lens.principal_px.x,
                                 lens.principal_px.y};
  intrinsics.insert(intrinsics.end(), lens.distortion.begin(),
                    lens.distortion.begin() + std::ptrdiff_t(model.distortions));
  const glm::dvec3 r = rodrigues_from_rotation(camera.camera_from_world.rotation);
  const glm::dvec3 t = camera.camera_from_world.translation;
  return "{\n    'lensmodel':  '" + std::string(model.name) +
         "',\n\n    # fx, fy, cx, cy, distortion\n    'intrinsics': " + list_of(intrinsics) +
         ",\n\n    # Rodrigues vector and translation, camera from reference\n    'extrinsics': " +
         list_of(std::array{r.x, r.y, r.z, t.x, t.y, t.z}) + ",\n\n    'imagersize': [ " +
         std::to_string(lens.width_px) + ", " + std::to_string(lens.height_px) + ",]\n}\n";
}

}  // namespace

CameraFile read_cameramodel(std::span<const std::filesystem::path> files) {
  CameraFile result;
  for (const std::filesystem::path& file : files) result.cameras.push_back(read_one(file));
  result.images.resize(files.size());
  result.masks.resize(files.size());
  check_set(result.cameras, files.empty() ? "the list of .cameramodel files" : files[0].string());
  return result;
}

void write_cameramodel(std::span<const Camera> cameras, const std::filesystem::path& path, Images) {
  const bool is_file = path.extension() == ".cameramodel";
  if (is_file && cameras.size() > 1)
    refuse(path.string(), "a .cameramodel holds one camera, not " + std::to_string(cameras.size()) +
                              "; give a folder");
  std::vector<std::string> texts;  // all before the first is written
  for (const Camera& camera : cameras)
    texts.push_back(text_of(camera, "camera " + in_quotes(camera.name)));
  for (std::size_t i = 0; i < cameras.size(); ++i)
    write_file_atomically(is_file ? path : path / (cameras[i].name + ".cameramodel"), texts[i]);
}

}  // namespace bosk::camera_files
