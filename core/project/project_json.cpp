#include "core/project/project_json.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "core/base/content_hash.h"
#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/project/calibration_json.h"
#include "core/project/stroke_text.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

// Raised when an older Bosk would misread the file: 1 knows neither strokes nor a journal, 2 no
// calibration, 3 nothing left out of it
constexpr int kSchema = 4;
constexpr int kMaxDepth = 16;

struct JsonValue {
  Json operator()(const bool* value) const { return *value; }
  Json operator()(const int* value) const { return *value; }
  Json operator()(const double* value) const { return *value; }
  Json operator()(const std::string* value) const { return *value; }
};

std::string hex_text(std::uint64_t number) { return hex({number, 0}).substr(0, 16); }

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

Json strokes_json(const std::vector<Stroke>& strokes) {
  Json all = Json::array();
  for (const Stroke& stroke : strokes) {
    Json json;
    json["kind"] = kind_text(stroke.kind);
    json["radius_px"] = stroke.radius_px;
    json["points_px"] = points_text(stroke.points_px);
    all.push_back(std::move(json));
  }
  return all;
}

void add_strokes(const char* name, const Strokes& strokes, Json& json) {
  for (const auto& [photo, drawn] : strokes) {
    if (!drawn.empty()) json[name][photo] = strokes_json(drawn);
  }
}

void add_journal(const JournalPlace& journal, Json& json) {
  if (journal.id == 0) return;
  json["journal"]["id"] = hex_text(journal.id);
  json["journal"]["end"] = journal.end;
}

// The oldest that reads the file as it is meant.
int schema_of(const Json& json) {
  if (json.contains("left_out")) return 4;
  if (json.contains("calibration")) return 3;
  return json.contains("strokes") || json.contains("journal") ? 2 : 1;
}

Json project_json(const Project& project) {
  Json json;
  json["bosk_project"] = 1;
  Json photos = Json::array();
  for (const fs::path& photo : project.photos) photos.push_back(photo.generic_string());
  json["photos"] = photos;
  json["cameras"] = project.cameras.generic_string();
  json["mattes"] = project.mattes.generic_string();
  json["scribbles"] = project.scribbles.generic_string();
  json["options"] = options_json(project.recipe);
  add_strokes("strokes", project.strokes, json);
  if (!project.calibration.empty()) json["calibration"] = calibration_json(project.calibration);
  add_strokes("left_out", project.calibration.left_out, json);
  add_journal(project.journal, json);
  json["bosk_project"] = schema_of(json);
  return json;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw Error(printable(file.string()) + ": " + why);
}

Json parse_json(const fs::path& file, std::span<const std::byte> bytes) {
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

void read_strokes(const Json& json, Strokes& strokes) {
  for (const auto& [photo, drawn] : json.items()) {
    for (const Json& stroke : drawn) {
      strokes[photo].push_back(
          rounded_stroke({kind_of_text(stroke.at("kind").get_ref<const std::string&>()),
                          stroke.at("radius_px").get<double>(),
                          points_of_text(stroke.at("points_px").get_ref<const std::string&>())}));
    }
  }
}

JournalPlace journal_of(const Json& json) {
  const std::string& id = json.at("id").get_ref<const std::string&>();
  JournalPlace journal;
  const auto parsed = std::from_chars(id.data(), id.data() + id.size(), journal.id, 16);
  if (parsed.ec != std::errc() || parsed.ptr != id.data() + id.size() ||
      !json.at("end").is_number_unsigned()) {
    throw Error("is damaged (the place in the journal)");
  }
  journal.end = json.at("end").get<std::uint64_t>();
  return journal;
}

void read_fields(const Json& json, Project& project) {
  for (const Json& photo : json.at("photos")) {
    project.photos.emplace_back(photo.get<std::string>());
  }
  project.cameras = json.at("cameras").get<std::string>();
  project.mattes = json.at("mattes").get<std::string>();
  project.scribbles = json.at("scribbles").get<std::string>();
  read_options(json.at("options"), project.recipe);
  if (json.contains("strokes")) read_strokes(json.at("strokes"), project.strokes);
  if (json.contains("calibration")) {
    project.calibration = calibration_of(json.at("calibration"));
  }
  if (json.contains("left_out")) read_strokes(json.at("left_out"), project.calibration.left_out);
  if (json.contains("journal")) project.journal = journal_of(json.at("journal"));
}

}  // namespace

std::string project_text(const Project& project) {
  try {
    return project_json(project).dump(2) + "\n";
  } catch (const Json::exception&) {
    throw Error(printable(project.folder.string()) +
                ": a file name or option is not valid UTF-8; rename the file");
  }
}

Project project_of_text(std::span<const std::byte> text, const fs::path& file) {
  const Json json = parse_json(file, text);
  check_schema(file, json);
  Project project;
  try {
    read_fields(json, project);
  } catch (const Json::exception&) {
    refuse(file, "is damaged (a field is missing or of the wrong kind)");
  } catch (const Error& error) {
    refuse(file, error.what());
  }
  return project;
}

bool is_storable(const std::string& text) {
  try {
    Json(text).dump();
    return true;
  } catch (const Json::exception&) {
    return false;
  }
}

}  // namespace bosk
