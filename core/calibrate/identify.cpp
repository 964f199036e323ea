#include "core/calibrate/identify.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/calibrate/colour_words.h"

namespace bosk {
namespace {

using glm::vec2;

constexpr float kOneColour = 18.0f;     // saturation; balls nearer than this are of one group
constexpr double kClearlySeen = 0.8;    // share of the disc that must show to found a group
constexpr double kOneLength = 0.11;     // relative difference of sticks' lengths
constexpr std::size_t kFewestFeet = 3;  // to tell a stick's length

struct BallPlace {
  std::size_t photo = 0, ball = 0;
};

struct Group {
  std::vector<BallPlace> members;
  vec2 saturation{0.0f};
  float lightness = 0.0f;
};

using Photos = std::span<const std::vector<SightedBall>>;

const SightedBall& at(Photos photos, const BallPlace& place) {
  return photos[place.photo][place.ball];
}

float median(std::vector<float> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Value>
float median_of(Photos photos, const std::vector<BallPlace>& members, Value&& value) {
  std::vector<float> values;
  for (const BallPlace& place : members) values.push_back(value(at(photos, place)));
  return median(std::move(values));
}

void update_colour(Photos photos, Group& group) {
  group.saturation.x =
      median_of(photos, group.members, [](const auto& b) { return b.saturation.x; });
  group.saturation.y =
      median_of(photos, group.members, [](const auto& b) { return b.saturation.y; });
  group.lightness = median_of(photos, group.members, [](const auto& b) { return b.lightness; });
}

bool are_linked(Photos photos, const Group& group, const SightedBall& ball) {
  return std::any_of(group.members.begin(), group.members.end(), [&](const BallPlace& place) {
    return glm::distance(at(photos, place).saturation, ball.saturation) < kOneColour;
  });
}

// Balls that chains of like colours connect are of one group (single linkage).
void add_to_groups(Photos photos, const BallPlace& place, std::vector<Group>& groups) {
  Group joined;
  joined.members.push_back(place);
  std::vector<Group> others;
  for (Group& group : groups) {
    if (are_linked(photos, group, at(photos, place)))
      joined.members.insert(joined.members.end(), group.members.begin(), group.members.end());
    else
      others.push_back(std::move(group));
  }
  others.push_back(std::move(joined));
  groups = std::move(others);
}

std::vector<BallPlace> places(Photos photos, bool clearly_seen) {
  std::vector<BallPlace> result;
  for (std::size_t photo = 0; photo < photos.size(); ++photo)
    for (std::size_t ball = 0; ball < photos[photo].size(); ++ball)
      if ((photos[photo][ball].visible >= kClearlySeen) == clearly_seen)
        result.push_back({photo, ball});
  return result;
}

std::size_t photo_count(const Group& group) {
  std::vector<std::size_t> photos;
  for (const BallPlace& place : group.members) photos.push_back(place.photo);
  std::sort(photos.begin(), photos.end());
  return std::size_t(std::unique(photos.begin(), photos.end()) - photos.begin());
}

std::vector<Group> groups_of_clear_balls(Photos photos) {
  std::vector<Group> groups;
  for (const BallPlace& place : places(photos, true)) add_to_groups(photos, place, groups);
  std::erase_if(groups, [](const Group& group) { return photo_count(group) < 2; });
  for (Group& group : groups) update_colour(photos, group);
  return groups;
}

// What is half hidden is paler by what hides it: its group is the one nearest in hue, if no other
// is nearly as near.
Group* group_of_hidden(const SightedBall& ball, std::vector<Group>& groups) {
  Group* best = nullptr;
  double nearest = 0.35, second = 1e9;  // radians of hue
  for (Group& group : groups) {
    const vec2 a = ball.saturation, b = group.saturation;
    const double turn = std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
    if (turn < nearest) {
      if (best) second = nearest;
      nearest = turn;
      best = &group;
    } else {
      second = std::min(second, turn);
    }
  }
  return best && nearest < 0.6 * second ? best : nullptr;
}

bool shows_twice(const Group& group, std::size_t photo) {
  return std::count_if(group.members.begin(), group.members.end(),
                       [&](const BallPlace& place) { return place.photo == photo; }) > 1;
}

// Photos in which more than one ball of the group shows.
std::vector<std::size_t> photos_with_doubles(const Group& group, std::size_t photos) {
  std::vector<std::size_t> doubles;
  for (std::size_t photo = 0; photo < photos; ++photo)
    if (shows_twice(group, photo)) doubles.push_back(photo);
  return doubles;
}

std::string doubles_sentence(const std::string& name, std::span<const std::size_t> doubles,
                             std::span<const std::string> photo_names) {
  return "photos " + photo_names[doubles[0]] + " and " + photo_names[doubles[1]] +
         " show more than one " + name +
         " ball, so none of that colour was used: give each ball a colour of its own, or name them "
         "by clicks";
}

// A stick's length in radii of its ball; the same from everywhere, but for the camera's height.
std::optional<float> stick_length(const SightedBall& ball) {
  if (!ball.foot) return {};
  return float(glm::distance(ball.foot->pixel, ball.centre_px) / ball.radius_px);
}

void judge_feet(Photos photos, const Group& group, BallNames& names) {
  std::vector<float> lengths;
  for (const BallPlace& place : group.members)
    if (const auto length = stick_length(at(photos, place))) lengths.push_back(*length);
  if (lengths.size() < kFewestFeet) return;
  const float usual = median(lengths);
  for (const BallPlace& place : group.members)
    if (const auto length = stick_length(at(photos, place)))
      names.balls[place.photo][place.ball].foot_counts =
          std::abs(*length / usual - 1.0f) < float(kOneLength);
}

void give_name(Photos photos, Group& group, const std::string& name,
               std::span<const std::string> photo_names, BallNames& names) {
  const auto doubles = photos_with_doubles(group, photos.size());
  if (doubles.size() >= 2 && 10 * doubles.size() >= photo_count(group)) {
    names.sentences.push_back(doubles_sentence(name, doubles, photo_names));
    return;
  }
  std::erase_if(group.members, [&](const BallPlace& place) {
    return std::find(doubles.begin(), doubles.end(), place.photo) != doubles.end();
  });
  for (const BallPlace& place : group.members) names.balls[place.photo][place.ball].name = name;
  judge_feet(photos, group, names);
}

}  // namespace

BallNames name_balls(Photos photos, std::span<const std::string> photo_names) {
  std::vector<Group> groups = groups_of_clear_balls(photos);
  for (const BallPlace& place : places(photos, false))
    if (Group* group = group_of_hidden(at(photos, place), groups)) group->members.push_back(place);
  std::vector<glm::vec3> colours;
  for (const Group& group : groups) colours.emplace_back(group.saturation, group.lightness);
  const std::vector<std::string> words = colour_words(colours);
  BallNames names;
  for (const auto& balls : photos) names.balls.emplace_back(balls.size());
  for (std::size_t i = 0; i < groups.size(); ++i)
    give_name(photos, groups[i], words[i], photo_names, names);
  return names;
}

std::string foot_name(const std::string& ball) { return ball + " foot"; }

std::vector<Sighting> ball_sightings(std::span<const SightedBall> balls,
                                     std::span<const BallIdentity> identities) {
  std::vector<Sighting> sightings;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const SightedBall& ball = balls[i];
    if (identities[i].name.empty()) continue;
    sightings.push_back({identities[i].name, ball.centre_px, ball.sigma_px, SightedBy::ball});
    if (ball.foot && identities[i].foot_counts)
      sightings.push_back(
          {foot_name(identities[i].name), ball.foot->pixel, ball.foot->sigma_px, SightedBy::ball});
  }
  return sightings;
}

}  // namespace bosk
