#include "core/project/project.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/system_error.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;  // raised when an older Bosk would misread the file
constexpr std::uint64_t kMaxFileBytes = std::uint64_t(16) << 20;
constexpr int kMaxDepth = 16;

fs::path project_file(const fs::path& folder) { return folder / "project.json"; }

struct JsonValue {
  Json operator()(const bool* value) const { return *value; }
  Json operator()(const int* value) const { return *value; }
  Json operator()(const double* value) const { return *value; }
  Json operator()(const std::string* value) const { return *value; }
};

Json options_json(const Recipe& recipe) {
  Json all = Json::object();
  Recipe copy = recipe;
  for (const OptionGroup& group : option_groups(copy)) {
    for (const Option& option : group.options) {
      all[group.stage][option.name] = std::visit(JsonValue{}, option.value);
    }
  }
  return all;
}

std::string project_text(const Project& project) {
  Json json;
  json["bosk_project"] = kSchema;
  Json photos = Json::array();
  for (const fs::path& photo : project.photos) photos.push_back(photo.generic_string());
  json["photos"] = photos;
  json["cameras"] = project.cameras.generic_string();
  json["mattes"] = project.mattes.generic_string();
  json["scribbles"] = project.scribbles.generic_string();
  json["options"] = options_json(project.recipe);
  try {
    return json.dump(2) + "\n";
  } catch (const Json::exception&) {
    throw Error(printable(project.folder.string()) +
                ": a file name or option is not valid UTF-8; rename the file");
  }
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw Error(printable(file.string()) + ": " + why);
}

Json parse_json(const fs::path& file, const std::vector<std::byte>& bytes) {
  const auto* first = reinterpret_cast<const char*>(bytes.data());
  const auto shallow = [](int depth, Json::parse_event_t, Json&) {
    if (depth > kMaxDepth) throw Error("too deep");
    return true;
  };
  try {
    return Json::parse(first, first + bytes.size(), shallow);
  } catch (const Json::exception&) {
    refuse(file, "is damaged (no valid JSON); make the project again with `bosk new`");
  } catch (const Error&) {
    refuse(file, "is damaged (nested too deeply); make the project again with `bosk new`");
  }
}

void check_schema(const fs::path& file, const Json& json) {
  if (!json.is_object() || !json.contains("bosk_project") ||
      !json["bosk_project"].is_number_integer()) {
    refuse(file, "is no project of Bosk");
  }
  if (json["bosk_project"].get<int>() > kSchema) {
    refuse(file, "was written by a newer Bosk; install that version to open it");
  }
}

void read_options(const Json& groups, Recipe& recipe) {
  for (const auto& [stage, options] : groups.items()) {
    const std::string prefix = stage + ".";
    for (const auto& [name, value] : options.items()) {
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      set_option(recipe, prefix + name, text);
    }
  }
}

void read_fields(const Json& json, Project& project) {
  for (const Json& photo : json.at("photos")) {
    project.photos.emplace_back(photo.get<std::string>());
  }
  project.cameras = json.at("cameras").get<std::string>();
  project.mattes = json.at("mattes").get<std::string>();
  project.scribbles = json.at("scribbles").get<std::string>();
  read_options(json.at("options"), project.recipe);
}

}  // namespace

fs::path Project::absolute(const fs::path& path) const {
  // Without resolving "..", as the system would: FOLDER/../photos needs no FOLDER then
  return (fs::weakly_canonical(fs::absolute(folder)) / path).lexically_normal();
}

std::string Project::name() const {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  const fs::path last = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
  return last.empty() ? "tree" : last.string();
}

bool holds_project(const fs::path& folder) {
  std::error_code none;
  return fs::exists(project_file(folder), none);
}

Project read_project(const fs::path& folder) {
  std::error_code none;
  if (!fs::exists(folder, none)) {
    refuse(folder, "there is no such folder; make a project with `bosk new`");
  }
  if (!holds_project(folder)) {
    refuse(folder, "holds no project (project.json is missing); make one with `bosk new`");
  }
  const fs::path file = project_file(folder);
  const Json json = parse_json(file, read_file(file, kMaxFileBytes));
  check_schema(file, json);
  Project project;
  project.folder = folder;
  try {
    read_fields(json, project);
  } catch (const Json::exception&) {
    refuse(file, "is damaged (a field is missing or of the wrong kind)");
  } catch (const Error& error) {
    refuse(file, error.what());
  }
  return project;
}

void save_project(const Project& project) {
  const fs::path file = project_file(project.folder);
  const std::string text = project_text(project);
  if (holds_project(project.folder)) {
    const auto old = read_file(file, kMaxFileBytes);
    const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
    if (std::equal(old.begin(), old.end(), bytes.begin(), bytes.end())) return;
  }
  write_file_atomically(file, text);
}

}  // namespace bosk
