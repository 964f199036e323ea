#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/matte/strokes.h"
#include "core/project/project.h"

namespace bosk {

// What a person does to a project, each with what undoing it needs. Paths are as in Project:
// relative to its folder, empty for none. Texts are UTF-8.
struct SetOption {
  std::string name;  // "stage.option"
  std::string before, after;
  bool operator==(const SetOption&) const = default;
};
// Several options at once, as a preset does; those that the project has already are left out.
struct SetOptions {
  std::string what;  // for the title: "preset fast"
  std::vector<SetOption> options;
  bool operator==(const SetOptions&) const = default;
};
struct SetPhotos {
  std::vector<std::filesystem::path> before, after;
  bool operator==(const SetPhotos&) const = default;
};
enum class FileKind : std::uint8_t { cameras, mattes, scribbles, boards, lens };
struct SetFiles {
  FileKind which = FileKind::cameras;
  std::filesystem::path before, after;
  bool operator==(const SetFiles&) const = default;
};
// A stroke of a matte or, by its kind, of what calibration leaves out.
struct AddStroke {
  std::string photo;  // its name
  Stroke stroke;
  bool operator==(const AddStroke&) const = default;
};
struct ClearStrokes {
  std::string photo;
  std::vector<Stroke> before;  // all that the photo has
  bool operator==(const ClearStrokes&) const = default;
};
// The same of what calibration leaves out.
struct UseAll {
  std::string photo;
  std::vector<Stroke> before;
  bool operator==(const UseAll&) const = default;
};
// Of calibration: where a point is seen in a photo, that it isn't, or (none) that nothing is said.
struct SetSighting {
  std::string photo, point;
  std::optional<HandSighting> before, after;
  bool operator==(const SetSighting&) const = default;
};
// Several at once: clicks from a file, a ball taken for another in a photo.
struct SetSightings {
  std::string what;  // for the title: "clicks.json"
  std::vector<SetSighting> sightings;
  bool operator==(const SetSightings&) const = default;
};
struct SetMeasurements {
  Measurements before, after;
  bool operator==(const SetMeasurements&) const = default;
};
// A point under another name, wherever it is seen and measured.
struct RenamePoint {
  SetSightings seen;
  SetMeasurements measured;
  bool operator==(const RenamePoint&) const = default;
};
using Edit = std::variant<SetOption, SetPhotos, SetFiles, AddStroke, ClearStrokes, SetOptions,
                          SetSighting, SetSightings, SetMeasurements, RenamePoint, UseAll>;

// `apply` sets what the edit says, whatever was there; `revert` puts back what was before it, also
// when something else changed in between: an option its `before`, of a photo's strokes the last
// that equals the one added. Both throw Error, and change nothing, where an option is unknown or
// its value doesn't fit, a stroke is none (rounded_stroke), or a sighting or measurement is none
// (calibration_inputs.h).
void apply(const Edit& edit, Project& project);
void revert(const Edit& edit, Project& project);

// The edit as it is kept (strokes rounded). Throws Error when it doesn't fit the project, or a name
// in it is not valid UTF-8 and so could not be saved.
Edit checked_edit(Edit edit, const Project& project);

// For "Undo ...": "stroke on oak_03", "opacity.cell_px 3.6 to 2.8".
std::string title(const Edit& edit);

// Edits that leave the project as the wanted one, with `before` filled in from it.
SetOption option_edit(const Project& project, const std::string& name, const std::string& after);
SetOptions recipe_edit(const Project& project, const std::string& what, const Recipe& after);
SetPhotos photos_edit(const Project& project, std::vector<std::filesystem::path> after);
SetFiles files_edit(const Project& project, FileKind which, const std::filesystem::path& after);
ClearStrokes clear_edit(const Project& project, const std::string& photo);
UseAll use_all_edit(const Project& project, const std::string& photo);
SetSighting sighting_edit(const Project& project, const std::string& photo,
                          const std::string& point, const std::optional<HandSighting>& after);
SetMeasurements measurements_edit(const Project& project, Measurements after);

}  // namespace bosk
