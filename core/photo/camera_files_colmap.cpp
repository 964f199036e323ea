#include "core/photo/camera_files_colmap.h"

#include <algorithm>
#include <array>
#include <glm/gtc/quaternion.hpp>
#include <limits>

namespace bosk::camera_files {
namespace {

constexpr std::array<ColmapModel, 9> kModels{{
    {0, "SIMPLE_PINHOLE", LensModel::pinhole, 1, 0},
    {1, "PINHOLE", LensModel::pinhole, 2, 0},
    {2, "SIMPLE_RADIAL", LensModel::opencv, 1, 1},
    {3, "RADIAL", LensModel::opencv, 1, 2},
    {4, "OPENCV", LensModel::opencv, 2, 4},
    {5, "OPENCV_FISHEYE", LensModel::opencv_fisheye, 2, 4},
    {6, "FULL_OPENCV", LensModel::opencv, 2, 8},
    {8, "SIMPLE_RADIAL_FISHEYE", LensModel::opencv_fisheye, 1, 1},
    {9, "RADIAL_FISHEYE", LensModel::opencv_fisheye, 1, 2},
}};

// Names, for the message, of ids that COLMAP has and Bosk lacks.
std::string name_of_unknown(std::int32_t id) {
  switch (id) {
    case 7:
      return "FOV";
    case 10:
      return "THIN_PRISM_FISHEYE";
    case 11:
      return "RAD_TAN_THIN_PRISM_FISHEYE";
    default:
      return "number " + std::to_string(id);
  }
}

[[noreturn]] void refuse_model(const std::string& name, const std::string& place) {
  std::string known;
  for (const ColmapModel& model : kModels) known += " " + std::string(model.name);
  refuse(place, "the camera model " + name +
                    " is not supported; undistort the photos with COLMAP or "
                    "use one of" +
                    known);
}

}  // namespace

const ColmapModel& colmap_model(std::string_view name, const std::string& place) {
  for (const ColmapModel& model : kModels)
    if (model.name == name) return model;
  refuse_model(in_quotes(name), place);
}

const ColmapModel& colmap_model(std::int32_t id, const std::string& place) {
  for (const ColmapModel& model : kModels)
    if (model.id == id) return model;
  refuse_model(name_of_unknown(id), place);
}

const ColmapModel& colmap_model_of(const Lens& lens) {
  if (lens.model == LensModel::pinhole) return colmap_model("PINHOLE", "");
  if (lens.model == LensModel::opencv_fisheye) return colmap_model("OPENCV_FISHEYE", "");
  const bool four = std::all_of(lens.distortion.begin() + 4, lens.distortion.end(),
                                [](double k) { return k == 0.0; });
  return colmap_model(four ? "OPENCV" : "FULL_OPENCV", "");
}

void set_parameters(Lens& lens, const ColmapModel& model, std::span<const double> parameters) {
  const std::size_t focals = std::size_t(model.focal_lengths);
  lens.model = model.lens;
  lens.focal_px = {parameters[0], parameters[focals - 1]};
  lens.principal_px = centre_from_corner({parameters[focals], parameters[focals + 1]});
  lens.distortion = {};
  std::copy(parameters.begin() + std::ptrdiff_t(focals) + 2, parameters.end(),
            lens.distortion.begin());
}

std::vector<double> parameters_of(const Lens& lens, const ColmapModel& model) {
  const glm::dvec2 principal = corner_from_centre(lens.principal_px);
  std::vector<double> result{lens.focal_px.x, lens.focal_px.y, principal.x, principal.y};
  result.insert(result.end(), lens.distortion.begin(), lens.distortion.begin() + model.distortions);
  return result;
}

void add_lens(ColmapLenses& lenses, std::uint64_t id, const Lens& lens, const std::string& place) {
  check({"", lens, {}}, place);
  if (id > std::numeric_limits<std::uint32_t>::max() ||
      !lenses.emplace(std::uint32_t(id), lens).second)
    refuse(place, "camera " + std::to_string(id) +
                      " is listed twice or its number is too large; export the model again");
}

void add_image(CameraFile& result, const ColmapLenses& lenses, std::uint64_t camera_id,
               const glm::dvec4& wxyz, const glm::dvec3& translation, std::string_view image,
               const std::string& place) {
  const auto lens = camera_id <= std::numeric_limits<std::uint32_t>::max()
                        ? lenses.find(std::uint32_t(camera_id))
                        : lenses.end();
  if (lens == lenses.end())
    refuse(place, "camera " + std::to_string(camera_id) +
                      " is not among the model's cameras; give the cameras file of the same model");
  const RigidTransform pose{rotation_from_quaternion(wxyz, place), translation};
  result.cameras.push_back({camera_name(image, place), lens->second, pose});
  check(result.cameras.back(), place);
  result.images.emplace_back(image);
  result.masks.emplace_back();
}

SharedLenses shared_lenses(std::span<const Camera> cameras) {
  SharedLenses result;
  for (const Camera& camera : cameras) {
    const auto found = std::find(result.lenses.begin(), result.lenses.end(), camera.lens);
    result.of_camera.push_back(std::size_t(found - result.lenses.begin()));
    if (found == result.lenses.end()) result.lenses.push_back(camera.lens);
  }
  return result;
}

glm::dvec4 wxyz_from_rotation(const glm::dmat3& rotation) {
  const glm::dquat q = glm::normalize(glm::quat_cast(rotation));
  return {q.w, q.x, q.y, q.z};
}

}  // namespace bosk::camera_files
