// orbit_benchmark: accuracy and CPU time of finding cameras from markers, on walks whose truth is
// known.
//
//   orbit_benchmark [--seeds=50] [--table=all|neat|uncertainty|walks|hostile] [--verbose]
//
// Every solve starts from sightings alone. Errors are after the similarity that fits best; CPU time
// counts all threads.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/calibrate/solve.h"
#include "orbit.h"

namespace bosk {
namespace {

bool verbose = false;

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
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
  int runs = 0, refused = 0, photos = 0, placed = 0, uncertain = 0, silent = 0;
  std::vector<double> marker_m, worst_crown_px, crown_px, sigma_px, cpu_s, scale_error;
};

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
  tally.worst_crown_px.push_back(errors.worst_crown_px);
  tally.scale_error.push_back(std::abs(errors.scale_error));
  for (std::size_t i = 0; i < errors.crown_px.size(); ++i) {
    const PhotoFinding& finding =
        finding_of(solved.calibration, solved.calibration.cameras[i].name);
    const bool placed = finding.fate == PhotoFate::placed;
    ++(placed ? tally.placed : tally.uncertain);
    tally.silent += placed && errors.crown_px[i] > 2.0 ? 1 : 0;
    if (verbose && placed && errors.crown_px[i] > 2.0)
      std::printf("  %s: %.2f px at the crown, sigma %.2f, %d sightings, %d left out\n",
                  finding.photo.c_str(), errors.crown_px[i], finding.crown_sigma_px,
                  finding.sightings, finding.outliers);
    tally.crown_px.push_back(errors.crown_px[i]);
    tally.sigma_px.push_back(finding.crown_sigma_px);
  }
}

void print_header() {
  std::printf("%-44s %6s %12s %6s %8s %8s %7s %7s %6s %6s\n", "walk", "solved", "placed photos",
              "unsure", "marker", "marker", "crown", "crown", "over", "CPU s");
  std::printf("%-44s %6s %12s %6s %8s %8s %7s %7s %6s %6s\n", "", "", "of all", "", "median",
              "worst", "px med", "px max", "2 px", "median");
}

void print(const std::string& name, const Tally& tally) {
  const auto worst = [](const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  };
  std::printf("%-44s %3d/%2d %6d/%5d %6d %5.2f mm %5.2f mm %7.2f %7.2f %6d %6.2f\n", name.c_str(),
              tally.runs - tally.refused, tally.runs, tally.placed, tally.photos, tally.uncertain,
              1000.0 * median_of(tally.marker_m), 1000.0 * worst(tally.marker_m),
              median_of(tally.crown_px), worst(tally.worst_crown_px), tally.silent,
              median_of(tally.cpu_s));
  std::fflush(stdout);
}

Tally tally_of(OrbitOptions options, bool known, int seeds, double focal_ratio = 0.94) {
  Tally tally;
  for (int seed = 1; seed <= seeds; ++seed) {
    options.seed = std::uint64_t(seed);
    const Orbit orbit = make_orbit(options);
    Survey survey;
    survey.tapes = {exact_tape(orbit, orbit.names[0], orbit.names[1])};
    const Solved solved = solve(orbit, survey, known, focal_ratio);
    add(orbit, solved, tally);
    if (verbose) {
      std::printf("  seed %d: CPU %.2f s\n%s", seed, solved.cpu_s,
                  sentences_of(solved.calibration).c_str());
    }
  }
  return tally;
}

void neat(int seeds) {
  std::printf("24 photos at 7 m, 8 markers, 0.5 px noise, 5 %% gross mistakes, one tape\n");
  print_header();
  for (const bool known : {true, false})
    print(known ? "lens known" : "lens free, guess 6 % short", tally_of({}, known, seeds));
}

void walks(int seeds) {
  struct Kind {
    const char* name;
    OrbitOptions options;
  };
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
  print_header();
  for (const Kind& kind : kinds)
    for (const bool known : {true, false})
      print(std::string(kind.name) + (known ? ", known" : ", free"),
            tally_of(kind.options, known, seeds));
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
    if (std::strncmp(argv[i], "--table=", 8) == 0) table = argv[i] + 8;
    if (std::strcmp(argv[i], "--verbose") == 0) verbose = true;
    if (std::strcmp(argv[i], "--help") == 0) {
      std::printf("orbit_benchmark [--seeds=50] [--table=all|neat|walks] [--verbose]\n");
      return 0;
    }
  }
  if (table == "all" || table == "neat") neat(seeds);
  if (table == "all" || table == "walks") walks(seeds);
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
