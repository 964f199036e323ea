#include "core/project/calibration_sources.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/photo/import.h"
#include "core/photo/photo_format.h"
#include "core/project/left_out.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

// Raised whenever the same sources give another calibration.
constexpr int kVersion = 3;

FilesByName board_files(const fs::path& folder) {
  FilesByName photos;
  for (const auto& [name, path] : files_in(folder)) {
    if (has_photo_ending(path)) photos.emplace(name, path);
  }
  if (photos.empty()) {
    throw Error(printable(folder.string()) + ": holds no photos of a board; name another folder");
  }
  return photos;
}

void hash_options(ContentHasher& hasher, CalibrateOptions options) {
  for (const Option& option : describe(options)) hasher.text(option.name).text(value_text(option));
}

void hash_sightings(ContentHasher& hasher, const HandSightings& sightings) {
  hasher.value(std::uint64_t(sightings.size()));
  for (const auto& [photo, points] : sightings) {
    hasher.text(photo).value(std::uint64_t(points.size()));
    for (const auto& [point, said] : points) {
      hasher.text(point).value(std::uint8_t(said.there)).value(said.pixel.x).value(said.pixel.y);
    }
  }
}

void hash_measurements(ContentHasher& hasher, const Measurements& measurements) {
  hasher.value(std::uint64_t(measurements.tapes.size()));
  for (const Tape& tape : measurements.tapes) {
    hasher.text(tape.from).text(tape.to).value(tape.length_m).value(tape.sigma_m);
  }
  hasher.value(std::uint64_t(measurements.heights.size()));
  for (const Height& height : measurements.heights) {
    hasher.text(height.point).value(height.height_m).value(height.sigma_m);
  }
  hasher.value(std::uint64_t(measurements.points.size()));
  for (const SurveyedPoint& point : measurements.points) {
    hasher.text(point.point).value(point.sigma_m);
    for (int i = 0; i < 3; ++i) hasher.value(point.in_world[i]);
  }
}

// What is told of photos that the project has; a remark for each other.
template <class Told>
void take_of_photos(const std::string& what, const Told& told, CalibrationSources& sources,
                    Told& taken) {
  for (const auto& [name, things] : told) {
    const bool is_photo =
        std::any_of(sources.photos.begin(), sources.photos.end(),
                    [&photo = name](const SourceFile& file) { return file.name == photo; });
    if (is_photo) {
      taken[name] = things;
    } else {
      sources.remarks.push_back(what + " on " + printable(name) +
                                " are not used: the project has no photo of that name");
    }
  }
}

}  // namespace

CalibrationSources gather_calibration(const Project& project) {
  CalibrationSources sources;
  if (project.photos.empty()) {
    throw Error(printable(project.folder.string()) +
                ": the project has no photos; add some with `bosk new --replace`");
  }
  sources.photos = source_files(photo_files(project));
  const CalibrationInputs& inputs = project.calibration;
  if (!inputs.boards.empty()) {
    sources.boards = source_files(board_files(project.absolute(inputs.boards)));
  }
  if (!inputs.lens.empty()) {
    const fs::path profile = project.absolute(inputs.lens);
    sources.profile = source_files({{profile.stem().string(), profile}}).front();
  }
  sources.options = project.recipe.calibrate;
  sources.limits = decode_limits(project.recipe.photo);
  take_inputs(sources, inputs);
  return sources;
}

void take_inputs(CalibrationSources& sources, const CalibrationInputs& inputs) {
  sources.sightings.clear();
  sources.left_out.clear();
  sources.remarks.clear();
  sources.measurements = inputs.measurements;
  take_of_photos("clicks", inputs.sightings, sources, sources.sightings);
  take_of_photos("parts left out", inputs.left_out, sources, sources.left_out);
}

ContentHash calibration_key(const CalibrationSources& sources) {
  ContentHasher hasher;
  hasher.text("calibrate").value(kVersion);
  CalibrateOptions options = sources.options;
  options.refine = CalibrateOptions().refine;  // comes after
  hash_options(hasher, options);
  hash_files(hasher, sources.photos);
  hash_files(hasher, sources.boards);
  if (sources.profile) {
    hasher.value(sources.profile->content.high).value(sources.profile->content.low);
  }
  hash_sightings(hasher, sources.sightings);
  hash_left_out(hasher, sources.left_out);
  hash_measurements(hasher, sources.measurements);
  return hasher.finish();
}

}  // namespace bosk
