#include "core/project/report.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/number_text.h"
#include "core/image/image_io.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kSheetCellPx = 360;

constexpr const char* kStyle =
    "body{font:16px/1.5 system-ui,sans-serif;margin:2em auto;max-width:70em;padding:0 1em;"
    "color:#222;background:#fff}table{border-collapse:collapse;margin:1em 0}"
    "td,th{border:1px solid #bbb;padding:.2em .7em;text-align:right}td:first-child,"
    "th:first-child{text-align:left}img{max-width:100%}";

std::string html_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string base64(const std::vector<std::byte>& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto at = [&](std::size_t i) { return i < bytes.size() ? unsigned(bytes[i]) : 0u; };
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned group = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
    for (int digit = 0; digit < 4; ++digit) {
      const bool used = i + std::size_t(digit) <= bytes.size();
      text += used ? kDigits[group >> (18 - 6 * digit) & 63] : '=';
    }
  }
  return text;
}

std::string row(const std::vector<std::string>& cells, const std::string& tag) {
  const std::string begin = "<" + tag + ">", end = "</" + tag + ">";
  std::string text = "<tr>";
  for (const std::string& cell : cells) text.append(begin).append(html_text(cell)).append(end);
  return text + "</tr>\n";
}

std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::string text = "<table>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) text += row(rows[i], i == 0 ? "th" : "td");
  return text + "</table>\n";
}

std::vector<std::string> score_row(const std::string& name, const ViewScore& score) {
  std::vector<std::string> cells = {name};
  for (const ScoreField& field : kScoreFields) cells.push_back(number_text(score.*field.value, 4));
  return cells;
}

std::string score_table(const ScoreTable& scores) {
  std::vector<std::string> head = {"view"};
  for (const ScoreField& field : kScoreFields) head.emplace_back(field.name);
  std::vector<std::vector<std::string>> rows = {head};
  for (const NamedScore& view : scores.views) rows.push_back(score_row(view.name, view.score));
  rows.push_back(score_row("mean", scores.mean));
  rows.push_back(score_row("worst", scores.worst));
  return table(rows);
}

std::string level_table(const TreeModel& tree) {
  std::vector<std::vector<std::string>> rows = {
      {"level", "cells", "views", "texels", "cells up to, px", "codewords, colour", "alpha"}};
  for (const TreeLevel& level : tree.levels) {
    rows.push_back({std::to_string(level.level), std::to_string(level.cells.size()),
                    std::to_string(level.views.size()), std::to_string(level.texels),
                    number_text(double(level.max_cell_px), 1),
                    std::to_string(level.colour_codes.count),
                    std::to_string(level.alpha_codes.count)});
  }
  return table(rows);
}

std::string time_table(const std::vector<StageTime>& times) {
  std::vector<std::vector<std::string>> rows = {{"stage", "seconds"}};
  for (const StageTime& time : times) rows.push_back({time.stage, number_text(time.seconds, 1)});
  return table(rows);
}

std::string option_table(const Project& project) {
  std::vector<std::vector<std::string>> rows = {{"option", "value"}};
  Recipe recipe = project.recipe;
  for (const OptionGroup& group : option_groups(recipe)) {
    for (const Option& option : group.options) {
      const std::string unit = option.unit.empty() ? "" : " " + option.unit;
      rows.push_back({group.stage + "." + option.name, value_text(option) + unit});
    }
  }
  return table(rows);
}

std::string html_page(const Evaluation& evaluation, const Project& project,
                      const std::vector<std::byte>& sheet_png) {
  const ViewScore& mean = evaluation.scores.mean;
  const std::string name = html_text(project.name());
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + name +
         "</title><style>" + kStyle + "</style></head><body>\n<h1>" + name + "</h1>\n<p>" +
         html_text(evaluation.title) + ": on average " + number_text(mean.psnr, 2) +
         " dB and SSIM " + number_text(mean.ssim, 3) + " over white. The package takes " +
         size_text(evaluation.package_bytes) + ".</p>\n<h2>Scores</h2>\n" +
         score_table(evaluation.scores) +
         "<p>psnr and crop_psnr in dB; crop: inside the tree's box; alpha_mae: mean error of "
         "opacity, 0 to 1; edge_ratio: below 1 is blur, above 1 noise; colour_error: CIEDE2000, "
         "about 1 is just visible.</p>\n<h2>Views</h2>\n<img alt=\"photo, Bosk, difference\" "
         "src=\"" +
         "data:image/png;base64," + base64(sheet_png) + "\">\n<h2>Levels of detail</h2>\n" +
         level_table(evaluation.tree) + "<h2>Time of the stages</h2>\n" +
         time_table(evaluation.times) + "<h2>Settings</h2>\n" + option_table(project) +
         "<p>Made by bosk " BOSK_VERSION ".</p>\n</body></html>\n";
}

}  // namespace

std::string figures_text(const Evaluation& evaluation) {
  std::string text = evaluation.title + "\n" + table_text(evaluation.scores);
  text += "package " + size_text(evaluation.package_bytes) + "\n";
  for (const StageTime& time : evaluation.times) {
    text += "time of " + time.stage + " " + number_text(time.seconds, 1) + " s\n";
  }
  return text;
}

Json figures_json(const Evaluation& evaluation) {
  Json json = table_json(evaluation.scores);
  json["title"] = evaluation.title;
  json["package_bytes"] = evaluation.package_bytes;
  for (const StageTime& time : evaluation.times) json["stage_seconds"][time.stage] = time.seconds;
  return json;
}

void write_report(const fs::path& folder, const Evaluation& evaluation, const Project& project) {
  make_folder(folder);
  const fs::path sheet = folder / "contact-sheet.png";
  write_png(sheet, contact_sheet(evaluation.views, kSheetCellPx));
  write_file_atomically(folder / "figures.txt", figures_text(evaluation));
  write_file_atomically(folder / "figures.json", figures_json(evaluation).dump(1) + "\n");
  write_file_atomically(folder / "report.html",
                        html_page(evaluation, project, read_file(sheet, std::uint64_t(1) << 30)));
}

}  // namespace bosk
