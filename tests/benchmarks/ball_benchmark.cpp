// ball_benchmark [--list] CAPTURE...: finds and names the coloured balls of captures with truth,
// and prints how many, how well and how fast. A capture is a folder of `bosk phantom`, or one with
// marker_clicks.json. --list prints every ball.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "core/calibrate/identify.h"
#include "core/photo/child_mode.h"
#include "core/photo/decode.h"
#include "frame_times.h"
#include "run_or_explain.h"

namespace bosk {
namespace {

using nlohmann::json;

struct TrueBall {
  std::string name;
  glm::dvec2 pixel{0.0};
  double visible = 0.0;
};

struct TruePhoto {
  std::filesystem::path image;
  std::vector<TrueBall> balls;
};

TruePhoto photo_of(const std::filesystem::path& folder, const json& entry) {
  TruePhoto photo;
  photo.image = entry.contains("image")
                    ? folder / entry["image"].get<std::string>()
                    : folder / "photos" / (entry["name"].get<std::string>() + ".jpg");
  for (const json& ball : entry["markers"])
    photo.balls.push_back({ball["name"],
                           {ball["x"], ball["y"]},
                           ball.contains("visible_fraction")
                               ? ball["visible_fraction"].get<double>()
                               : ball["visible"].get<double>()});
  return photo;
}

std::vector<TruePhoto> read_truth(const std::filesystem::path& folder) {
  const std::filesystem::path clicks = folder / "marker_clicks.json";
  std::ifstream file(std::filesystem::exists(clicks) ? clicks : folder / "truth.json");
  if (!file) throw Error(folder.string() + ": no marker_clicks.json or truth.json is there");
  std::vector<TruePhoto> photos;
  const json truth = json::parse(file);
  for (const json& entry : truth["photos"]) photos.push_back(photo_of(folder, entry));
  return photos;
}

struct Tally {
  int shown = 0, found = 0, hidden_found = 0, extra = 0, named = 0, misnamed = 0, unnamed = 0,
      feet = 0;
  std::vector<double> errors, pulls;
};

// The nearest ball that a sighting can be of: within its radius.
const TrueBall* true_ball(const TruePhoto& photo, const SightedBall& ball) {
  const TrueBall* best = nullptr;
  double nearest = ball.radius_px;
  for (const TrueBall& truth : photo.balls) {
    const double distance = glm::distance(truth.pixel, ball.centre_px);
    if (truth.visible <= 0.1 || distance >= nearest) continue;
    nearest = distance;
    best = &truth;
  }
  return best;
}

void count(const TruePhoto& photo, std::span<const SightedBall> balls,
           std::span<const BallIdentity> identities,
           std::map<std::string, std::string>& truth_of_name, bool list, Tally& tally) {
  for (const TrueBall& truth : photo.balls) tally.shown += truth.visible >= 0.5;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const SightedBall& ball = balls[i];
    const TrueBall* truth = true_ball(photo, ball);
    const double error = truth ? glm::distance(truth->pixel, ball.centre_px) : -1.0;
    if (list)
      std::printf(
          "  %s %-10s %-8s (%.1f %.1f) r %.2f sigma %.2f shows %.2f/%.2f error %.2f (%+.2f %+.2f) "
          "u %.0f %.0f c %.0f foot %.1f %.1f\n",
          photo.image.stem().c_str(), identities[i].name.c_str(),
          truth ? truth->name.c_str() : "FALSE", ball.centre_px.x, ball.centre_px.y, ball.radius_px,
          ball.sigma_px, ball.visible, truth ? truth->visible : 0.0, error,
          truth ? ball.centre_px.x - truth->pixel.x : 0.0,
          truth ? ball.centre_px.y - truth->pixel.y : 0.0, double(ball.saturation.x),
          double(ball.saturation.y), ball.contrast,
          ball.foot && identities[i].foot_counts ? ball.foot->pixel.x : 0.0,
          ball.foot ? ball.foot->pixel.y : 0.0);
    if (!truth) {
      ++tally.extra;
      tally.named += !identities[i].name.empty();
      continue;
    }
    (truth->visible >= 0.5 ? tally.found : tally.hidden_found) += 1;
    tally.feet += ball.foot && identities[i].foot_counts;
    tally.unnamed += identities[i].name.empty();
    tally.errors.push_back(error);
    tally.pulls.push_back(error / (ball.sigma_px * std::sqrt(2.0)));
    if (identities[i].name.empty()) continue;
    const auto known = truth_of_name.emplace(identities[i].name, truth->name).first;
    tally.misnamed += known->second != truth->name;
  }
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / double(values.size()));
}

void measure(const std::filesystem::path& folder, bool list) {
  const std::vector<TruePhoto> photos = read_truth(folder);
  std::vector<std::vector<SightedBall>> balls;
  const Progress progress;
  double seconds = 0.0, megapixels = 0.0;
  for (const TruePhoto& photo : photos) {
    const Image<glm::vec3> srgb = srgb_of(decode_photo(photo.image, {}, progress));
    const auto start = std::chrono::steady_clock::now();
    balls.push_back(find_balls(srgb, {}, progress));
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    megapixels += 1e-6 * double(srgb.size());
  }
  std::vector<std::string> photo_names;
  for (const TruePhoto& photo : photos) photo_names.push_back(photo.image.stem());
  const BallNames names = name_balls(balls, photo_names);
  Tally tally;
  std::map<std::string, std::string> truth_of_name;
  for (std::size_t i = 0; i < photos.size(); ++i)
    count(photos[i], balls[i], names.balls[i], truth_of_name, list, tally);
  std::printf("%-24s %4d of %4d %5d %5d %5d %4d %4d %4d %6.3f %6.3f %6.3f %6.2f %7.3f %6.3f\n",
              folder.filename().c_str(), tally.found, tally.shown, tally.hidden_found, tally.extra,
              tally.named, tally.misnamed, tally.unnamed, tally.feet, quantile(tally.errors, 0.5),
              quantile(tally.errors, 0.95), quantile(tally.errors, 1.0),
              root_mean_square(tally.pulls), seconds / double(photos.size()), seconds / megapixels);
  for (const std::string& sentence : names.sentences) std::printf("  %s\n", sentence.c_str());
}

int run(int count, char** arguments) {
  bool list = false;
  std::printf("%-24s %12s %5s %5s %5s %4s %4s %4s %6s %6s %6s %6s %7s %6s\n", "capture",
              "shown found", "+part", "false", "named", "mix", "left", "feet", "median", "95 %",
              "most", "pull", "s/photo", "s/MP");
  for (int i = 1; i < count; ++i) {
    if (std::string(arguments[i]) == "--list")
      list = true;
    else
      measure(arguments[i], list);
  }
  return 0;
}

}  // namespace
}  // namespace bosk

int main(int count, char** arguments) {
  if (const auto status = bosk::run_child_mode(count, arguments)) return *status;
  return bosk::run_or_explain(bosk::run, count, arguments);
}
