#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands.h"
#include "core/base/number_text.h"
#include "core/base/system_error.h"
#include "core/package/container.h"
#include "core/package/reader.h"
#include "core/project/run.h"
#include "core/project/stages.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::size_t total_codewords(const TreeModel& tree) {
  std::size_t codewords = 0;
  for (const TreeLevel& level : tree.levels) {
    codewords += level.alpha_codes.count + level.colour_codes.count;
  }
  return codewords;
}

// Where the bytes of a package go.
struct PartBytes {
  const char* name;
  std::uint32_t type;
};
constexpr PartBytes kLevelParts[] = {{"cells", kCellsSection},
                                     {"live", kLiveSection},
                                     {"alpha", kAlphaSection},
                                     {"colour", kColourSection}};
constexpr PartBytes kSharedParts[] = {{"codewords", kAtlasSection}, {"codewords_bc3", kBc3Section}};

std::size_t part_bytes(const Container& container, const PartBytes& part, std::size_t level = 0) {
  const SectionEntry* entry = find_section(container, part.type, std::uint32_t(level));
  return entry ? entry->length : 0;
}

std::string parts_text(const Container& container, std::span<const PartBytes> parts,
                       std::size_t level = 0) {
  std::string text;
  for (const PartBytes& part : parts) {
    text += (text.empty() ? "" : ", ") + std::string(part.name) + " " +
            size_text(part_bytes(container, part, level));
  }
  return text;
}

Json parts_json(const Container& container, std::span<const PartBytes> parts,
                std::size_t level = 0) {
  Json json;
  for (const PartBytes& part : parts) json[part.name] = part_bytes(container, part, level);
  return json;
}

std::string level_text(const TreeLevel& level) {
  const std::size_t textures = level.cells.size() * level.views.size();
  return "  level " + std::to_string(level.level) + ": " + std::to_string(level.cells.size()) +
         " cells, " + std::to_string(level.views.size()) + " views, " + std::to_string(textures) +
         " textures of " + std::to_string(level.texels) + "x" + std::to_string(level.texels) +
         " texels, for cells up to " + number_text(double(level.max_cell_px), 1) + " px\n";
}

std::string tree_text(const std::string& file, const TreeModel& tree, const Container& container) {
  const TreeMetadata& about = tree.metadata;
  std::string text =
      printable(file) + ": package of a tree, " + size_text(container.file.size()) + "\n";
  text += "  name: " + printable(about.name) + "\n";
  if (!about.licence.empty()) text += "  licence: " + printable(about.licence) + "\n";
  if (!about.credit.empty()) text += "  credit: " + printable(about.credit) + "\n";
  text += "  made by: " + printable(about.generator) + " from " +
          std::to_string(about.photo_count) +
          " photos\n  height: " + number_text(about.height_m, 2) + " " + printable(about.units) +
          ", cube of " + number_text(tree.size_m, 2) + " " + printable(about.units) + "\n";
  for (std::size_t i = 0; i < tree.levels.size(); ++i) {
    text += level_text(tree.levels[i]) + "    " + parts_text(container, kLevelParts, i) + "\n";
  }
  text += "  codewords: " + std::to_string(total_codewords(tree)) + " in an atlas of " +
          std::to_string(tree.atlas.width_px) + "x" + std::to_string(tree.atlas.height_px) +
          " texels\n    " + parts_text(container, kSharedParts) + "\n";
  return text;
}

Json level_json(const TreeLevel& level) {
  return {{"level", level.level},
          {"cells", level.cells.size()},
          {"views", level.views.size()},
          {"texels", level.texels},
          {"side_factor", level.side_factor},
          {"max_cell_px", level.max_cell_px},
          {"colour_codewords", level.colour_codes.count},
          {"alpha_codewords", level.alpha_codes.count}};
}

Json tree_json(const TreeModel& tree, const Container& container) {
  const TreeMetadata& about = tree.metadata;
  Json levels = Json::array();
  for (std::size_t i = 0; i < tree.levels.size(); ++i) {
    levels.push_back(level_json(tree.levels[i]));
    levels.back()["bytes"] = parts_json(container, kLevelParts, i);
  }
  return {{"kind", "package"},
          {"bytes", container.file.size()},
          {"codeword_bytes", parts_json(container, kSharedParts)},
          {"name", about.name},
          {"licence", about.licence},
          {"credit", about.credit},
          {"generator", about.generator},
          {"units", about.units},
          {"height_m", about.height_m},
          {"photos", about.photo_count},
          {"origin", {tree.origin.x, tree.origin.y, tree.origin.z}},
          {"size_m", tree.size_m},
          {"levels", levels},
          {"atlas_px", {tree.atlas.width_px, tree.atlas.height_px}}};
}

void show_package(const std::string& file, Console& console) {
  const std::vector<std::byte> bytes = load_package_bytes(file);
  const TreeModel tree = read_tree(bytes, file);
  const Container container = open_container(bytes);
  console.result(tree_text(file, tree, container), tree_json(tree, container));
}

std::string source_text(const std::string& what, const fs::path& path) {
  return "  " + what + ": " + (path.empty() ? "none" : printable(path.generic_string())) + "\n";
}

Json options_json(Recipe recipe) {
  Json all = Json::object();
  for (const OptionGroup& group : option_groups(recipe)) {
    for (const Option& option : group.options) {
      all[group.stage + "." + option.name] = value_text(option);
    }
  }
  return all;
}

std::size_t stroke_count(const Project& project) {
  std::size_t count = 0;
  for (const auto& [photo, strokes] : project.strokes) count += strokes.size();
  return count;
}

std::string drawn_text(const Project& project) {
  if (project.strokes.empty()) return "";
  return "  drawn here: " + std::to_string(stroke_count(project)) + " strokes on " +
         std::to_string(project.strokes.size()) + " photos\n";
}

std::size_t click_count(const Project& project) {
  std::size_t count = 0;
  for (const auto& [photo, points] : project.calibration.sightings) count += points.size();
  return count;
}

std::string told_text(const Project& project) {
  if (project.calibration.empty()) return "";
  const Measurements& measured = project.calibration.measurements;
  return "  told for calibration: " + std::to_string(click_count(project)) + " clicks, " +
         std::to_string(measured.tapes.size()) + " tapes, " +
         std::to_string(measured.heights.size()) + " heights, " +
         std::to_string(measured.points.size()) + " surveyed points\n";
}

// None, with a remark, where the project has neither a camera file nor a calibration.
std::optional<Capture> known_capture(const Project& project, std::vector<std::string>& remarks) {
  try {
    Capture capture = gather_capture(project);
    remarks = capture.remarks;
    return capture;
  } catch (const Error& error) {
    if (!project.cameras.empty()) throw;
    remarks = {error.what()};
    return std::nullopt;
  }
}

fs::path camera_source(const Project& project, bool has_cameras) {
  if (!project.cameras.empty() || !has_cameras) return project.cameras;
  return "calibrated from the photos";
}

void show_project(const std::string& folder, Console& console) {
  const Project project = read_project(folder);
  std::vector<std::string> remarks;
  const std::optional<Capture> known = known_capture(project, remarks);
  const Capture capture = known.value_or(Capture());
  std::string text = printable(folder) + ": project with " + std::to_string(capture.photos.size()) +
                     " of " + std::to_string(project.photos.size()) + " photos in use\n" +
                     source_text("cameras", camera_source(project, known.has_value())) +
                     source_text("mattes", project.mattes) +
                     source_text("strokes", project.scribbles) + drawn_text(project) +
                     told_text(project);
  Json finished = Json::object();
  for (const Stage& stage : stages()) finished[stage.name] = false;
  std::string done_text;
  for (const StageTime& time : known ? times_spent(project, capture) : std::vector<StageTime>()) {
    done_text += " " + time.stage + " (" + number_text(time.seconds, 1) + " s)";
    finished[time.stage] = true;
  }
  text += "  finished stages:" + (done_text.empty() ? " none" : done_text) + "\n";
  for (const std::string& remark : remarks) text += "  " + remark + "\n";
  console.result(text, {{"kind", "project"},
                        {"photos_given", project.photos.size()},
                        {"photos_used", capture.photos.size()},
                        {"cameras", project.cameras.generic_string()},
                        {"mattes", project.mattes.generic_string()},
                        {"scribbles", project.scribbles.generic_string()},
                        {"strokes", stroke_count(project)},
                        {"calibrated", project.cameras.empty() && known},
                        {"clicks", click_count(project)},
                        {"remarks", remarks},
                        {"finished", finished},
                        {"options", options_json(project.recipe)}});
}

}  // namespace

void add_info_command(CLI::App& app, Request& request) {
  CLI::App& command = add_command(app, request, "info", "tell what is in a project or a package",
                                  "bosk info oak.bosk");
  auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "folder of a project, or a package")->required();
  command.callback([file, &request] {
    request.run = [file](Console& console) {
      if (fs::is_directory(*file)) {
        show_project(*file, console);
      } else {
        show_package(*file, console);
      }
      return ExitStatus::done;
    };
  });
}

}  // namespace bosk
