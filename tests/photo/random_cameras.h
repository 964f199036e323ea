#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/random.h"
#include "core/photo/camera.h"

namespace bosk::testing_cameras {

// A lens as phones and fisheyes have them: every parameter of the model is used; up to
// `distortions` of OpenCV's eight.
Lens random_lens(Random& random, LensModel model, int distortions = 8);
RigidTransform random_pose(Random& random);
// A point in the camera's frame, 1 to 20 m away and within 35 degrees of the axis, where no random
// lens folds.
glm::dvec3 random_point_in_camera(Random& random);
std::vector<Camera> random_cameras(Random& random, int count, const std::vector<LensModel>& models);

// A new empty folder, removed with all in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  // Writes a file, making folders on the way, and returns its path.
  std::filesystem::path write(const std::filesystem::path& name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

}  // namespace bosk::testing_cameras
