#include "tests/project/random_edits.h"

#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/project/presets.h"
#include "core/project/project_json.h"

namespace bosk {
namespace {

const std::array<std::string, 4> kPhotos{"oak_01", "oak_02", "\xc3\xa4 \"b\"\n", "\xe6\xa8\xb9"};

std::string photo_of(Random& random) { return kPhotos[random.below(kPhotos.size())]; }

Edit random_option(Random& random, const Project& project) {
  switch (random.below(3)) {
    case 0:
      return option_edit(project, "opacity.passes", std::to_string(1 + random.below(9)));
    case 1:
      return option_edit(project, "pack.name", photo_of(random));
    default:
      return option_edit(project, "matte.position_sigma",
                         std::to_string(random.uniform(0.05, 0.4)));
  }
}

Edit random_preset(Random& random, const Project& project) {
  Recipe recipe = project.recipe;
  apply_preset(recipe, presets()[random.below(presets().size())].name);
  return recipe_edit(project, "preset", recipe);
}

// Of a few points, so that many are told of again.
SetSighting random_sighting(Random& random, const Project& project) {
  const std::string point = photo_of(random) + std::to_string(random.below(3));
  std::optional<HandSighting> after;
  if (random.below(3) > 0) {
    after = HandSighting{true, {random.uniform(-9.0, 6000.0), random.uniform(-9.0, 4000.0)}};
  } else if (random.below(2) > 0) {
    after = HandSighting{false, {}};
  }
  return sighting_edit(project, photo_of(random), point, after);
}

SetSightings random_sightings(Random& random, const Project& project) {
  SetSightings edit{photo_of(random), {}};
  std::set<std::pair<std::string, std::string>> seen;
  for (auto left = random.below(6); left > 0; --left) {
    const SetSighting set = random_sighting(random, project);
    if (seen.emplace(set.photo, set.point).second) edit.sightings.push_back(set);
  }
  return edit;
}

SetMeasurements random_measurements(Random& random, const Project& project) {
  Measurements after = project.calibration.measurements;
  const std::string from = photo_of(random), to = photo_of(random) + " too";
  switch (random.below(4)) {
    case 0:
      after.tapes.push_back({from, to, random.uniform(0.1, 9.0), 0.002});
      break;
    case 1:
      after.heights.push_back({from, random.uniform(-1.0, 9.0), 0.005});
      break;
    case 2:
      after.points.push_back({to, glm::dvec3(random.uniform(-9.0, 9.0), 0.1, -1e-300), 0.01});
      break;
    default:
      after = {};
  }
  return measurements_edit(project, after);
}

std::filesystem::path random_path(Random& random) {
  return random.below(4) == 0 ? "" : "../" + photo_of(random) + std::to_string(random.below(100));
}

}  // namespace

Project saved_project(const std::filesystem::path& folder) {
  Project project;
  project.folder = folder;
  project.photos = {"../photos/oak_01.jpg", "../photos/oak_02.jpg", "../photos/oak_03.jpg"};
  save_project(project);
  return project;
}

Stroke random_stroke(Random& random) {
  Stroke stroke{StrokeKind(random.below(4)), random.uniform(0.5, 90.0), {}};
  for (auto left = 1 + random.below(20); left > 0; --left) {
    stroke.points_px.emplace_back(random.uniform(-50.0, 6000.0), random.uniform(-50.0, 4000.0));
  }
  return rounded_stroke(stroke);
}

Edit random_edit(Random& random, const Project& project) {
  switch (random.below(24)) {
    case 0:
      if (random.below(2) == 0) return use_all_edit(project, photo_of(random));
      return clear_edit(project, photo_of(random));
    case 1: {
      auto photos = project.photos;
      photos.push_back(random_path(random));
      if (photos.size() > 9) photos.erase(photos.begin(), photos.begin() + 7);
      return photos_edit(project, photos);
    }
    case 2:
    case 3:
      return files_edit(project, FileKind(random.below(5)), random_path(random));
    case 4:
    case 5:
    case 6:
      return random_option(random, project);
    case 7:
      return random_preset(random, project);
    case 8:
    case 9:
      return random_sighting(random, project);
    case 10:
      return random_sightings(random, project);
    case 11:
      return random_measurements(random, project);
    case 12:
      return RenamePoint{random_sightings(random, project), random_measurements(random, project)};
    default:
      return AddStroke{photo_of(random), random_stroke(random)};
  }
}

std::string content_of(Project project) {
  project.journal = {};
  return project_text(project);
}

}  // namespace bosk
