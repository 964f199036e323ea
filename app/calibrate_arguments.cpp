#include "app/calibrate_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/project/sightings_file.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& wanted) {
  throw CLI::ValidationError("--" + option + " " + text + ": " + wanted);
}

// A number, and the rest of the text behind it.
std::optional<double> take_number(std::string_view& text) {
  double number = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc()) return std::nullopt;
  text.remove_prefix(std::size_t(result.ptr - text.data()));
  return number;
}

struct Measured {
  double value_m = 0.0;
  std::optional<double> sigma_m;
};

// "2.35" or "2.35+-0.005".
Measured measured(const std::string& option, const std::string& text) {
  std::string_view rest = text;
  Measured measured;
  const auto value = take_number(rest);
  const bool has_tolerance = rest.rfind("+-", 0) == 0;
  if (has_tolerance) {
    rest.remove_prefix(2);
    measured.sigma_m = take_number(rest);
  }
  if (!value || !rest.empty() || has_tolerance != measured.sigma_m.has_value()) {
    refuse(option, text, "give metres, such as 2.35 or 2.35+-0.005");
  }
  measured.value_m = *value;
  return measured;
}

// In place of one that `is_same`, or behind the others.
template <class Item, class Same>
void put(std::vector<Item>& items, const Item& item, Same is_same) {
  const auto place = std::find_if(items.begin(), items.end(), is_same);
  if (place == items.end()) {
    items.push_back(item);
  } else {
    *place = item;
  }
}

void put_tape(const std::string* words, Measurements& measurements) {
  Tape tape;
  tape.from = words[0];
  tape.to = words[1];
  const Measured length = measured("tape", words[2]);
  tape.length_m = length.value_m;
  tape.sigma_m = length.sigma_m.value_or(tape.sigma_m);
  put(measurements.tapes, tape, [&](const Tape& other) {
    return std::minmax(other.from, other.to) == std::minmax(tape.from, tape.to);
  });
}

void put_height(const std::string* words, Measurements& measurements) {
  Height height;
  height.point = words[0];
  const Measured metres = measured("height", words[1]);
  height.height_m = metres.value_m;
  height.sigma_m = metres.sigma_m.value_or(height.sigma_m);
  put(measurements.heights, height,
      [&](const Height& other) { return other.point == height.point; });
}

void put_point(const std::string* words, Measurements& measurements) {
  SurveyedPoint point;
  point.point = words[0];
  for (int i = 0; i < 3; ++i) {
    const Measured place = measured("point", words[1 + i]);
    point.in_world[i] = place.value_m;
    if (place.sigma_m) point.sigma_m = std::max(point.sigma_m, *place.sigma_m);
  }
  put(measurements.points, point,
      [&](const SurveyedPoint& other) { return other.point == point.point; });
}

void take_measurements(const CalibrateArguments& arguments, Measurements& measurements) {
  if (arguments.forget_measurements) measurements = {};
  const auto each = [&](const std::vector<std::string>& words, std::size_t count, auto put_one) {
    for (std::size_t i = 0; i + count <= words.size(); i += count) {
      put_one(&words[i], measurements);
    }
  };
  each(arguments.tapes, 3, put_tape);
  each(arguments.heights, 2, put_height);
  each(arguments.points, 4, put_point);
  try {
    check(measurements);
  } catch (const Error& error) {
    throw CLI::ValidationError(error.what());
  }
}

// "9x6".
std::pair<int, int> corners_of(const std::string& text) {
  int columns = 0, rows = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, columns);
  const bool cross = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
  const auto second =
      cross ? std::from_chars(first.ptr + 1, end, rows) : std::from_chars_result{end, {}};
  if (!cross || second.ec != std::errc() || second.ptr != end) {
    refuse("board", text, "give the inner corners as COLUMNSxROWS, such as 9x6");
  }
  return {columns, rows};
}

void take_board(const CalibrateArguments& arguments, CalibrateOptions& options) {
  if (!arguments.board.empty()) {
    const auto [columns, rows] = corners_of(arguments.board);
    if (options.board == "none") options.board = "chessboard";
    options.shape.columns = columns;
    options.shape.rows = rows;
  }
  if (arguments.square_mm > 0.0) options.shape.square_m = 0.001 * arguments.square_mm;
  if (arguments.board.empty()) return;
  try {
    board_of(options);
  } catch (const Error& error) {
    throw CLI::ValidationError(error.what());
  }
}

void take_files(const CalibrateArguments& arguments, Project& project) {
  CalibrationInputs& inputs = project.calibration;
  if (!arguments.boards.empty()) inputs.boards = project.relative(arguments.boards);
  if (!arguments.lens.empty()) inputs.lens = project.relative(arguments.lens);
  if (arguments.replace) project.cameras.clear();
  if (arguments.sightings.empty()) return;
  const HandFile by_hand = read_sightings_file(arguments.sightings, project);
  for (const auto& [photo, points] : by_hand.sightings) {
    for (const auto& [point, said] : points) inputs.sightings[photo][point] = said;
  }
  for (const auto& [photo, strokes] : by_hand.left_out) {
    for (const Stroke& stroke : strokes) {
      put(inputs.left_out[photo], stroke, [&](const Stroke& other) { return other == stroke; });
    }
  }
}

}  // namespace

void add_calibrate_arguments(CLI::App& command, CalibrateArguments& arguments) {
  command.add_option("PROJECT", arguments.folder, "folder of the project")->required();
  command
      .add_option("--tape", arguments.tapes,
                  "distance between two markers, with its standard deviation if known: red blue "
                  "2.35+-0.005; gives the scale, and may be given several times")
      ->type_name("A B METRES[+-TOL]")
      ->expected(3)
      ->take_all();
  command
      .add_option("--height", arguments.heights,
                  "height of a ball's centre above the foot of its stick: red 1.52; three of them "
                  "or more tell what is up")
      ->type_name("NAME METRES[+-TOL]")
      ->expected(2)
      ->take_all();
  command
      .add_option("--point", arguments.points,
                  "a marker's surveyed place: x, y, and z upwards, from the foot of the trunk")
      ->type_name("NAME X Y Z")
      ->expected(4)
      ->take_all();
  command.add_flag("--forget-measurements", arguments.forget_measurements,
                   "drop the tapes, heights and points that were given before");
  command
      .add_option("--board", arguments.board,
                  "inner corners of the chessboard (or, with --calibrate.board=charuco, of the "
                  "ChArUco board) on the board photos")
      ->type_name("COLUMNSxROWS");
  command
      .add_option("--square", arguments.square_mm, "edge of a square of the board, in millimetres")
      ->check(CLI::Range(0.5, 10000.0))
      ->type_name("MM");
  command
      .add_option("--boards", arguments.boards,
                  "photos of the board, 10 to 40, tilted, all over the frame, same lens and zoom "
                  "as the tree's: the lens comes from them")
      ->type_name("DIR");
  command.add_option("--lens", arguments.lens, "a lens profile saved earlier with --save-lens")
      ->type_name("PROFILE");
  command
      .add_option("--save-lens", arguments.save_lens,
                  "keep the lens of the board photos for later captures")
      ->type_name("FILE");
  command
      .add_option(
          "--sightings", arguments.sightings,
          "clicks: a JSON list of {\"photo\", \"point\", \"x\", \"y\"}, in pixels of the "
          "photo; \"removed\": true instead of x and y takes a wrong find away; {\"photo\", "
          "\"left_out\": [[x, y], ...], \"radius\"} leaves out sky or what moves")
      ->type_name("FILE.json");
  command
      .add_option("--report", arguments.report,
                  "a page that shows verdict, walk, photos, residuals and what to re-shoot")
      ->type_name("FILE.html");
  command.add_flag("--replace", arguments.replace,
                   "calibrate although the project has a camera file, and forget that file");
  add_stage_options(command, {"calibrate", "photo"}, arguments.choices);
}

void take_arguments(const CalibrateArguments& arguments, Project& project) {
  set_options(arguments.choices, project.recipe);
  take_board(arguments, project.recipe.calibrate);
  take_measurements(arguments, project.calibration.measurements);
  take_files(arguments, project);
}

}  // namespace bosk
