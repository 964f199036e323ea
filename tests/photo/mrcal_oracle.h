#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace bosk::testing_cameras {

bool has_mrcal();  // whether this build found mrcal; without it the others must not be called

// Where mrcal's own reader and projection put the points; none when it can't read the file.
std::optional<std::vector<glm::dvec2>> project_with_mrcal(const std::filesystem::path& cameramodel,
                                                          const std::vector<glm::dvec3>& world);
// mrcal reads the file and writes it again, in six decimals.
void rewrite_with_mrcal(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace bosk::testing_cameras
