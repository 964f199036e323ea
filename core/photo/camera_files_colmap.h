#pragma once

// COLMAP's camera models (sensor/models.h) and what its text and binary files share.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/photo/camera_files_parts.h"

namespace bosk::camera_files {

struct ColmapModel {
  std::int32_t id;
  std::string_view name;
  LensModel lens;
  int focal_lengths;  // 1: shared by x and y
  int distortions;    // after focal lengths and principal point, in Lens::distortion's order
  int parameters() const { return focal_lengths + 2 + distortions; }
};

// Throws Error, naming the model, for one that Bosk doesn't know.
const ColmapModel& colmap_model(std::string_view name, const std::string& place);
const ColmapModel& colmap_model(std::int32_t id, const std::string& place);
// The smallest model of COLMAP that holds the lens with both focal lengths.
const ColmapModel& colmap_model_of(const Lens& lens);

void set_parameters(Lens& lens, const ColmapModel& model, std::span<const double> parameters);
std::vector<double> parameters_of(const Lens& lens, const ColmapModel& model);

// Lenses by COLMAP's camera id.
using ColmapLenses = std::map<std::uint32_t, Lens>;
void add_lens(ColmapLenses& lenses, std::uint64_t id, const Lens& lens, const std::string& place);
// Adds one image of the model; wxyz and translation are camera_from_world.
void add_image(CameraFile& result, const ColmapLenses& lenses, std::uint64_t camera_id,
               const glm::dvec4& wxyz, const glm::dvec3& translation, std::string_view image,
               const std::string& place);

// The different lenses, in order of first use, and which of them each camera has.
struct SharedLenses {
  std::vector<Lens> lenses;
  std::vector<std::size_t> of_camera;
};
SharedLenses shared_lenses(std::span<const Camera> cameras);
glm::dvec4 wxyz_from_rotation(const glm::dmat3& rotation);

}  // namespace bosk::camera_files
