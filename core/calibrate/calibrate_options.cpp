#include "core/calibrate/calibrate_options.h"

#include "core/base/error.h"
#include "core/calibrate/tags.h"

namespace bosk {
namespace {

Option choice(const std::string& name, const std::string& help, std::string& value,
              const std::vector<std::string>& choices) {
  return {name, "", help, &value, 0, 0, choices};
}

Option flag(const std::string& name, const std::string& help, bool& value) {
  return {name, "", help, &value, 0, 0, {}};
}

template <class Number>
Option number(const std::string& name, const std::string& unit, const std::string& help,
              Number& value, double minimum, double maximum) {
  return {name, unit, help, &value, minimum, maximum, {}};
}

std::vector<std::string> none_or(std::vector<std::string> names) {
  names.insert(names.begin(), "none");
  return names;
}

void append(const Options& more, Options& all) { all.insert(all.end(), more.begin(), more.end()); }

Options marker_options(CalibrateOptions& o) {
  return {flag("find_balls", "look for coloured balls on sticks", o.find_balls),
          number("smallest_ball", "px", "diameter of the smallest ball to look for",
                 o.balls.smallest_diameter_px, 4, 100),
          number("largest_ball", "px", "diameter of the largest ball to look for",
                 o.balls.largest_diameter_px, 8, 2000),
          number("least_visible", "", "share of a ball's disc that must show",
                 o.balls.least_visible, 0.1, 1),
          choice("tags", "printed markers to look for: the dictionary they are from", o.tags,
                 none_or(tag_dictionary_names())),
          number("tag_side_m", "m", "edge of a printed marker's black square; 0 where not measured",
                 o.tag_side_m, 0, 10)};
}

Options feature_options(CalibrateOptions& o) {
  return {choice("features",
                 "look for features on trunk and ground: auto where a photo shows few markers",
                 o.features, {"auto", "on", "off"}),
          number("feature_megapixels", "megapixels", "size of the photos for features",
                 o.feature_megapixels, 0.1, 24),
          number("features_per_photo", "", "the strongest features of a photo to use",
                 o.feature.features_per_photo, 100, 20000),
          number("match_ratio", "", "how much better the best match must be than the second best",
                 o.feature.ratio, 0.5, 1),
          number("tracks_per_photo", "",
                 "features seen in several photos to keep of a photo, the longest",
                 o.feature.tracks_per_photo, 50, 5000)};
}

Options lens_options(CalibrateOptions& o) {
  return {
      choice("lens", "auto fixes it where boards or a profile give it; free solves for it", o.lens,
             {"auto", "free", "known"}),
      choice("lens_model", "lens model that boards are solved for", o.board_lens.model,
             {"auto", "opencv4", "opencv5", "opencv8"}),
      choice("board", "board on the board photos", o.board, {"none", "chessboard", "charuco"}),
      number("board_columns", "", "inner corners of a row of the board", o.shape.columns, 3, 100),
      number("board_rows", "", "inner corners of a column of the board", o.shape.rows, 3, 100),
      number("board_square_m", "m", "side of a square of the board", o.shape.square_m, 0.0005, 10),
      choice("board_dictionary", "markers of a ChArUco board", o.shape.dictionary,
             tag_dictionary_names()),
      number("board_marker_share", "", "side of a ChArUco marker over that of its square",
             o.shape.marker_share, 0.3, 0.95),
      flag("board_warp", "let the board bend a little", o.board_lens.board_warp),
      flag("board_at_tree", "the board stands still among the photos of the tree as well",
           o.board_at_tree)};
}

}  // namespace

Options describe(CalibrateOptions& options) {
  Options all = marker_options(options);
  append(feature_options(options), all);
  append(lens_options(options), all);
  append({choice("refine",
                 "silhouettes turns the cameras a little where the mattes then agree better; needs "
                 "mattes; done by `bosk calibrate` or Find markers, not after each click",
                 options.refine, {"none", "silhouettes"}),
          number("crown_px", "px",
                 "uncertainty at the crown, one sigma, above which a photo is called uncertain",
                 options.uncertain_crown_px, 0.05, 50)},
         all);
  return all;
}

BoardShape board_of(const CalibrateOptions& options) {
  if (options.board == "none") {
    throw Error(
        "which board is on the board photos is not known; give its inner corners and square with "
        "`bosk calibrate --board COLUMNSxROWS --square MM`");
  }
  BoardShape shape = options.shape;
  shape.kind = options.board == "charuco" ? BoardKind::charuco : BoardKind::chessboard;
  check_board_shape(shape);
  return shape;
}

}  // namespace bosk
