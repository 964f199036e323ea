#include "core/project/edit.h"

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/project/project_json.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

template <class ProjectType>
auto& files_of(ProjectType& project, FileKind which) {
  switch (which) {
    case FileKind::cameras:
      return project.cameras;
    case FileKind::mattes:
      return project.mattes;
    case FileKind::boards:
      return project.calibration.boards;
    case FileKind::lens:
      return project.calibration.lens;
    default:
      return project.scribbles;
  }
}

std::string files_name(FileKind which) {
  constexpr const char* kNames[] = {"cameras", "mattes", "drawn strokes", "board photos", "lens"};
  return kNames[std::size_t(which)];
}

// Strokes of mattes and of calibration are kept apart, so that neither outdates the other.
Strokes& strokes_for(const AddStroke& edit, Project& project) {
  const bool left_out = edit.stroke.kind == StrokeKind::left_out;
  return left_out ? project.calibration.left_out : project.strokes;
}

void remove_stroke(const AddStroke& edit, Strokes& strokes) {
  const auto photo = strokes.find(edit.photo);
  if (photo == strokes.end()) return;
  std::vector<Stroke>& drawn = photo->second;
  const auto last = std::find(drawn.rbegin(), drawn.rend(), rounded_stroke(edit.stroke));
  if (last != drawn.rend()) drawn.erase(std::prev(last.base()));
  if (drawn.empty()) strokes.erase(photo);
}

void set_strokes(const std::string& photo, const std::vector<Stroke>& drawn, Strokes& strokes) {
  if (drawn.empty()) {
    strokes.erase(photo);
  } else {
    strokes[photo] = drawn;
  }
}

void set_sighting(const SetSighting& edit, const std::optional<HandSighting>& value,
                  HandSightings& sightings) {
  if (value) {
    check(edit.point, *value);
    sightings[edit.photo][edit.point] = value->there ? *value : HandSighting{false, {}};
    return;
  }
  const auto photo = sightings.find(edit.photo);
  if (photo == sightings.end()) return;
  photo->second.erase(edit.point);
  if (photo->second.empty()) sightings.erase(photo);
}

// All or, when one doesn't fit, none.
void set_sightings(const SetSightings& edit, std::optional<HandSighting> SetSighting::*value,
                   HandSightings& sightings) {
  HandSightings trial = sightings;
  for (const SetSighting& set : edit.sightings) set_sighting(set, set.*value, trial);
  sightings = std::move(trial);
}

// Measurements and sightings: both or, when one doesn't fit, neither.
void rename_point(const RenamePoint& edit, std::optional<HandSighting> SetSighting::*seen,
                  Measurements SetMeasurements::*measured, Project& project) {
  const Measurements& wanted = edit.measured.*measured;
  check(wanted);
  set_sightings(edit.seen, seen, project.calibration.sightings);
  project.calibration.measurements = wanted;
}

void set_measurements(const Measurements& wanted, Project& project) {
  check(wanted);
  project.calibration.measurements = wanted;
}

std::string title_of(const SetOption& edit) {
  const bool stops = edit.name.ends_with(".stop_after");
  if (stops && edit.after != "0") return "Stop and keep, pass " + edit.after;
  if (stops) return "all passes";
  const auto shown = [](const std::string& value) { return value.empty() ? "nothing" : value; };
  return edit.name + " " + shown(edit.before) + " to " + shown(edit.after);
}

std::string title_of(const SetOptions& edit) { return edit.what; }

std::string title_of(const SetPhotos& edit) {
  const std::size_t before = edit.before.size(), after = edit.after.size();
  const auto count = [](std::size_t photos) {
    return std::to_string(photos) + (photos == 1 ? " photo" : " photos");
  };
  if (after == before) return "places of photos";
  return after > before ? "adding " + count(after - before) : "removing " + count(before - after);
}

std::string title_of(const SetFiles& edit) {
  return files_name(edit.which) + " " +
         (edit.after.empty() ? "none" : edit.after.filename().string());
}

std::string title_of(const AddStroke& edit) {
  if (edit.stroke.kind == StrokeKind::left_out) return "leaving out a part of " + edit.photo;
  return (edit.stroke.kind == StrokeKind::erase ? "erasing on " : "stroke on ") + edit.photo;
}

std::string title_of(const ClearStrokes& edit) { return "clearing the strokes on " + edit.photo; }

std::string title_of(const UseAll& edit) { return "using all of " + edit.photo; }

std::string title_of(const SetSighting& edit) {
  const std::string where = edit.point + " on " + edit.photo;
  if (!edit.after) return "forgetting " + where;
  if (!edit.after->there) return "removing " + where;
  return (edit.before && edit.before->there ? "moving " : "") + where;
}

std::string title_of(const SetSightings& edit) { return edit.what; }

std::string title_of(const RenamePoint& edit) { return edit.seen.what; }

// What one list gained or lost by one item.
std::string title_of(const SetMeasurements& edit) {
  const auto counted = [](const std::string& what, std::size_t before, std::size_t after) {
    if (before == after) return std::string();
    return (after > before ? "adding " : "removing ") + what;
  };
  for (const std::string& text :
       {counted("a tape", edit.before.tapes.size(), edit.after.tapes.size()),
        counted("a height", edit.before.heights.size(), edit.after.heights.size()),
        counted("a surveyed point", edit.before.points.size(), edit.after.points.size())}) {
    if (!text.empty()) return text;
  }
  return "measurements";
}

void require_text(const std::string& text) {
  if (is_storable(text)) return;
  throw Error(printable(text) + ": the name is not valid UTF-8; rename the file");
}

void check_strokes(const std::string& photo, std::vector<Stroke>& strokes) {
  require_text(photo);
  for (Stroke& stroke : strokes) stroke = rounded_stroke(std::move(stroke));
}

void check_sighting(const SetSighting& edit) {
  require_text(edit.photo);
  require_text(edit.point);
  if (edit.photo.empty()) throw Error("a sighting in no photo; name the photo");
  check(edit.point, edit.after.value_or(HandSighting()));
}

// So that undoing in any order gives the same.
void require_different(const std::vector<SetSighting>& sightings) {
  std::set<std::pair<std::string, std::string>> seen;
  for (const SetSighting& edit : sightings) {
    if (seen.emplace(edit.photo, edit.point).second) continue;
    throw Error(printable(edit.point + " on " + edit.photo) + ": is told twice; keep one of them");
  }
}

void check_sightings(const SetSightings& edit) {
  require_text(edit.what);
  for (const SetSighting& one : edit.sightings) check_sighting(one);
  require_different(edit.sightings);
}

// All or, when one doesn't fit, none.
void set_options(const SetOptions& edit, std::string SetOption::*value, Recipe& recipe) {
  Recipe trial = recipe;
  for (const SetOption& set : edit.options) set_option(trial, set.name, set.*value);
  recipe = trial;
}

std::vector<Stroke> drawn_on(const std::string& photo, const Strokes& strokes) {
  const auto drawn = strokes.find(photo);
  return drawn == strokes.end() ? std::vector<Stroke>() : drawn->second;
}

}  // namespace

void apply(const Edit& edit, Project& project) {
  std::visit(
      Overloaded{
          [&](const SetOption& set) { set_option(project.recipe, set.name, set.after); },
          [&](const SetPhotos& set) { project.photos = set.after; },
          [&](const SetFiles& set) { files_of(project, set.which) = set.after; },
          [&](const AddStroke& add) {
            Stroke stroke = rounded_stroke(add.stroke);
            strokes_for(add, project)[add.photo].push_back(std::move(stroke));
          },
          [&](const ClearStrokes& clear) { project.strokes.erase(clear.photo); },
          [&](const UseAll& all) { project.calibration.left_out.erase(all.photo); },
          [&](const SetOptions& set) { set_options(set, &SetOption::after, project.recipe); },
          [&](const SetSighting& set) {
            set_sighting(set, set.after, project.calibration.sightings);
          },
          [&](const SetSightings& set) {
            set_sightings(set, &SetSighting::after, project.calibration.sightings);
          },
          [&](const SetMeasurements& set) { set_measurements(set.after, project); },
          [&](const RenamePoint& rename) {
            rename_point(rename, &SetSighting::after, &SetMeasurements::after, project);
          },
      },
      edit);
}

void revert(const Edit& edit, Project& project) {
  std::visit(
      Overloaded{
          [&](const SetOption& set) { set_option(project.recipe, set.name, set.before); },
          [&](const SetPhotos& set) { project.photos = set.before; },
          [&](const SetFiles& set) { files_of(project, set.which) = set.before; },
          [&](const AddStroke& add) { remove_stroke(add, strokes_for(add, project)); },
          [&](const ClearStrokes& clear) {
            set_strokes(clear.photo, clear.before, project.strokes);
          },
          [&](const UseAll& all) {
            set_strokes(all.photo, all.before, project.calibration.left_out);
          },
          [&](const SetOptions& set) { set_options(set, &SetOption::before, project.recipe); },
          [&](const SetSighting& set) {
            set_sighting(set, set.before, project.calibration.sightings);
          },
          [&](const SetSightings& set) {
            set_sightings(set, &SetSighting::before, project.calibration.sightings);
          },
          [&](const SetMeasurements& set) { set_measurements(set.before, project); },
          [&](const RenamePoint& rename) {
            rename_point(rename, &SetSighting::before, &SetMeasurements::before, project);
          },
      },
      edit);
}

Edit checked_edit(Edit edit, const Project& project) {
  std::visit(Overloaded{
                 [&](const SetOption& set) {
                   for (const auto& text : {set.before, set.after}) require_text(text);
                   Recipe trial = project.recipe;
                   set_option(trial, set.name, set.after);
                 },
                 [](const SetPhotos& set) {
                   for (const fs::path& path : set.after) require_text(path.string());
                 },
                 [](const SetFiles& set) { require_text(set.after.string()); },
                 [](AddStroke& add) {
                   require_text(add.photo);
                   add.stroke = rounded_stroke(std::move(add.stroke));
                 },
                 [](ClearStrokes& clear) { check_strokes(clear.photo, clear.before); },
                 [](UseAll& all) { check_strokes(all.photo, all.before); },
                 [&](const SetOptions& set) {
                   require_text(set.what);
                   for (const SetOption& option : set.options) {
                     for (const auto& text : {option.before, option.after}) require_text(text);
                   }
                   Recipe trial = project.recipe;
                   set_options(set, &SetOption::after, trial);
                 },
                 [](const SetSighting& set) { check_sighting(set); },
                 [](const SetSightings& set) { check_sightings(set); },
                 [](const SetMeasurements& set) { check(set.after); },
                 [](const RenamePoint& rename) {
                   check_sightings(rename.seen);
                   check(rename.measured.after);
                 },
             },
             edit);
  return edit;
}

std::string title(const Edit& edit) {
  return printable(std::visit([](const auto& kind) { return title_of(kind); }, edit));
}

SetOption option_edit(const Project& project, const std::string& name, const std::string& after) {
  return {name, option_text(project.recipe, name), after};
}

SetOptions recipe_edit(const Project& project, const std::string& what, const Recipe& after) {
  SetOptions edit{what, {}};
  Recipe wanted = after;
  for (const OptionGroup& group : option_groups(wanted)) {
    for (const Option& option : group.options) {
      const SetOption set =
          option_edit(project, group.stage + "." + option.name, value_text(option));
      if (set.before != set.after) edit.options.push_back(set);
    }
  }
  return edit;
}

SetPhotos photos_edit(const Project& project, std::vector<fs::path> after) {
  return {project.photos, std::move(after)};
}

SetFiles files_edit(const Project& project, FileKind which, const fs::path& after) {
  return {which, files_of(project, which), after};
}

ClearStrokes clear_edit(const Project& project, const std::string& photo) {
  return {photo, drawn_on(photo, project.strokes)};
}

UseAll use_all_edit(const Project& project, const std::string& photo) {
  return {photo, drawn_on(photo, project.calibration.left_out)};
}

SetSighting sighting_edit(const Project& project, const std::string& photo,
                          const std::string& point, const std::optional<HandSighting>& after) {
  SetSighting edit{photo, point, std::nullopt, after};
  const HandSightings& all = project.calibration.sightings;
  const auto points = all.find(photo);
  if (points == all.end()) return edit;
  const auto said = points->second.find(point);
  if (said != points->second.end()) edit.before = said->second;
  return edit;
}

SetMeasurements measurements_edit(const Project& project, Measurements after) {
  return {project.calibration.measurements, std::move(after)};
}

}  // namespace bosk
