#include "core/project/edit.h"

#include <algorithm>

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
  if (which == FileKind::mattes) return project.mattes;
  return which == FileKind::cameras ? project.cameras : project.scribbles;
}

std::string files_name(FileKind which) {
  if (which == FileKind::mattes) return "mattes";
  return which == FileKind::cameras ? "cameras" : "drawn strokes";
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
  return (edit.stroke.kind == StrokeKind::erase ? "erasing on " : "stroke on ") + edit.photo;
}

std::string title_of(const ClearStrokes& edit) { return "clearing the strokes on " + edit.photo; }

void require_text(const std::string& text) {
  if (is_storable(text)) return;
  throw Error(printable(text) + ": the name is not valid UTF-8; rename the file");
}

// All or, when one doesn't fit, none.
void set_options(const SetOptions& edit, std::string SetOption::*value, Recipe& recipe) {
  Recipe trial = recipe;
  for (const SetOption& set : edit.options) set_option(trial, set.name, set.*value);
  recipe = trial;
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
            project.strokes[add.photo].push_back(std::move(stroke));
          },
          [&](const ClearStrokes& clear) { project.strokes.erase(clear.photo); },
          [&](const SetOptions& set) { set_options(set, &SetOption::after, project.recipe); },
      },
      edit);
}

void revert(const Edit& edit, Project& project) {
  std::visit(
      Overloaded{
          [&](const SetOption& set) { set_option(project.recipe, set.name, set.before); },
          [&](const SetPhotos& set) { project.photos = set.before; },
          [&](const SetFiles& set) { files_of(project, set.which) = set.before; },
          [&](const AddStroke& add) { remove_stroke(add, project.strokes); },
          [&](const ClearStrokes& clear) {
            set_strokes(clear.photo, clear.before, project.strokes);
          },
          [&](const SetOptions& set) { set_options(set, &SetOption::before, project.recipe); },
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
                 [](ClearStrokes& clear) {
                   require_text(clear.photo);
                   for (Stroke& stroke : clear.before) stroke = rounded_stroke(std::move(stroke));
                 },
                 [&](const SetOptions& set) {
                   require_text(set.what);
                   for (const SetOption& option : set.options) {
                     for (const auto& text : {option.before, option.after}) require_text(text);
                   }
                   Recipe trial = project.recipe;
                   set_options(set, &SetOption::after, trial);
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
  const auto drawn = project.strokes.find(photo);
  return {photo, drawn == project.strokes.end() ? std::vector<Stroke>() : drawn->second};
}

}  // namespace bosk
