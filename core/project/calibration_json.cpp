#include "core/project/calibration_json.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace bosk {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const HandSighting& sighting) {
  return sighting.there ? Json::array({sighting.pixel.x, sighting.pixel.y}) : Json();
}

Json json_of(const Tape& tape) {
  return {
      {"from", tape.from}, {"to", tape.to}, {"length_m", tape.length_m}, {"sigma_m", tape.sigma_m}};
}

Json json_of(const Height& height) {
  return {{"point", height.point}, {"height_m", height.height_m}, {"sigma_m", height.sigma_m}};
}

Json json_of(const SurveyedPoint& point) {
  const glm::dvec3& place = point.in_world;
  return {{"point", point.point},
          {"in_world_m", {place.x, place.y, place.z}},
          {"sigma_m", point.sigma_m}};
}

template <class Item>
void add_list(const char* name, const std::vector<Item>& items, Json& json) {
  for (const Item& item : items) json[name].push_back(json_of(item));
}

// Of so many numbers; other places than asked for are damage.
const Json& numbers(const Json& json, std::size_t count) {
  if (!json.is_array() || json.size() != count) {
    throw Error("is damaged (a place in calibration)");
  }
  return json;
}

HandSighting sighting_of(const Json& json) {
  if (json.is_null()) return {false, {}};
  const Json& place = numbers(json, 2);
  return {true, {place[0].get<double>(), place[1].get<double>()}};
}

HandSightings sightings_of(const Json& json) {
  HandSightings all;
  for (const auto& [photo, points] : json.items()) {
    for (const auto& [point, place] : points.items()) {
      const HandSighting sighting = sighting_of(place);
      check(point, sighting);
      all[photo][point] = sighting;
    }
  }
  return all;
}

std::string text(const Json& json, const char* name) {
  return json.at(name).get_ref<const std::string&>();
}

double number(const Json& json, const char* name) { return json.at(name).get<double>(); }

Tape tape_of(const Json& json) {
  return {text(json, "from"), text(json, "to"), number(json, "length_m"), number(json, "sigma_m")};
}

Height height_of(const Json& json) {
  return {text(json, "point"), number(json, "height_m"), number(json, "sigma_m")};
}

SurveyedPoint point_of(const Json& json) {
  const Json& place = numbers(json.at("in_world_m"), 3);
  return {text(json, "point"),
          {place[0].get<double>(), place[1].get<double>(), place[2].get<double>()},
          number(json, "sigma_m")};
}

template <class Item>
void read_list(const Json& json, const char* name, Item (*read_item)(const Json&),
               std::vector<Item>& items) {
  if (!json.contains(name)) return;
  for (const Json& item : json.at(name)) items.push_back(read_item(item));
}

}  // namespace

Json calibration_json(const CalibrationInputs& inputs) {
  Json json = Json::object();
  for (const auto& [photo, points] : inputs.sightings) {
    for (const auto& [point, sighting] : points) {
      json["sightings"][photo][point] = json_of(sighting);
    }
  }
  add_list("tapes", inputs.measurements.tapes, json);
  add_list("heights", inputs.measurements.heights, json);
  add_list("points", inputs.measurements.points, json);
  if (!inputs.boards.empty()) json["boards"] = inputs.boards.generic_string();
  if (!inputs.lens.empty()) json["lens"] = inputs.lens.generic_string();
  return json;
}

CalibrationInputs calibration_of(const Json& json) {
  CalibrationInputs inputs;
  if (json.contains("sightings")) inputs.sightings = sightings_of(json.at("sightings"));
  read_list(json, "tapes", tape_of, inputs.measurements.tapes);
  read_list(json, "heights", height_of, inputs.measurements.heights);
  read_list(json, "points", point_of, inputs.measurements.points);
  check(inputs.measurements);
  if (json.contains("boards")) inputs.boards = text(json, "boards");
  if (json.contains("lens")) inputs.lens = text(json, "lens");
  return inputs;
}

}  // namespace bosk
