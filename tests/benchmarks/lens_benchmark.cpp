#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "core/calibrate/lens_pictures.h"
#include "core/calibrate/lens_solve.h"
#include "core/geometry/rotation.h"
#include "core/image/image_io.h"
#include "core/photo/child_mode.h"
#include "core/photo/decode.h"
#include "core/photo/import.h"
#include "tests/benchmarks/run_or_explain.h"
#include "tests/calibrate/painted_board.h"
#include "tests/calibrate/synthetic_boards.h"

// How long boards take to be found and a lens to be solved, and how well.
//   lens_benchmark FOLDER COLUMNSxROWS [SQUARE_M [PICTURES]]   photos of a chessboard; PICTURES:
//   where
//                                                              coverage.png and uncertainty.png go
//   lens_benchmark                                             synthetic boards
//   lens_benchmark spread [SEEDS]                              predicted uncertainty against its
//   spread

namespace bosk {
namespace {

namespace fs = std::filesystem;

class Stopwatch {
 public:
  double wall_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
  }
  double cpu_s() const { return double(std::clock() - cpu_) / CLOCKS_PER_SEC; }

 private:
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  std::clock_t cpu_ = std::clock();
};

const char* text_of(Verdict verdict) {
  return verdict == Verdict::good ? "good" : verdict == Verdict::usable ? "usable" : "refused";
}

void print_boards(const LensCalibration& calibration) {
  std::printf("\n%-24s corners outliers  rms px  tilt deg\n", "photo");
  for (const BoardFinding& board : calibration.boards)
    std::printf("%-24s %7d %8d %7.3f %9.1f  %s\n", board.photo.c_str(), board.corners,
                board.outliers, board.rms_px, board.tilt * 57.29578, board.reason.c_str());
}

void print_lens(const LensCalibration& calibration) {
  const Lens& lens = calibration.profile.lens;
  std::printf("\n%-10s  rms px  held-out rms\n", "model");
  for (const LensTrial& trial : calibration.trials)
    std::printf("%-10s %7.4f %13.4f %s\n", trial.model.c_str(), trial.rms_px, trial.held_out_rms_px,
                trial.chosen ? "chosen" : "");
  std::printf("\nfx %.1f fy %.1f cx %.1f cy %.1f, distortion", lens.focal_px.x, lens.focal_px.y,
              lens.principal_px.x, lens.principal_px.y);
  for (const double term : lens.distortion) std::printf(" %.4g", term);
  std::printf(
      "\nfocal sigma %.3f %%, spread over boards %.3f %%, warp %.2f %.2f mm, corner noise %.3f "
      "px\n",
      100.0 * calibration.focal_sigma, 100.0 * calibration.focal_spread,
      1e3 * calibration.board_warp_m.x, 1e3 * calibration.board_warp_m.y,
      calibration.corner_sigma_px);
  const auto& coverage = calibration.profile.coverage.pixels();
  const auto& sigma = calibration.profile.uncertainty_px.pixels();
  if (coverage.empty() || sigma.empty()) return;
  std::vector<float> sorted = sigma;
  std::sort(sorted.begin(), sorted.end());
  std::printf("coverage: %.0f %% of %zu cells; projection sigma px: median %.3f, worst %.3f\n",
              100.0 *
                  double(std::count_if(coverage.begin(), coverage.end(),
                                       [](float corners) { return corners > 0; })) /
                  double(coverage.size()),
              coverage.size(), double(sorted[sorted.size() / 2]), double(sorted.back()));
}

void print_verdict(const LensCalibration& calibration) {
  std::printf("\nverdict: %s, rms %.3f px, %d boards, %d corners\n", text_of(calibration.verdict),
              calibration.profile.rms_px, calibration.profile.boards, calibration.profile.corners);
  for (const std::string& sentence : calibration.sentences) std::printf("  %s\n", sentence.c_str());
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<BoardView> found_boards(const fs::path& folder, const BoardShape& shape) {
  Progress quiet;
  PhotoDecoder decoder(decode_limits({}));
  std::vector<BoardView> views;
  double cpu_s = 0.0, wall_s = 0.0, slowest_s = 0.0, megapixels = 0.0;
  for (const fs::path& file : pictures_in(folder)) {
    const DecodedPhoto photo = decoder.decode(file, quiet);
    const Image<std::uint8_t> grey = grey_of(srgb_of(photo));
    const Stopwatch watch;
    views.push_back({file.stem().string(), photo.width_px, photo.height_px,
                     identity_of(photo.metadata), find_board(grey, shape, quiet)});
    cpu_s += watch.cpu_s();
    wall_s += watch.wall_s();
    slowest_s = std::max(slowest_s, watch.cpu_s());
    megapixels += photo.width_px * 1e-6 * photo.height_px;
  }
  const auto found = std::count_if(views.begin(), views.end(),
                                   [](const BoardView& view) { return !view.corners.empty(); });
  std::printf(
      "%td boards in %zu photos of %.1f megapixels: %.2f s CPU, %.2f s wall; slowest %.2f s\n",
      found, views.size(), megapixels / double(std::max<std::size_t>(1, views.size())), cpu_s,
      wall_s, slowest_s);
  return views;
}

LensCalibration solved(const std::vector<BoardView>& views, const BoardShape& shape) {
  Progress quiet;
  const Stopwatch watch;
  LensCalibration calibration = calibrate_lens(views, shape, {}, quiet);
  std::printf("solved in %.2f s CPU, %.2f s wall\n", watch.cpu_s(), watch.wall_s());
  return calibration;
}

int run_folder(int count, char** arguments) {
  BoardShape shape;
  if (std::sscanf(arguments[2], "%dx%d", &shape.columns, &shape.rows) != 2)
    throw Error("give the board as COLUMNSxROWS inner corners, such as 9x6");
  if (count > 3) shape.square_m = std::stod(arguments[3]);
  const LensCalibration calibration = solved(found_boards(arguments[1], shape), shape);
  print_boards(calibration);
  print_lens(calibration);
  print_verdict(calibration);
  if (count > 4) {
    write_png(fs::path(arguments[4]) / "coverage.png", coverage_picture(calibration, 640));
    write_png(fs::path(arguments[4]) / "uncertainty.png",
              uncertainty_picture(calibration.profile, 640));
  }
  return 0;
}

Lens rational_lens(int width_px, int height_px) {
  Lens lens = phone_lens(width_px, height_px);
  lens.distortion = {0.9, -0.35, 8e-4, -6e-4, 0.06, 1.25, -0.25, -0.02};
  return lens;
}

void synthetic_row(const char* name, const Lens& lens, const SyntheticBoards& what) {
  Progress quiet;
  const std::vector<BoardView> views = synthetic_views(lens, what);
  const Stopwatch watch;
  const LensCalibration calibration = calibrate_lens(views, what.shape, {}, quiet);
  const double cpu_s = watch.cpu_s(), wall_s = watch.wall_s();
  const LensDifference off = lens_difference(lens, calibration.profile.lens);
  std::string model;
  for (const LensTrial& trial : calibration.trials)
    if (trial.chosen) model = trial.model;
  int outliers = 0;
  for (const CornerResidual& corner : calibration.residuals) outliers += corner.outlier ? 1 : 0;
  const auto& sigma = calibration.profile.uncertainty_px.pixels();
  const double worst = sigma.empty() ? 0.0 : *std::max_element(sigma.begin(), sigma.end());
  std::printf("%-30s %6d %6.2f %6.2f  %-8s %7.4f %8d %8.3f %8.3f %10.3f  %s\n", name, what.boards,
              cpu_s, wall_s, model.c_str(), calibration.profile.rms_px, outliers, off.rms_px,
              off.max_px, worst, text_of(calibration.verdict));
}

int run_synthetic(int, char**) {
  const Lens phone = phone_lens(4032, 3024), rational = rational_lens(4032, 3024);
  std::printf(
      "10 x 7 corners, 12 megapixels, noise 0.1 px unless said\n%-30s boards  CPU s wall s  "
      "%-8s  rms px outliers  off rms  off max sigma max  verdict\n",
      "", "model");
  for (const int boards : {5, 10, 20, 40}) synthetic_row("opencv4 lens", phone, {.boards = boards});
  for (const int boards : {20, 40}) synthetic_row("opencv8 lens", rational, {.boards = boards});
  synthetic_row("5 % gross corners", phone, {.boards = 40, .gross_share = 0.05});
  synthetic_row("board warped by 1 and -0.5 mm", phone, {.boards = 40, .warp_m = {1e-3, -0.5e-3}});
  synthetic_row("noise 0.5 px", phone, {.boards = 40, .noise_px = 0.5});
  synthetic_row("all from the front", phone, {.boards = 20, .largest_tilt = 0.03});
  synthetic_row("all in the middle", phone, {.boards = 20, .spread = 0.05});
  return 0;
}

// Of the solved lens: where it sees what the true one sees at `pixel`, the mean turn of all boards
// taken out, less `pixel`.
glm::dvec2 seen_off(const Lens& truth, const LensCalibration& result,
                    const std::vector<RigidTransform>& poses, const glm::dvec2& pixel) {
  glm::dvec3 turn(0.0);
  for (std::size_t i = 0; i < poses.size(); ++i)
    turn += rodrigues_from_rotation(result.boards[i].camera_from_board.rotation *
                                    glm::transpose(poses[i].rotation)) /
            double(poses.size());
  const glm::dvec3 ray = camera_from_pixel(truth, pixel).value();
  return pixel_from_camera(result.profile.lens, rotation_from_rodrigues(turn) * ray).value() -
         pixel;
}

struct Spread {
  double predicted_px = 0.0, found_px = 0.0;
};

// Over the frame and over seeds of noise; rms along an axis.
Spread spread_over_noise(const Lens& lens, const char* model, int boards, double noise_px,
                         int seeds) {
  Progress quiet;
  std::vector<RigidTransform> poses;
  const SyntheticBoards what{.boards = boards, .noise_px = 0.0};
  const auto exact = synthetic_views(lens, what, &poses);
  Spread sum;
  std::size_t count = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    const auto views = with_noise(exact, noise_px, std::uint64_t(seed));
    const LensCalibration result = calibrate_lens(views, what.shape, {.model = model}, quiet);
    const Image<float>& sigma = result.profile.uncertainty_px;
    for (int y = 0; y < sigma.height(); ++y)
      for (int x = 0; x < sigma.width(); ++x, ++count) {
        const glm::dvec2 size(lens.width_px, lens.height_px);
        const glm::dvec2 cells(sigma.width(), sigma.height());
        const glm::dvec2 pixel = (glm::dvec2(x, y) + 0.5) / cells * size - 0.5;
        const glm::dvec2 off = seen_off(lens, result, poses, pixel);
        sum.predicted_px += double(sigma(x, y)) * sigma(x, y);
        sum.found_px += 0.5 * glm::dot(off, off);
      }
  }
  return {std::sqrt(sum.predicted_px / double(count)), std::sqrt(sum.found_px / double(count))};
}

int run_spread(int count, char** arguments) {
  const int seeds = count > 2 ? std::stoi(arguments[2]) : 50;
  const Lens phone = phone_lens(4032, 3024), rational = rational_lens(4032, 3024);
  std::printf(
      "rms over the frame and %d seeds, px along an axis\n%-8s boards noise  predicted  found  "
      "ratio\n",
      seeds, "model");
  for (const int boards : {6, 12, 24})
    for (const char* model : {"opencv4", "opencv8"}) {
      const Lens& lens = std::string(model) == "opencv8" ? rational : phone;
      const Spread spread = spread_over_noise(lens, model, boards, 0.2, seeds);
      std::printf("%-8s %6d %5.1f %10.4f %6.4f %6.2f\n", model, boards, 0.2, spread.predicted_px,
                  spread.found_px, spread.predicted_px / spread.found_px);
    }
  return 0;
}

void find_row(const char* name, const BoardShape& shape, int width_px, const glm::dvec3& turn,
              double distance_m, const BoardPaint& paint = {}) {
  Progress quiet;
  const Lens lens = phone_lens(width_px, width_px * 3 / 4);
  const RigidTransform pose =
      board_pose(shape, lens, turn, {0.47 * lens.width_px, 0.5 * lens.height_px}, distance_m);
  const Image<std::uint8_t> picture = paint_board(shape, lens, pose, paint);
  const auto truth = true_corners(shape, lens, pose);
  const Stopwatch watch;
  const auto found = find_board(picture, shape, quiet);
  const double cpu_s = watch.cpu_s(), wall_s = watch.wall_s();
  double squares = 0.0, worst = 0.0;
  for (const BoardCorner& corner : found)
    for (const BoardCorner& other : truth) {
      if (corner.column != other.column || corner.row != other.row) continue;
      const double off = glm::distance(corner.pixel, other.pixel);
      squares += off * off;
      worst = std::max(worst, off);
    }
  const double rms = found.empty() ? 0.0 : std::sqrt(squares / (2.0 * double(found.size())));
  std::printf("%-36s %6.1f %5zu/%-5zu %7.3f %7.3f %7.2f %7.2f\n", name,
              width_px * 1e-6 * lens.height_px, found.size(), truth.size(), rms, worst, cpu_s,
              wall_s);
}

int run_find(int, char**) {
  const BoardShape nine{}, ten{BoardKind::chessboard, 10, 10, 0.03},
      charuco{BoardKind::charuco, 8, 5, 0.03};
  const glm::dvec3 tilted(0.5, -0.4, 0.2);
  std::printf("%-36s     MP     found  rms px  max px   CPU s  wall s\n", "");
  find_row("9 x 6, from the front", nine, 1414, glm::dvec3(0.0), 0.35);
  find_row("9 x 6, tilted", nine, 1414, tilted, 0.35);
  find_row("9 x 6, lit unevenly", nine, 1414, tilted, 0.35, {.lit_unevenly = 0.7});
  find_row("9 x 6, blur 2 px, noise 8", nine, 1414, tilted, 0.35, {.blur_px = 2.0, .noise = 8.0});
  find_row("9 x 6, far away", nine, 1414, tilted, 1.6);
  find_row("10 x 10 (mrgingham), tilted", ten, 1414, tilted, 0.55);
  find_row("ChArUco 8 x 5, tilted", charuco, 1414, tilted, 0.3);
  for (const int width : {4032, 5656}) {
    find_row("9 x 6, tilted", nine, width, tilted, 0.35);
    find_row("9 x 6, far away", nine, width, tilted, 5.0);
    find_row("10 x 10 (mrgingham), tilted", ten, width, tilted, 0.55);
    find_row("ChArUco 8 x 5, tilted", charuco, width, tilted, 0.3);
    find_row("none in sight", nine, width, tilted, 300.0);
  }
  return 0;
}

int print_help() {
  std::printf(
      "lens_benchmark                                         synthetic boards: time and accuracy\n"
      "lens_benchmark FOLDER COLUMNSxROWS [SQUARE_M [OUT]]    photos of a chessboard; pictures to "
      "OUT\n"
      "lens_benchmark spread [SEEDS]                          predicted uncertainty beside the "
      "spread\n"
      "lens_benchmark find                                    painted boards, 1.5 to 24 "
      "megapixels\n");
  return 0;
}

int run_lens(int count, char** arguments) {
  const std::string first = count > 1 ? arguments[1] : "";
  if (first == "--help") return print_help();
  if (first == "spread") return run_spread(count, arguments);
  if (first == "find") return run_find(count, arguments);
  return count > 2 ? run_folder(count, arguments) : run_synthetic(count, arguments);
}

}  // namespace
}  // namespace bosk

int main(int argc, char** argv) {
  if (const auto status = bosk::run_child_mode(argc, argv)) return *status;
  return bosk::run_or_explain(bosk::run_lens, argc, argv);
}
