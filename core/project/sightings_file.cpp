#include "core/project/sightings_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/project/capture.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMaxFileBytes = std::uint64_t(16) << 20;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw Error(printable(path.string()) + ": " + why);
}

Json entries_of(const fs::path& path) {
  const auto bytes = read_file(path, kMaxFileBytes);
  const auto* first = reinterpret_cast<const char*>(bytes.data());
  const Json json = Json::parse(first, first + bytes.size(), nullptr, false);
  if (!json.is_array()) {
    refuse(path, "is no JSON list of {\"photo\", \"point\", \"x\", \"y\"}");
  }
  return json;
}

// As the project has it; a name with dots in it is not cut.
std::string photo_name(const std::string& name, const std::vector<std::string>& known) {
  const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
  return is_known ? name : fs::path(name).stem().string();
}

HandSighting sighting_of(const Json& entry) {
  if (entry.value("removed", false)) return {false, {}};
  return {true, {entry.at("x").get<double>(), entry.at("y").get<double>()}};
}

Stroke left_out_of(const Json& entry) {
  Stroke stroke{StrokeKind::left_out, entry.at("radius").get<double>(), {}};
  for (const Json& place : entry.at("left_out")) {
    stroke.points_px.emplace_back(place.at(0).get<double>(), place.at(1).get<double>());
  }
  return rounded_stroke(std::move(stroke));
}

void add_entry(const Json& entry, const std::vector<std::string>& known, HandFile& all) {
  const std::string photo = photo_name(entry.at("photo").get<std::string>(), known);
  if (entry.contains("left_out")) return all.left_out[photo].push_back(left_out_of(entry));
  const std::string point = entry.at("point").get<std::string>();
  const HandSighting sighting = sighting_of(entry);
  check(point, sighting);
  if (all.sightings[photo].emplace(point, sighting).second) return;
  throw Error(printable(point + " on " + photo) + " is told twice; keep one of them");
}

}  // namespace

HandFile read_sightings_file(const fs::path& path, const Project& project) {
  const std::vector<std::string> known = photo_names(project);
  HandFile all;
  std::size_t number = 0;
  for (const Json& entry : entries_of(path)) {
    const std::string which = "entry " + std::to_string(++number) + " ";
    try {
      add_entry(entry, known, all);
    } catch (const Json::exception&) {
      refuse(
          path,
          which +
              "lacks photo, point, x or y (or left_out and radius), or one is of the wrong kind");
    } catch (const Error& error) {
      refuse(path, which + "is refused: " + error.what());
    }
  }
  const bool fits = std::any_of(known.begin(), known.end(), [&](const std::string& name) {
    return all.sightings.count(name) + all.left_out.count(name) > 0;
  });
  if (number > 0 && !fits) refuse(path, "names no photo of the project");
  return all;
}

}  // namespace bosk
