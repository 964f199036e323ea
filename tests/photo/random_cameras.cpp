#include "tests/photo/random_cameras.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "core/geometry/rotation.h"

namespace bosk::testing_cameras {
namespace {

glm::dvec3 random_unit(Random& random) {
  return glm::normalize(glm::dvec3(random.normal(), random.normal(), random.normal()));
}

}  // namespace

Lens random_lens(Random& random, LensModel model, int distortions) {
  Lens lens;
  lens.model = model;
  lens.width_px = 200 + int(random.below(8000));
  lens.height_px = 200 + int(random.below(8000));
  lens.focal_px = {random.uniform(300.0, 6000.0), random.uniform(300.0, 6000.0)};
  lens.principal_px = {random.uniform(0.3, 0.7) * lens.width_px,
                       random.uniform(0.3, 0.7) * lens.height_px};
  if (model == LensModel::pinhole) return lens;
  const int used = model == LensModel::opencv ? distortions : 4;
  const double radial = 0.15, tangential = 0.003;
  for (int i = 0; i < used; ++i) {
    const double size = model == LensModel::opencv && (i == 2 || i == 3) ? tangential : radial;
    lens.distortion[std::size_t(i)] = random.uniform(-size, size);
  }
  return lens;
}

RigidTransform random_pose(Random& random) {
  const glm::dvec3 translation = random.uniform(0.0, 50.0) * random_unit(random);
  return {rotation_from_rodrigues(random.uniform(0.0, 3.14) * random_unit(random)), translation};
}

glm::dvec3 random_point_in_camera(Random& random) {
  const double distance = random.uniform(1.0, 20.0);
  const double slope = std::tan(35.0 / 180.0 * 3.14159265358979) * random.uniform();
  const double turn = random.uniform(0.0, 6.28318530717959);
  return distance * glm::dvec3(slope * std::cos(turn), slope * std::sin(turn), 1.0);
}

std::vector<Camera> random_cameras(Random& random, int count,
                                   const std::vector<LensModel>& models) {
  std::vector<Camera> cameras;
  for (int i = 0; i < count; ++i) {
    const LensModel model = models[random.below(models.size())];
    const int distortions[] = {2, 4, 5, 8};
    cameras.push_back({"view." + std::to_string(i),
                       random_lens(random, model, distortions[random.below(4)]),
                       random_pose(random)});
  }
  return cameras;
}

TemporaryFolder::TemporaryFolder() {
  // In memory where the system has such a folder: every file written is synced, a thousand take 10
  // s on disk.
  std::error_code ignored;
  const bool in_memory = std::filesystem::is_directory("/dev/shm", ignored);
  const std::filesystem::path parent =
      in_memory ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path();
  std::string name = (parent / "bosk-cameras-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::filesystem::filesystem_error("mkdtemp", {});
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(const std::filesystem::path& name,
                                             std::string_view text) const {
  std::filesystem::path file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary).write(text.data(), std::streamsize(text.size()));
  return file;
}

}  // namespace bosk::testing_cameras
