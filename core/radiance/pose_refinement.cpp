#include "core/radiance/pose_refinement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/geometry/rotation.h"
#include "core/radiance/photo_residuals.h"
#include "core/radiance/volume_march.h"

namespace bosk {
namespace {

constexpr int kFolds = 3;
constexpr std::size_t kFewestPhotos = 6;  // two in each fold
constexpr int kBlockPx = 8;
constexpr double kCellPx = 2.0;  // of the volumes that photos are compared with, in small pixels
// A pose is held back as if it were known to so many small pixels. Neighbouring pixels err
// together: about kCorrelated of them count as one.
constexpr double kKnownPx = 2.0, kCorrelated = 16.0;

using Turn = Eigen::Vector3d;

bool takes_part(int x, int y) { return (x / kBlockPx + y / kBlockPx) % 2 == 0; }

// Where the tree is, for scaling motions and for telling how far they go.
struct Crown {
  glm::dvec3 centre{0.0};
  double radius_m = 1.0;
  std::array<glm::dvec3, 8> corners{};
};

Crown crown_of(const Box& bounds) {
  Crown crown{bounds.centre(), 0.5 * glm::length(bounds.size()), {}};
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 at(i & 1, i >> 1 & 1, i >> 2);
    crown.corners[std::size_t(i)] = bounds.lower + at * bounds.size();
  }
  return crown;
}

// Radians about x, y and z that move the crown by about one pixel.
Turn turn_units(const Camera& camera, const Crown& crown) {
  const double focal = camera.lens.focal_px.x;
  const double distance = glm::length(camera.camera_from_world * crown.centre);
  const double radius_px = std::max(1.0, focal * crown.radius_m / distance);
  return {1.0 / focal, 1.0 / focal, 1.0 / radius_px};
}

Image<float> alpha_of(const VolumeSnapshot& volume, const Camera& camera) {
  const Image<glm::vec4> picture = premultiplied_picture(volume, camera);
  Image<float> alpha(picture.width(), picture.height());
  for (std::size_t i = 0; i < alpha.size(); ++i) alpha.pixels()[i] = picture.pixels()[i].a;
  return alpha;
}

Camera turned(Camera camera, const Turn& turn) {
  const RigidTransform by{rotation_from_rodrigues({turn[0], turn[1], turn[2]}), glm::dvec3(0.0)};
  camera.camera_from_world = by * camera.camera_from_world;
  return camera;
}

// How what is seen at the pixel moves when the camera turns about x, y and z: a column each.
Eigen::Matrix<double, 2, 3> pixel_motion(const glm::dvec2& pixel, const Lens& lens,
                                         const Turn& units) {
  const glm::dvec2 slope = (pixel - lens.principal_px) / lens.focal_px;
  Eigen::Matrix<double, 2, 3> motion;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 turn(0.0);
    turn[axis] = units[axis];
    const glm::dvec3 shift = glm::cross(turn, glm::dvec3(slope, 1.0));
    const glm::dvec2 moved = (glm::dvec2(shift) - slope * shift.z) * lens.focal_px;
    motion.col(axis) << moved.x, moved.y;
  }
  return motion;
}

// One damped Gauss-Newton step of a photo's pose towards its matte.
Camera stepped(const VolumeSnapshot& volume, const SmallMatte& matte, const Crown& crown) {
  const Image<float> alpha = alpha_of(volume, matte.camera);
  const Turn units = turn_units(matte.camera, crown);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Turn gradient = Turn::Zero();
  double square = 0.0, count = 0.0;
  for (int y = 1; y + 1 < alpha.height(); ++y) {
    for (int x = 1; x + 1 < alpha.width(); ++x) {
      const double error = double(alpha(x, y)) - double(matte.premultiplied(x, y).a);
      if (!takes_part(x, y) || (alpha(x, y) <= 0.0f && error == 0.0)) continue;
      const Eigen::RowVector2d steepness(0.5 * double(alpha(x + 1, y) - alpha(x - 1, y)),
                                         0.5 * double(alpha(x, y + 1) - alpha(x, y - 1)));
      // What moves to the right shows at a pixel what was to the left of it
      const Turn slope = -(steepness * pixel_motion({x, y}, matte.camera.lens, units)).transpose();
      normal += slope * slope.transpose();
      gradient += slope * error;
      square += error * error;
      count += 1.0;
    }
  }
  if (count == 0.0) return matte.camera;
  const double damping = kCorrelated * square / count / (kKnownPx * kKnownPx);
  normal.diagonal().array() += std::max(damping, 1e-9);
  return turned(matte.camera, units.cwiseProduct(-normal.ldlt().solve(gradient)));
}

// The photos outside a fold, as opacity takes them.
VolumeSnapshot volume_without(int fold, const std::vector<SmallMatte>& pictures,
                              Progress& progress) {
  Photos photos;
  Mattes mattes;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (int(i % kFolds) == fold) continue;
    Photo photo;
    photo.name = pictures[i].name;
    photo.camera = photo.original_camera = pictures[i].camera;
    photos.push_back(std::move(photo));
    mattes.push_back({pictures[i].name, pictures[i].premultiplied});
  }
  OpacityOptions options;
  options.cell_px = kCellPx;
  return snapshot_of(estimate_opacity(photos, mattes, options, progress));
}

// Mean |alpha - matte| over the blocks that took no part, each photo in a volume of the others.
double held_out_error(const std::vector<SmallMatte>& pictures, Progress& progress) {
  double sum = 0.0, count = 0.0;
  for (int fold = 0; fold < kFolds; ++fold) {
    const ProgressPart part(progress, double(fold) / kFolds, double(fold + 1) / kFolds);
    const VolumeSnapshot volume = volume_without(fold, pictures, progress);
    for (std::size_t i = std::size_t(fold); i < pictures.size(); i += kFolds) {
      progress.check();
      const Image<float> alpha = alpha_of(volume, pictures[i].camera);
      for (int y = 0; y < alpha.height(); ++y) {
        for (int x = 0; x < alpha.width(); ++x) {
          const float truth = pictures[i].premultiplied(x, y).a;
          if (takes_part(x, y) || (alpha(x, y) <= 0.0f && truth <= 0.0f)) continue;
          sum += std::abs(double(alpha(x, y)) - double(truth));
          count += 1.0;
        }
      }
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

// Every photo's pose one step on.
void move_all(std::vector<SmallMatte>& pictures, Progress& progress) {
  std::vector<SmallMatte> moved = pictures;
  for (int fold = 0; fold < kFolds; ++fold) {
    const ProgressPart part(progress, double(fold) / kFolds, double(fold + 1) / kFolds);
    const VolumeSnapshot volume = volume_without(fold, pictures, progress);
    const Crown crown = crown_of(volume.bounds);
    for (std::size_t i = std::size_t(fold); i < pictures.size(); i += kFolds) {
      progress.check();
      moved[i].camera = stepped(volume, pictures[i], crown);
      progress.check();
      moved[i].camera = stepped(volume, moved[i], crown);
    }
  }
  pictures = std::move(moved);
}

std::vector<Camera> cameras_of(const std::vector<SmallMatte>& pictures) {
  std::vector<Camera> cameras;
  for (const SmallMatte& picture : pictures) cameras.push_back(picture.camera);
  return cameras;
}

// Takes back what moves the crown alike in all photos.
void hold_still(std::vector<SmallMatte>& pictures, const std::vector<Camera>& original,
                const Crown& crown) {
  const Similarity back = alignment(original, cameras_of(pictures), crown.corners);
  for (SmallMatte& picture : pictures) {
    RigidTransform& pose = picture.camera.camera_from_world;
    pose = moved(pose, back);
  }
}

void take_poses(std::vector<SmallMatte>& pictures, const std::vector<SmallMatte>& from) {
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    pictures[i].camera.camera_from_world = from[i].camera.camera_from_world;
  }
}

double moved_px_of(const Photo& photo, const RigidTransform& refined, const Crown& crown) {
  Camera after = photo.camera;
  after.camera_from_world = refined;
  double square = 0.0, count = 0.0;
  for (const glm::dvec3& corner : crown.corners) {
    const auto from = project(photo.camera, corner), to = project(after, corner);
    if (!from || !to) continue;
    square += glm::dot(*to - *from, *to - *from);
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(square / count) : 0.0;
}

// A turn, a shift and a growth about the crown's centre, in units of its size.
using Small = Eigen::Matrix<double, 7, 1>;
constexpr double kNudge = 1e-5;
constexpr int kAlignments = 4;  // steps; it starts within some pixels of the end

Similarity small_move(const Small& step, const glm::dvec3& centre, double size_m) {
  Similarity move;
  move.scale = std::exp(step[6]);
  move.rotation = rotation_from_rodrigues({step[0], step[1], step[2]});
  move.translation = centre + size_m * glm::dvec3(step[3], step[4], step[5]) -
                     move.scale * (move.rotation * centre);
  return move;
}

Similarity operator*(const Similarity& a, const Similarity& b) {
  return {a.scale * b.scale, a.rotation * b.rotation, a * b.translation};
}

// Where the points are seen by the cameras in the moved world, less where they are wanted; pixels.
Eigen::VectorXd displacements(std::span<const Camera> wanted, std::span<const Camera> given,
                              std::span<const glm::dvec3> points, const Similarity& move) {
  Eigen::VectorXd error = Eigen::VectorXd::Zero(Eigen::Index(2 * wanted.size() * points.size()));
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    Camera camera = given[i];
    camera.camera_from_world = moved(camera.camera_from_world, move);
    for (const glm::dvec3& point : points) {
      const auto is = project(camera, point), should = project(wanted[i], point);
      if (is && should) error.segment<2>(at) << is->x - should->x, is->y - should->y;
      at += 2;
    }
  }
  return error;
}

}  // namespace

Similarity alignment(std::span<const Camera> wanted, std::span<const Camera> given,
                     std::span<const glm::dvec3> points) {
  assert(wanted.size() == given.size());
  glm::dvec3 centre(0.0);
  for (const glm::dvec3& point : points) centre += point / double(points.size());
  double size_m = 1e-12;
  for (const glm::dvec3& point : points) size_m = std::max(size_m, glm::distance(point, centre));
  Similarity result;
  for (int round = 0; round < kAlignments; ++round) {
    const Eigen::VectorXd error = displacements(wanted, given, points, result);
    Eigen::MatrixXd slopes(error.size(), 7);
    for (int k = 0; k < 7; ++k) {
      const Similarity nudge = small_move(kNudge * Small::Unit(k), centre, size_m);
      slopes.col(k) = (displacements(wanted, given, points, nudge * result) - error) / kNudge;
    }
    const Small step = -(slopes.transpose() * slopes).ldlt().solve(slopes.transpose() * error);
    result = small_move(step, centre, size_m) * result;
  }
  return result;
}

PoseRefinement refine_poses(const Photos& photos, const Mattes& mattes,
                            const PoseRefinementOptions& options, Progress& progress) {
  if (photos.size() < kFewestPhotos || mattes.size() != photos.size()) {
    throw Error("refining the poses by the mattes needs at least 6 photos with mattes, " +
                std::to_string(mattes.size()) +
                " given: add photos, or leave calibrate.refine off");
  }
  PoseRefinement result;
  for (const Photo& photo : photos) {
    result.camera_from_world.push_back(photo.camera.camera_from_world);
  }
  std::vector<SmallMatte> pictures = small_mattes(photos, mattes, options.longest_px);
  std::optional<ProgressPart> part(std::in_place, progress, 0.0, 0.15);
  const Crown crown = crown_of(volume_without(0, pictures, progress).bounds);
  result.error_before = held_out_error(pictures, progress);
  std::vector<SmallMatte> coarse = small_mattes(photos, mattes, options.longest_px / 2);
  for (int round = 0; round < 2 * options.rounds; ++round) {
    part.emplace(progress, 0.15 + 0.7 * round / (2 * options.rounds),
                 0.15 + 0.7 * (round + 1) / (2 * options.rounds));
    if (round == options.rounds) take_poses(pictures, coarse);
    std::vector<SmallMatte>& at = round < options.rounds ? coarse : pictures;
    const std::vector<Camera> original = cameras_of(at);
    move_all(at, progress);
    hold_still(at, original, crown);
  }
  part.emplace(progress, 0.85, 1.0);
  result.error_after = held_out_error(pictures, progress);
  result.accepted = result.error_after < (1.0 - options.least_gain) * result.error_before;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const RigidTransform& refined = pictures[i].camera.camera_from_world;
    if (result.accepted) result.camera_from_world[i] = refined;
    result.moved_px.push_back(result.accepted ? moved_px_of(photos[i], refined, crown) : 0.0);
  }
  return result;
}

}  // namespace bosk
