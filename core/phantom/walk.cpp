#include "core/phantom/walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/random.h"

namespace bosk {
namespace {

constexpr double kTau = 6.283185307179586;
constexpr double kMargin = 0.035;  // of the picture, free on every side of the tree

std::string numbered(std::size_t number) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%03zu", number);
  return text.data();
}

RigidTransform look_at(const glm::dvec3& eye, const glm::dvec3& target, double roll) {
  const glm::dvec3 forward = glm::normalize(target - eye);
  const glm::dvec3 level = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 below = glm::cross(forward, level);
  const glm::dvec3 right = std::cos(roll) * level + std::sin(roll) * below;
  const glm::dmat3 world_from_camera(right, glm::cross(forward, right), forward);
  return inverse(RigidTransform{world_from_camera, eye});
}

// A place to stand, drawn before the distance is known.
struct Stand {
  double angle = 0.0, reach = 1.0;           // reach: relative to the walk's radius
  double eye_height = 1.6, elevation = 0.0;  // elevation: radians, instead of the eye height
  glm::dvec3 aim{0.0};  // off the crown's centre, relative to the tree's height
  double roll = 0.0;
};

struct Subject {
  std::vector<glm::dvec3> points;
  glm::dvec3 centre{0.0};
  double height = 1.0;
};

Subject subject_of(const std::vector<glm::vec3>& points) {
  Subject subject;
  glm::dvec3 lower(1e30), upper(-1e30);
  for (const glm::vec3& point : points) {
    lower = glm::min(lower, glm::dvec3(point));
    upper = glm::max(upper, glm::dvec3(point));
  }
  const std::size_t step = std::max<std::size_t>(1, points.size() / 3000);
  for (std::size_t i = 0; i < points.size(); i += step) subject.points.emplace_back(points[i]);
  subject.centre = {0.5 * (lower.x + upper.x), 0.5 * (lower.y + upper.y),
                    0.5 * (lower.z + upper.z)};
  subject.height = upper.z - lower.z;
  return subject;
}

Camera camera_at(const Stand& stand, double radius, const Subject& subject, const Lens& lens) {
  const double distance = radius * stand.reach;
  const double flat = distance * std::cos(stand.elevation);
  glm::dvec3 eye{flat * std::cos(stand.angle), flat * std::sin(stand.angle), stand.eye_height};
  if (stand.elevation > 0.0) eye.z = subject.centre.z + distance * std::sin(stand.elevation);
  const glm::dvec3 target = subject.centre + stand.aim * subject.height;
  return {{}, lens, look_at(eye, target, stand.roll)};
}

bool in_picture(const Camera& camera, const Subject& subject) {
  const double w = camera.lens.width_px, h = camera.lens.height_px;
  const double margin = kMargin * std::min(w, h);
  return std::all_of(subject.points.begin(), subject.points.end(), [&](const glm::dvec3& point) {
    const auto pixel = project(camera, point);
    return pixel && pixel->x > margin && pixel->y > margin && pixel->x < w - margin &&
           pixel->y < h - margin;
  });
}

// The shortest radius from which every stand has the whole tree in its picture.
double fitting_radius(const std::vector<Stand>& stands, const Subject& subject, const Lens& lens) {
  double near = 0.3 * subject.height, far = 20.0 * subject.height;
  for (int round = 0; round < 20; ++round) {
    const double middle = 0.5 * (near + far);
    const bool fits = std::all_of(stands.begin(), stands.end(), [&](const Stand& stand) {
      return in_picture(camera_at(stand, middle, subject, lens), subject);
    });
    (fits ? far : near) = middle;
  }
  return far;
}

Stand jittered(double angle, double scale, Random& random) {
  Stand stand;
  stand.angle = angle;
  stand.reach = random.uniform(0.97, 1.06);
  stand.eye_height = scale * (1.6 + 2.4 * std::pow(random.uniform(), 3.0));
  stand.aim = {random.uniform(-0.015, 0.015), random.uniform(-0.015, 0.015),
               random.uniform(-0.01, 0.02)};
  stand.roll = random.uniform(-0.02, 0.02);
  return stand;
}

std::vector<Stand> ring(int count, double shift, double scale, Random& random) {
  std::vector<Stand> stands;
  for (int i = 0; i < count; ++i) {
    const double angle = kTau * (i + shift + random.uniform(-0.15, 0.15)) / count;
    stands.push_back(jittered(angle, scale, random));
  }
  return stands;
}

std::vector<Camera> cameras_at(const std::vector<Stand>& stands, double radius,
                               const Subject& subject, const Lens& lens) {
  std::vector<Camera> cameras;
  for (const Stand& stand : stands) {
    cameras.push_back(camera_at(stand, radius, subject, lens));
    cameras.back().name = numbered(cameras.size() - 1);
  }
  return cameras;
}

}  // namespace

Lens phantom_lens(const PhantomOptions& options) {
  Lens lens;
  lens.width_px = options.width_px;
  lens.height_px = options.height_px;
  const double longer = std::max(options.width_px, options.height_px);
  lens.focal_px = glm::dvec2(0.97 * longer);
  lens.principal_px = {(options.width_px - 1) / 2.0 + 0.0024 * longer,
                       (options.height_px - 1) / 2.0 - 0.0032 * longer};
  if (options.distortion != 0.0) {
    lens.model = LensModel::opencv;
    lens.distortion = {options.distortion, -0.2 * options.distortion};
  }
  return lens;
}

Walk walk_round(const std::vector<glm::vec3>& tree_points, const PhantomOptions& options) {
  const Subject subject = subject_of(tree_points);
  const Lens lens = phantom_lens(options);
  const double scale = std::min(1.0, subject.height / 9.0);
  const auto seed = std::uint64_t(options.seed);
  Random random(seed, 8);
  const double start = random.uniform();
  const std::vector<Stand> stands = ring(options.photos, start, scale, random);
  std::vector<Stand> between = ring(options.held_out, start + 0.27, scale, random);
  for (std::size_t i = 1; i < between.size(); i += 2) {
    between[i].elevation = random.uniform(10.0, 35.0) * kTau / 360.0;
    between[i].reach += 0.1;
  }
  const double radius =
      options.radius_m > 0.0 ? options.radius_m : fitting_radius(stands, subject, lens);
  return {cameras_at(stands, radius, subject, lens), cameras_at(between, radius, subject, lens)};
}

std::vector<Camera> board_views(const Board& board, const PhantomOptions& options) {
  const Lens lens = phantom_lens(options);
  Random random(std::uint64_t(options.seed), 9);
  const glm::dvec3 size = board.square * glm::dvec3(board.columns, board.rows, 0.0);
  const double fill = std::max(size.x / options.width_px, size.y / options.height_px);
  std::vector<Camera> cameras;
  for (int i = 0; i < options.board_photos; ++i) {
    const glm::dvec3 off{random.uniform(-0.8, 0.8), random.uniform(-0.25, 0.6), 1.0};
    const double distance = lens.focal_px.x * fill * random.uniform(1.15, 2.0);
    const glm::dvec3 aim =
        size * glm::dvec3(random.uniform(0.25, 0.75), random.uniform(0.25, 0.75), 0);
    const glm::dvec3 eye = board.world_from_board * (0.5 * size + distance * glm::normalize(off));
    const double roll = random.uniform(-0.3, 0.3);
    cameras.push_back(
        {numbered(std::size_t(i)), lens, look_at(eye, board.world_from_board * aim, roll)});
  }
  return cameras;
}

}  // namespace bosk
