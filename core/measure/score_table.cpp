#include "core/measure/score_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace bosk {
namespace {

std::string row(const std::string& name, const ViewScore& score) {
  std::string text = name;
  text.resize(std::max<std::size_t>(text.size(), 16), ' ');
  for (const ScoreField& field : kScoreFields) {
    char number[40];
    std::snprintf(number, sizeof number, "%13.4f", score.*field.value);
    text += number;
  }
  return text + "\n";
}

nlohmann::ordered_json score_json(const ViewScore& score) {
  nlohmann::ordered_json json;
  for (const ScoreField& field : kScoreFields) {
    const double value = score.*field.value;
    json[field.name] = std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
  }
  return json;
}

}  // namespace

ScoreTable tabulate(std::vector<NamedScore> views) {
  assert(!views.empty());
  ScoreTable table{std::move(views), {}, {}};
  for (const ScoreField& field : kScoreFields) {
    double sum = 0.0, worst = table.views.front().score.*field.value;
    for (const NamedScore& view : table.views) {
      const double value = view.score.*field.value;
      sum += value;
      worst = field.less_is_better ? std::max(worst, value) : std::min(worst, value);
    }
    table.mean.*field.value = sum / double(table.views.size());
    table.worst.*field.value = worst;
  }
  return table;
}

std::string table_text(const ScoreTable& table) {
  std::string text = "view            ";
  for (const ScoreField& field : kScoreFields) {
    char name[40];
    std::snprintf(name, sizeof name, "%13s", field.name);
    text += name;
  }
  text += "\n";
  for (const NamedScore& view : table.views) text += row(view.name, view.score);
  return text + row("mean", table.mean) + row("worst", table.worst);
}

nlohmann::ordered_json table_json(const ScoreTable& table) {
  nlohmann::ordered_json json;
  json["views"] = nlohmann::ordered_json::object();
  for (const NamedScore& view : table.views) json["views"][view.name] = score_json(view.score);
  json["mean"] = score_json(table.mean);
  json["worst"] = score_json(table.worst);
  return json;
}

}  // namespace bosk
