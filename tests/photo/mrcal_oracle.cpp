#include "tests/photo/mrcal_oracle.h"

#include <memory>
#include <stdexcept>

// The header has no extern "C" of its own and isn't clean under our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wconversion"
extern "C" {
#include <mrcal/mrcal.h>
}
#pragma GCC diagnostic pop

namespace bosk::testing_cameras {
namespace {

struct Free {
  void operator()(mrcal_cameramodel_t* model) const { mrcal_free_cameramodel(&model); }
};
using Model = std::unique_ptr<mrcal_cameramodel_t, Free>;

}  // namespace

bool has_mrcal() { return true; }

std::optional<std::vector<glm::dvec2>> project_with_mrcal(const std::filesystem::path& cameramodel,
                                                          const std::vector<glm::dvec3>& world) {
  const Model model(mrcal_read_cameramodel_file(cameramodel.c_str()));
  if (!model) return std::nullopt;
  std::vector<glm::dvec2> pixels;
  for (const glm::dvec3& point : world) {
    mrcal_point3_t in_camera{};
    mrcal_transform_point_rt(in_camera.xyz, nullptr, nullptr, model->rt_cam_ref, &point.x);
    mrcal_point2_t pixel{};
    if (!mrcal_project(&pixel, nullptr, nullptr, &in_camera, 1, &model->lensmodel,
                       model->intrinsics))
      return std::nullopt;
    pixels.emplace_back(pixel.x, pixel.y);
  }
  return pixels;
}

void rewrite_with_mrcal(const std::filesystem::path& from, const std::filesystem::path& to) {
  const Model model(mrcal_read_cameramodel_file(from.c_str()));
  if (!model || !mrcal_write_cameramodel_file(to.c_str(), model.get()))
    throw std::runtime_error("mrcal can't rewrite " + from.string());
}

}  // namespace bosk::testing_cameras
