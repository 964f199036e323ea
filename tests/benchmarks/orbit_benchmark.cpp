// orbit_benchmark: accuracy and CPU time of finding cameras from markers, on walks whose truth is
// known.
//
//   orbit_benchmark [--seeds=50] [--first=1] [--table=all|neat|walks|others|uncertainty|features]
//   [--walk=NAME] [--verbose]
//
// Every solve starts from sightings alone. Errors are after the similarity that fits best; CPU time
// counts all threads.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

#include "core/base/random.h"
#include "core/calibrate/solve.h"
#include "core/calibrate/uncertainty.h"
#include "orbit.h"
#include "orbit_bundle.h"

namespace bosk {
namespace {

bool verbose = false;
std::string only;    // walks whose name has this in it
int first_seed = 1;  // of each kind of walk

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double share_of(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::size_t(share * double(values.size()))];
}

struct Solved {
  Calibration calibration;
  double cpu_s = 0.0;
};

Solved solve(const Orbit& orbit, const Survey& survey, bool lens_known, double focal_ratio) {
  Progress progress;
  const LensKnowledge lens{lens_known ? orbit.lens : guessed_orbit_lens(orbit, focal_ratio),
                           lens_known};
  const std::clock_t start = std::clock();
  Calibration calibration = solve_cameras(orbit.photos, survey, lens, {}, progress);
  return {std::move(calibration), double(std::clock() - start) / CLOCKS_PER_SEC};
}

// What many solves of one kind of walk came to.
struct Tally {
  int runs = 0, refused = 0, photos = 0, placed = 0, uncertain = 0;
  int over_2px = 0;    // placed photos whose crown is off by more
  int silent = 0;      // of them, those beyond four of their sigmas
  int bad_solves = 0;  // accepted solves with more than 2 px, root mean square over placed photos
  std::vector<double> marker_m, solve_crown_px, crown_px, in_sigmas, cpu_s, sigma_px;
};

void add_photo(const PhotoFinding& finding, double crown_px, Tally& tally) {
  const bool placed = finding.fate == PhotoFate::placed;
  ++(placed ? tally.placed : tally.uncertain);
  tally.sigma_px.push_back(finding.crown_sigma_px);
  if (!placed) return;
  tally.crown_px.push_back(crown_px);
  tally.in_sigmas.push_back(crown_px / finding.crown_sigma_px);
  tally.over_2px += crown_px > 2.0 ? 1 : 0;
  if (crown_px > std::max(2.0, 4.0 * finding.crown_sigma_px)) {
    ++tally.silent;
    std::printf("  %s: %.2f px at the crown, sigma %.2f, %d sightings, %d left out\n",
                finding.photo.c_str(), crown_px, finding.crown_sigma_px, finding.sightings,
                finding.outliers);
  }
}

void add(const Orbit& orbit, const Solved& solved, Tally& tally) {
  ++tally.runs;
  tally.cpu_s.push_back(solved.cpu_s);
  tally.photos += int(orbit.photos.size());
  if (solved.calibration.verdict == Verdict::refused) {
    ++tally.refused;
    return;
  }
  const OrbitErrors errors = orbit_errors(orbit, solved.calibration);
  tally.marker_m.push_back(errors.marker_median_m);
  tally.solve_crown_px.push_back(errors.crown_rms_px);
  tally.bad_solves += errors.crown_rms_px > 2.0 ? 1 : 0;
  for (std::size_t i = 0; i < errors.crown_px.size(); ++i)
    add_photo(finding_of(solved.calibration, solved.calibration.cameras[i].name),
              errors.crown_px[i], tally);
}

void print_header() {
  std::printf("%-44s %6s %13s %6s %16s %23s %7s %6s %6s %6s\n", "", "", "photos", "",
              "marker error mm", "crown error px", "in its", "photos", "beyond", "CPU s");
  std::printf("%-44s %6s %13s %6s %8s %7s %7s %7s %7s %7s %6s %6s %6s\n", "walk", "solved",
              "placed", "unsure", "median", "worst", "median", "worst", "bad", "sigmas", "> 2 px",
              "4 sigm", "median");
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / double(values.size()));
}

double worst(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

void print(const std::string& name, const Tally& tally) {
  std::printf("%-44s %3d/%2d %6d/%6d %6d %8.2f %7.2f %7.2f %7.2f %7d %7.2f %6d %6d %6.2f\n",
              name.c_str(), tally.runs - tally.refused, tally.runs, tally.placed, tally.photos,
              tally.uncertain, 1000.0 * median_of(tally.marker_m), 1000.0 * worst(tally.marker_m),
              median_of(tally.crown_px), worst(tally.solve_crown_px), tally.bad_solves,
              root_mean_square(tally.in_sigmas), tally.over_2px, tally.silent,
              median_of(tally.cpu_s));
  if (verbose)
    for (const double share : {0.1, 0.5, 0.9})
      std::printf("  sigma at the crown of %.0f %% of photos %.2f px\n", 100.0 * share,
                  share_of(tally.sigma_px, share));
  std::fflush(stdout);
}

Tally tally_of(OrbitOptions options, bool known, int seeds, double focal_ratio = 0.94) {
  Tally tally;
  for (int seed = first_seed; seed < first_seed + seeds; ++seed) {
    options.seed = std::uint64_t(seed);
    const Orbit orbit = make_orbit(options);
    Survey survey;
    survey.tapes = {exact_tape(orbit, orbit.names[0], orbit.names[1])};
    const Solved solved = solve(orbit, survey, known, focal_ratio);
    add(orbit, solved, tally);
    if (verbose)
      std::printf("  seed %d: CPU %.2f s\n%s", seed, solved.cpu_s,
                  sentences_of(solved.calibration).c_str());
  }
  return tally;
}

double cancel_ms(const Orbit& orbit, double after_s) {
  Progress progress;
  std::chrono::steady_clock::time_point asked;
  std::thread asker([&] {
    std::this_thread::sleep_for(std::chrono::duration<double>(after_s));
    asked = std::chrono::steady_clock::now();
    progress.cancel();
  });
  bool stopped = false;
  try {
    solve_cameras(orbit.photos, {}, {orbit.lens, true}, {}, progress);
  } catch (const Cancelled&) {
    stopped = true;
  }
  const auto end = std::chrono::steady_clock::now();
  asker.join();
  return stopped ? std::chrono::duration<double, std::milli>(end - asked).count() : 0.0;
}

double worst_cancel_ms(const Orbit& orbit, double whole_s) {
  double late = 0.0;
  for (int i = 0; i < 8; ++i) late = std::max(late, cancel_ms(orbit, whole_s * (i + 0.5) / 8.0));
  return late;
}

// Root mean square over the pairs of markers.
double distance_spread_over_prediction(std::uint64_t seed, int draws) {
  const OrbitBundle exact = orbit_bundle(make_orbit(
      {.seed = seed, .photos = 12, .markers = 7, .noise_px = 0.0, .gross = 0.0, .missing = 0.0}));
  BundleProblem problem = exact.problem;
  const auto& points = exact.state.points;
  problem.lengths = {{0, 3, glm::distance(points[0], points[3]), 0.002, true}};
  for (std::size_t i = 0; i < 6; ++i) problem.pinned.emplace_back()[i] = 1.0;
  Progress progress;
  double predicted = 0.0, observed = 0.0;
  for (int draw = 0; draw < draws; ++draw) {
    Random random(1000 * seed + std::uint64_t(draw));
    BundleProblem noisy = problem;
    for (BundleSighting& sighting : noisy.sightings)
      sighting.pixel += sighting.sigma_px * glm::dvec2(random.normal(), random.normal());
    noisy.lengths[0].length += noisy.lengths[0].sigma * random.normal();
    BundleState state = exact.state;
    solve_bundle(noisy, state, {kLeastSquares, 20}, progress);
    const BundleCovariance covariance(noisy, state, noise_factor(noisy, state), progress);
    for (std::size_t a = 0; a < points.size(); ++a) {
      for (std::size_t b = a + 1; b < points.size(); ++b) {
        const double off =
            glm::distance(state.points[a], state.points[b]) - glm::distance(points[a], points[b]);
        observed += off * off / draws;
        predicted += draw == 0 ? std::pow(covariance.distance_sigma(int(a), int(b)), 2.0) : 0.0;
      }
    }
  }
  return std::sqrt(observed / predicted);
}

void neat(int seeds) {
  std::printf("24 photos at 7 m, 8 markers, 0.5 px noise, 5 %% gross mistakes, one tape\n");
  print_header();
  for (const bool known : {true, false})
    print(known ? "lens known" : "lens free, guess 6 % short", tally_of({}, known, seeds));
}

struct Kind {
  const char* name;
  OrbitOptions options;
};

void print_kinds(const std::vector<Kind>& kinds, int seeds) {
  print_header();
  for (const Kind& kind : kinds)
    if (std::string(kind.name).find(only) != std::string::npos)
      for (const bool known : {true, false})
        print(std::string(kind.name) + (known ? ", known" : ", free"),
              tally_of(kind.options, known, seeds));
}

// Other distances, lenses and numbers than those that the bound of 1.2 px was chosen on.
void others(int seeds) {
  std::printf("\nother walks, one tape\n");
  print_kinds({{"at 4 m, wide lens", {.radius_m = 4.0, .focal_px = 2000.0}},
               {"at 12 m", {.radius_m = 12.0}},
               {"at 14 m, long lens", {.radius_m = 14.0, .focal_px = 6000.0}},
               {"strong distortion", {.distortion = -0.2}},
               {"36 photos, 12 markers", {.photos = 36, .markers = 12}},
               {"16 photos, 7 markers, uneven",
                {.photos = 16, .markers = 7, .jitter_deg = 12.0, .radius_jitter = 0.2}},
               {"two thirds round, two heights", {.turns = 0.67, .second_height_m = 3.0}},
               {"1 px noise, 10 % gross mistakes", {.noise_px = 1.0, .gross = 0.1}}},
              seeds);
}

void walks(int seeds) {
  const std::vector<Kind> kinds = {
      {"reversed", {.turns = -1.0}},
      {"uneven to 30 degrees, 30 % of radius", {.jitter_deg = 30.0, .radius_jitter = 0.3}},
      {"reversed and uneven", {.turns = -1.0, .jitter_deg = 30.0, .radius_jitter = 0.3}},
      {"half circle", {.turns = 0.5}},
      {"half circle reversed, uneven", {.turns = -0.5, .jitter_deg = 15.0}},
      {"quarter circle", {.turns = 0.25}},
      {"two heights", {.second_height_m = 4.0}},
      {"twice round", {.turns = 2.0}},
      {"12 photos", {.photos = 12}},
      {"6 photos", {.photos = 6}},
      {"6 markers", {.markers = 6}},
      {"5 markers", {.markers = 5}},
      {"4 markers, none missing", {.markers = 4, .missing = 0.0}},
      {"half of the sightings missing, 3 left at least",
       {.markers = 8, .missing = 0.5, .fewest_sightings = 3}},
      {"20 % gross mistakes", {.gross = 0.2}},
      {"3 px noise", {.noise_px = 3.0}},
      {"0.1 px noise", {.noise_px = 0.1}},
  };
  std::printf("\nwalks that aren't neat, one tape\n");
  print_kinds(kinds, seeds);
}

// Distances between all pairs of markers over 30 draws of noise, against what the first draw says.
void uncertainty(int seeds) {
  std::printf("\nmarker distances, 12 photos, 7 markers, 30 draws: spread over prediction\n");
  std::vector<double> ratios;
  for (int seed = 1; seed <= seeds; ++seed) {
    ratios.push_back(distance_spread_over_prediction(std::uint64_t(seed), 30));
    std::printf(" %.2f", ratios.back());
  }
  std::printf("\nmedian %.2f\n", median_of(ratios));
}

// Thousands of features besides the markers: a long solve, and how soon it stops.
void features() {
  std::printf(
      "\nfeatures: points  photos  sightings   wall s   CPU s  crown px  cancel ms (worst of 8)\n");
  for (const auto& [photos, points] : {std::pair(24, 1000), {24, 4000}, {60, 4000}}) {
    const Orbit orbit = make_orbit({.photos = photos, .markers = points, .missing = 0.6});
    const auto start = std::chrono::steady_clock::now();
    const Solved solved = solve(orbit, {}, true, 1.0);
    const double wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::size_t sightings = 0;
    for (const PhotoSightings& photo : orbit.photos) sightings += photo.sightings.size();
    std::printf("          %6d  %6d  %9zu  %7.2f %7.2f  %8.2f  %6.0f\n", points, photos, sightings,
                wall_s, solved.cpu_s, orbit_errors(orbit, solved.calibration).crown_rms_px,
                worst_cancel_ms(orbit, wall_s));
    std::fflush(stdout);
  }
}

int number_after(const char* argument, const char* option, int otherwise) {
  const std::size_t length = std::strlen(option);
  return std::strncmp(argument, option, length) == 0 ? std::atoi(argument + length) : otherwise;
}

int run(int argc, char** argv) {
  int seeds = 50;
  std::string table = "all";
  for (int i = 1; i < argc; ++i) {
    seeds = number_after(argv[i], "--seeds=", seeds);
    first_seed = number_after(argv[i], "--first=", first_seed);
    if (std::strncmp(argv[i], "--table=", 8) == 0) table = argv[i] + 8;
    if (std::strncmp(argv[i], "--walk=", 7) == 0) only = argv[i] + 7;
    if (std::strcmp(argv[i], "--verbose") == 0) verbose = true;
    if (std::strcmp(argv[i], "--help") == 0) {
      std::printf(
          "orbit_benchmark [--seeds=50] [--first=1] "
          "[--table=all|neat|walks|others|uncertainty|features] [--walk=NAME] [--verbose]\n");
      return 0;
    }
  }
  if (table == "all" || table == "neat") neat(seeds);
  if (table == "all" || table == "walks") walks(seeds);
  if (table == "all" || table == "others") others(seeds);
  if (table == "all" || table == "uncertainty") uncertainty(std::min(seeds, 20));
  if (table == "all" || table == "features") features();
  return 0;
}

}  // namespace
}  // namespace bosk

int main(int argc, char** argv) {
  try {
    return bosk::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "orbit_benchmark: %s\n", error.what());
    return 1;
  }
}
