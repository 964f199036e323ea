// capture_calibration_benchmark [options] PHOTO_FOLDER: cameras from photos alone; prints time and
// accuracy, and writes the cameras found as transforms.json, to be scored against the truth.
//   --out FILE           where to write the cameras (transforms.json)
//   --truth FILE         the true cameras: errors are printed after the best similarity
//   --heights a=0.5,...  heights of balls above the ground, metres: scale and up
//   --tags DICTIONARY,COLUMNS,ROWS,SIDE,SEPARATION   a printed board of tags, metres
//   --known-lens         take the lens of the true cameras as known
//   --no-balls, --no-feet, --no-features; --list prints each photo and point
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "core/calibrate/features.h"
#include "core/calibrate/identify.h"
#include "core/calibrate/solve.h"
#include "core/calibrate/tags.h"
#include "core/geometry/rotation.h"
#include "core/geometry/similarity.h"
#include "core/photo/camera_files.h"
#include "core/photo/child_mode.h"
#include "core/photo/decode.h"
#include "core/photo/import.h"
#include "frame_times.h"
#include "run_or_explain.h"

namespace bosk {
namespace {

struct Arguments {
  std::filesystem::path photos, out, truth;
  std::vector<Height> heights;
  std::string tag_dictionary;
  TagBoard tag_board;
  bool known_lens = false, balls = true, feet = true, features = true, list = false;
};

std::vector<Height> read_heights(const std::string& text) {
  std::vector<Height> heights;
  std::stringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto equals = part.find('=');
    if (equals == std::string::npos) throw Error("--heights: " + part + " is not NAME=METRES");
    heights.push_back({part.substr(0, equals), std::stod(part.substr(equals + 1)), 0.005});
  }
  return heights;
}

void read_tags(const std::string& text, Arguments& arguments) {
  std::stringstream parts(text);
  TagBoard& board = arguments.tag_board;
  char comma = 0;
  std::getline(parts, arguments.tag_dictionary, ',');
  parts >> board.columns >> comma >> board.rows >> comma >> board.side_m >> comma >>
      board.separation_m;
  if (!parts) throw Error("--tags: " + text + " is not DICTIONARY,COLUMNS,ROWS,SIDE,SEPARATION");
}

Arguments read_arguments(int count, char** texts) {
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string text = texts[i];
    const auto next = [&] { return std::string(i + 1 < count ? texts[++i] : ""); };
    if (text == "--out")
      arguments.out = next();
    else if (text == "--truth")
      arguments.truth = next();
    else if (text == "--heights")
      arguments.heights = read_heights(next());
    else if (text == "--tags")
      read_tags(next(), arguments);
    else if (text == "--known-lens")
      arguments.known_lens = true;
    else if (text == "--no-balls")
      arguments.balls = false;
    else if (text == "--no-feet")
      arguments.feet = false;
    else if (text == "--no-features")
      arguments.features = false;
    else if (text == "--list")
      arguments.list = true;
    else
      arguments.photos = text;
  }
  if (arguments.photos.empty()) throw Error("which folder of photos?");
  return arguments;
}

struct Loaded {
  std::vector<std::string> names;
  std::vector<std::filesystem::path> files;
  std::vector<Image<glm::vec3>> srgb;
  Lens lens;  // guessed
};

Loaded load(const std::filesystem::path& folder) {
  Loaded loaded;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string ending = entry.path().extension();
    if (ending == ".jpg" || ending == ".JPG" || ending == ".png")
      loaded.files.push_back(entry.path());
  }
  std::sort(loaded.files.begin(), loaded.files.end());
  if (loaded.files.empty()) throw Error(folder.string() + ": no photos are there");
  const Progress progress;
  PhotoDecoder decoder;
  for (const auto& file : loaded.files) {
    const DecodedPhoto photo = decoder.decode(file, progress);
    loaded.names.push_back(file.stem());
    loaded.srgb.push_back(srgb_of(photo));
    if (loaded.names.size() == 1) loaded.lens = guessed_lens(photo);
  }
  return loaded;
}

std::vector<PhotoSightings> empty_sightings(const Loaded& loaded) {
  std::vector<PhotoSightings> photos;
  for (std::size_t i = 0; i < loaded.names.size(); ++i) {
    PhotoSightings photo;
    photo.photo = loaded.names[i];
    photo.width_px = loaded.srgb[i].width();
    photo.height_px = loaded.srgb[i].height();
    photos.push_back(photo);
  }
  return photos;
}

void add_balls(const Loaded& loaded, bool feet, std::vector<PhotoSightings>& photos) {
  const Progress progress;
  std::vector<std::vector<SightedBall>> balls;
  for (const auto& srgb : loaded.srgb) balls.push_back(find_balls(srgb, {}, progress));
  BallNames names = name_balls(balls, loaded.names);
  std::size_t count = 0;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    if (!feet)
      for (BallIdentity& identity : names.balls[i]) identity.foot_counts = false;
    const auto sightings = ball_sightings(balls[i], names.balls[i]);
    photos[i].sightings.insert(photos[i].sightings.end(), sightings.begin(), sightings.end());
    count += sightings.size();
  }
  std::printf("balls: %zu sightings\n", count);
  for (const std::string& sentence : names.sentences) std::printf("  %s\n", sentence.c_str());
}

void score(const std::vector<Camera>& found, const std::filesystem::path& truth_file) {
  const std::vector<Camera> truth = read_cameras(truth_file);
  std::vector<glm::dvec3> ours, theirs;
  std::vector<std::pair<const Camera*, const Camera*>> pairs;
  for (const Camera& camera : found)
    for (const Camera& other : truth)
      if (camera.name == other.name) {
        ours.push_back(camera.centre_in_world());
        theirs.push_back(other.centre_in_world());
        pairs.emplace_back(&camera, &other);
      }
  if (pairs.size() < 3) {
    std::printf("score: only %zu photos in common\n", pairs.size());
    return;
  }
  const Similarity fit = fit_similarity(ours, theirs);
  double squares = 0.0, most_turn = 0.0, radius = 0.0;
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& centre : theirs) middle += centre / double(theirs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const glm::dvec3 off = fit * ours[i] - theirs[i];
    squares += glm::dot(off, off);
    radius += glm::dot(theirs[i] - middle, theirs[i] - middle);
    const glm::dmat3 turn = pairs[i].first->camera_from_world.rotation *
                            glm::transpose(fit.rotation) *
                            glm::transpose(pairs[i].second->camera_from_world.rotation);
    most_turn = std::max(most_turn, glm::length(rodrigues_from_rotation(nearest_rotation(turn))));
  }
  std::printf(
      "score: %zu of %zu photos, centres %.3f %% of the walk's radius, largest turn %.3f deg, "
      "scale %.5f, focal %.2f against %.2f\n",
      pairs.size(), truth.size(), 100.0 * std::sqrt(squares / radius),
      most_turn * 57.29577951308232, 1.0 / fit.scale, found[0].lens.focal_px.x,
      truth[0].lens.focal_px.x);
}

FeatureSightings add_features(const Loaded& loaded, const Lens& lens, bool lens_known,
                              std::vector<PhotoSightings>& photos, Progress& progress) {
  std::vector<FeaturePhoto> input;
  for (std::size_t i = 0; i < loaded.names.size(); ++i)
    input.push_back({loaded.names[i], &loaded.srgb[i], nullptr});
  FeatureSightings found = find_features(input, lens, lens_known, {}, progress);
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const auto& more = found.photos[i].sightings;
    photos[i].sightings.insert(photos[i].sightings.end(), more.begin(), more.end());
    std::printf("  %s: %zu features\n", photos[i].photo.c_str(), more.size());
  }
  for (const std::string& sentence : found.sentences) std::printf("  %s\n", sentence.c_str());
  return found;
}

void add_tags(const Loaded& loaded, const Arguments& arguments,
              std::vector<PhotoSightings>& photos) {
  const Progress progress;
  const TagBoard& board = arguments.tag_board;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    auto tags = find_tags(loaded.srgb[i], arguments.tag_dictionary, progress);
    std::erase_if(tags, [&](const SightedTag& tag) {
      return tag.id < board.first_id || tag.id >= board.first_id + board.columns * board.rows;
    });
    const auto sightings = tag_sightings(tags);
    photos[i].sightings.insert(photos[i].sightings.end(), sightings.begin(), sightings.end());
    std::printf("  %s: %zu tags\n", photos[i].photo.c_str(), tags.size());
  }
}

Survey survey_of(const Arguments& arguments) {
  Survey survey;
  survey.heights = arguments.heights;
  if (!arguments.tag_dictionary.empty())
    survey.bodies.push_back(tag_board_body(arguments.tag_board));
  if (!arguments.feet) return survey;
  for (const Height& height : arguments.heights) {
    survey.heights.push_back({foot_name(height.point), 0.0, 0.01});
    survey.tapes.push_back({foot_name(height.point), height.point, height.height_m, 0.005});
  }
  return survey;
}

void print(const Calibration& calibration, bool list) {
  const char* verdicts[] = {"good", "usable", "refused"};
  std::printf(
      "verdict %s: %zu of %zu photos, rms %.2f px, f %.1f k %.4f %.4f, scale %s (sigma %.4f)\n",
      verdicts[int(calibration.verdict)], calibration.cameras.size(), calibration.photos.size(),
      calibration.rms_px, calibration.lens.focal_px.x, calibration.lens.distortion[0],
      calibration.lens.distortion[1], calibration.scale_known ? "known" : "unknown",
      calibration.scale_sigma);
  for (const std::string& sentence : calibration.sentences) std::printf("  %s\n", sentence.c_str());
  if (!list) return;
  for (const PhotoFinding& photo : calibration.photos)
    std::printf("  %s fate %d sightings %d outliers %d rms %.2f crown %.2f %s\n",
                photo.photo.c_str(), int(photo.fate), photo.sightings, photo.outliers, photo.rms_px,
                photo.crown_sigma_px, photo.reason.c_str());
  for (const SolvedPoint& point : calibration.points)
    if (point.name[0] != 'f' || point.name.find("foot") != std::string::npos)
      std::printf("  %s (%.3f %.3f %.3f) photos %d rms %.2f\n", point.name.c_str(),
                  point.in_world.x, point.in_world.y, point.in_world.z, point.photos, point.rms_px);
}

int run(int count, char** texts) {
  const Arguments arguments = read_arguments(count, texts);
  const Loaded loaded = load(arguments.photos);
  std::vector<PhotoSightings> photos = empty_sightings(loaded);
  const auto start = Clock::now();
  if (arguments.balls) add_balls(loaded, arguments.feet, photos);
  std::printf("time: balls %.2f s\n", 1e-3 * ms_since(start));
  const auto tagging = Clock::now();
  if (!arguments.tag_dictionary.empty()) {
    add_tags(loaded, arguments, photos);
    std::printf("time: tags %.2f s\n", 1e-3 * ms_since(tagging));
  }
  const Lens lens = arguments.known_lens ? read_cameras(arguments.truth)[0].lens : loaded.lens;
  Progress progress;
  SolveOptions options;
  const auto matching = Clock::now();
  if (arguments.features) {
    const FeatureSightings found =
        add_features(loaded, lens, arguments.known_lens, photos, progress);
    for (std::size_t i = 0; i < photos.size(); ++i)
      if (found.camera_from_world[i])
        options.first_poses.push_back({photos[i].photo, *found.camera_from_world[i]});
    if (!arguments.truth.empty()) {
      std::vector<Camera> cameras;
      for (const FirstPose& pose : options.first_poses)
        cameras.push_back({pose.photo, found.lens, pose.camera_from_scene});
      score(cameras, arguments.truth);
    }
    std::printf("time: features %.2f s, %zu first poses\n", 1e-3 * ms_since(matching),
                options.first_poses.size());
  }
  const auto solving = Clock::now();
  const Calibration calibration =
      solve_cameras(photos, survey_of(arguments), {lens, arguments.known_lens}, options, progress);
  std::printf("time: solve %.2f s\n", 1e-3 * ms_since(solving));
  print(calibration, arguments.list);
  if (!arguments.out.empty() && !calibration.cameras.empty())
    write_cameras(calibration.cameras, "transforms", arguments.out);
  if (!arguments.truth.empty()) score(calibration.cameras, arguments.truth);
  return 0;
}

}  // namespace
}  // namespace bosk

int main(int count, char** arguments) {
  if (const auto status = bosk::run_child_mode(count, arguments)) return *status;
  return bosk::run_or_explain(bosk::run, count, arguments);
}
