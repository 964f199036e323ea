#include <stdexcept>

#include "tests/photo/mrcal_oracle.h"

namespace bosk::testing_cameras {

bool has_mrcal() { return false; }
std::optional<std::vector<glm::dvec2>> project_with_mrcal(const std::filesystem::path&,
                                                          const std::vector<glm::dvec3>&) {
  throw std::logic_error("built without mrcal");
}
void rewrite_with_mrcal(const std::filesystem::path&, const std::filesystem::path&) {
  throw std::logic_error("built without mrcal");
}

}  // namespace bosk::testing_cameras
