#include "core/project/report.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/number_text.h"
#include "core/image/image_io.h"
#include "core/project/html.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kSheetCellPx = 360;

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
  return html_table(rows);
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
  return html_table(rows);
}

std::string time_table(const std::vector<StageTime>& times) {
  std::vector<std::vector<std::string>> rows = {{"stage", "seconds"}};
  for (const StageTime& time : times) rows.push_back({time.stage, number_text(time.seconds, 1)});
  return html_table(rows);
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
  return html_table(rows);
}

std::string html_page(const Evaluation& evaluation, const Project& project,
                      const std::vector<std::byte>& sheet_png) {
  const ViewScore& mean = evaluation.scores.mean;
  const std::string name = html_text(project.name());
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + name +
         "</title><style>" + kHtmlStyle + "</style></head><body>\n<h1>" + name + "</h1>\n<p>" +
         html_text(evaluation.title) + ": on average " + number_text(mean.psnr, 2) +
         " dB and SSIM " + number_text(mean.ssim, 3) + " over white. The package takes " +
         size_text(evaluation.package_bytes) + ".</p>\n<h2>Scores</h2>\n" +
         score_table(evaluation.scores) +
         "<p>psnr and crop_psnr in dB; crop: inside the tree's box; alpha_mae: mean error of "
         "opacity, 0 to 1; edge_ratio: below 1 is blur, above 1 noise; colour_error: CIEDE2000, "
         "about 1 is just visible.</p>\n<h2>Views</h2>\n<img alt=\"photo, Bosk, difference\" "
         "src=\"" +
         data_url("png", sheet_png) + "\">\n<h2>Levels of detail</h2>\n" +
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
