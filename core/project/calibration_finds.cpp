#include "core/project/calibration_finds.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/calibrate/identify.h"
#include "core/project/board_lens.h"
#include "core/project/feature_finds.h"
#include "core/project/photo_finds.h"

namespace bosk {
namespace {

LookFor wanted_at_tree(const CalibrateOptions& options) {
  LookFor wanted;
  if (options.find_balls) wanted.balls = options.balls;
  if (options.tags != "none") wanted.tags = options.tags;
  if (options.board_at_tree) wanted.board = board_of(options);
  return wanted;
}

void append(std::vector<Sighting> more, std::vector<Sighting>& all) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void append(const std::vector<std::string>& more, std::vector<std::string>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

// Moves those that could not be read aside.
std::vector<PhotoFinds> readable(std::vector<PhotoFinds> all, CalibrationFinds& finds) {
  std::vector<PhotoFinds> kept;
  for (PhotoFinds& photo : all) {
    if (photo.trouble.empty()) {
      kept.push_back(std::move(photo));
    } else {
      finds.unread.push_back({photo.name, photo.trouble});
    }
  }
  if (!kept.empty()) return kept;
  const UnreadPhoto& first = finds.unread.front();
  throw Error("none of the " + std::to_string(finds.unread.size()) + " photos can be read; " +
              printable(first.photo) + ": " + first.reason);
}

PhotoSightings sightings_of(const PhotoFinds& photo, const std::vector<BallIdentity>& balls) {
  PhotoSightings seen{photo.name,          photo.width_px,     photo.height_px,
                      photo.exif_focal_px, photo.up_in_camera, {}};
  append(ball_sightings(photo.balls, balls), seen.sightings);
  append(tag_sightings(photo.tags), seen.sightings);
  append(board_sightings(photo.corners), seen.sightings);
  return seen;
}

void name_points(const std::vector<PhotoFinds>& photos, CalibrationFinds& finds) {
  std::vector<std::vector<SightedBall>> balls;
  std::vector<std::string> names;
  for (const PhotoFinds& photo : photos) {
    balls.push_back(photo.balls);
    names.push_back(photo.name);
  }
  const BallNames named = name_balls(balls, names);
  append(named.sentences, finds.sentences);
  for (std::size_t i = 0; i < photos.size(); ++i) {
    finds.photos.push_back(sightings_of(photos[i], named.balls[i]));
  }
}

std::vector<RigidBody> bodies_of(const std::vector<PhotoFinds>& photos,
                                 const CalibrateOptions& options) {
  std::vector<RigidBody> bodies;
  std::set<int> tags;
  bool board = false;
  for (const PhotoFinds& photo : photos) {
    for (const SightedTag& tag : photo.tags) tags.insert(tag.id);
    board = board || !photo.corners.empty();
  }
  if (options.tag_side_m > 0.0) {
    for (const int id : tags) bodies.push_back(tag_body(id, options.tag_side_m));
  }
  if (board) bodies.push_back(board_body(board_of(options)));
  return bodies;
}

constexpr const char* kFound = "found";
constexpr int kFoundKept = 8;

// Of sources that were looked through; parts left out count where features were looked for.
ContentHash found_key(const CalibrationSources& sources, bool with_left_out) {
  CalibrationSources files;
  files.photos = sources.photos;
  files.boards = sources.boards;
  files.profile = sources.profile;
  files.options = sources.options;
  if (with_left_out) files.left_out = sources.left_out;
  const ContentHash untold = calibration_key(files);
  ContentHasher hasher;
  hasher.text(kFound).value(untold.high).value(untold.low).value(std::uint8_t(with_left_out));
  return hasher.finish();
}

}  // namespace

bool was_found(const CalibrationSources& sources, const Cache& cache) {
  return cache.contains(kFound, found_key(sources, false)) ||
         cache.contains(kFound, found_key(sources, true));
}

CalibrationFinds find_for_calibration(const CalibrationSources& sources, const Cache& cache,
                                      Progress& progress) {
  const CalibrateOptions& options = sources.options;
  CalibrationFinds finds;
  std::vector<PhotoFinds> photos;
  {
    const ProgressPart part(progress, 0.0, 0.5);
    photos = readable(
        find_in_photos(sources.photos, wanted_at_tree(options), sources.limits, cache, progress),
        finds);
  }
  name_points(photos, finds);
  finds.bodies = bodies_of(photos, options);
  {
    const ProgressPart part(progress, 0.5, 0.7);
    LensChoice choice = choose_lens(sources, photos, cache, progress);
    finds.lens = choice.knowledge;
    finds.boards = std::move(choice.boards);
    append(choice.sentences, finds.sentences);
  }
  const ProgressPart part(progress, 0.7, 1.0);
  if (needs_features(finds.photos, options)) {
    add_features(sources, cache, finds, progress);
  }
  if (!finds.unread.empty()) return finds;  // looked at again each time
  const ContentHash found = found_key(sources, finds_features(finds));
  cache.store(kFound, found, {}, 0.0);
  cache.forget_old(kFound, found, kFoundKept);
  return finds;
}

}  // namespace bosk
