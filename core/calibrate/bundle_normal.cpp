#include "core/calibrate/bundle_normal.h"

#include <Eigen/LU>
#include <algorithm>

#include "core/calibrate/bundle_loss.h"
#include "core/calibrate/bundle_project.h"
#include "core/calibrate/bundle_rows.h"
#include "core/geometry/rotation.h"

namespace bosk {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d eigen(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
glm::dvec3 vec(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Matrix3d eigen(const glm::dmat3& m) {
  Matrix3d result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result(row, column) = m[column][row];
  return result;
}

void add_couple(EliminatedPoint& point, int offset, const Coupling& value) {
  for (auto couple = point.couples.rbegin(); couple != point.couples.rend(); ++couple) {
    if (couple->offset != offset) continue;
    couple->value += value;
    return;
  }
  point.couples.push_back({offset, value});
}

void add_pair(NormalEquations& equations, const Row::Part& a, const Row::Part& b, double weight) {
  if (a.point >= 0) {
    if (b.point < 0)
      add_couple(equations.points[std::size_t(a.point)], b.offset,
                 weight * b.by.transpose() * a.by);
  } else if (b.point < 0 && a.offset >= b.offset) {
    equations.dense.block(a.offset, b.offset, a.by.cols(), b.by.cols()).noalias() +=
        weight * a.by.transpose() * b.by;
  }
}

void add_row(NormalEquations& equations, const Row& row, double loss_scale) {
  const RobustLoss loss =
      robust_loss(row.residual.squaredNorm(), row.doubted ? loss_scale : kLeastSquares);
  equations.cost += loss.cost;
  for (const Row::Part& part : row.parts) {
    if (part.by.cols() == 0) continue;  // a lens of which nothing is free
    if (part.point >= 0) {
      EliminatedPoint& point = equations.points[std::size_t(part.point)];
      point.own += loss.weight * part.by.transpose() * part.by;
      point.gradient += loss.weight * part.by.transpose() * row.residual;
    } else {
      equations.gradient.segment(part.offset, part.by.cols()) +=
          loss.weight * part.by.transpose() * row.residual;
    }
    for (const Row::Part& other : row.parts)
      if (other.by.cols() > 0) add_pair(equations, part, other, loss.weight);
  }
}

Jacobian by_pixel(const std::array<mrcal_point3_t, 2>& derivative, double sigma) {
  Jacobian by(2, 3);
  for (int row = 0; row < 2; ++row)
    for (int axis = 0; axis < 3; ++axis)
      by(row, axis) = derivative[std::size_t(row)].xyz[axis] / sigma;
  return by;
}

// Fills `row`, whose three parts are the lens, the camera and the point.
void fill_row(Row& row, const BundleSighting& sighting, const ProjectedSightings& projected,
              std::size_t i, const BundleState& state, const BundleLayout& layout) {
  const mrcal_point2_t& pixel = projected.pixel[i];
  row.residual[0] = (pixel.x - sighting.pixel.x) / sighting.sigma_px;
  row.residual[1] = (pixel.y - sighting.pixel.y) / sighting.sigma_px;
  const Jacobian by_camera = by_pixel(projected.by_point[i], sighting.sigma_px);
  const std::size_t stride = state.intrinsics.size();
  for (int axis = 0; axis < 2; ++axis)
    for (int k = 0; k < int(layout.lens.size()); ++k)
      row.parts[0].by(axis, k) = projected.by_lens[(2 * i + std::size_t(axis)) * stride +
                                                   std::size_t(layout.lens[std::size_t(k)])] /
                                 sighting.sigma_px;
  row.parts[1].offset = layout.camera(sighting.camera);
  row.parts[1].by.leftCols(3) = -by_camera * cross_matrix(eigen(projected.in_camera[i]));
  row.parts[1].by.rightCols(3) = by_camera;
  const int kept = layout.kept_offset[std::size_t(sighting.point)];
  row.parts[2].offset = kept;
  row.parts[2].point = kept >= 0 ? -1 : sighting.point;
  row.parts[2].by =
      by_camera * eigen(state.camera_from_world[std::size_t(sighting.camera)].rotation);
}

Row sighting_row(const BundleLayout& layout) {
  Row row;
  row.residual.resize(2);
  row.parts.resize(3);
  row.parts[0] = {0, -1, Jacobian::Zero(2, int(layout.lens.size()))};
  row.parts[1].by.resize(2, 6);
  return row;
}

void add_sightings(NormalEquations& equations, const BundleProblem& problem,
                   const BundleState& state, double loss_scale, const Progress& progress) {
  Row row = sighting_row(equations.layout);
  for (const auto group : by_camera(problem)) {
    progress.check();
    const ProjectedSightings projected = project_sightings(problem, state, group, true);
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (!group[i].used) continue;
      if (!projected.in_front[i]) {
        equations.cost += robust_loss(kBehind, loss_scale).cost;
        continue;
      }
      fill_row(row, group[i], projected, i, state, equations.layout);
      add_row(equations, row, loss_scale);
    }
  }
}

void add_pins(NormalEquations& equations, const BundleProblem& problem, const BundleState& state) {
  const glm::dvec3 centre = mean_centre(state);
  for (const GaugeMove& move : problem.pinned) {
    const Eigen::VectorXd direction =
        gauge_direction(equations.layout, state, move, centre).normalized();
    equations.dense.selfadjointView<Eigen::Lower>().rankUpdate(direction, kPinned);
  }
}

void eliminate(ReducedSystem& system, EliminatedPoint point, const Matrix3d& own_inverse) {
  std::sort(point.couples.begin(), point.couples.end(),
            [](const auto& a, const auto& b) { return a.offset < b.offset; });
  for (std::size_t a = 0; a < point.couples.size(); ++a) {
    const auto& [row, by_row] = point.couples[a];
    const Coupling explained = by_row * own_inverse;
    system.gradient.segment(row, by_row.rows()) -= explained * point.gradient;
    for (std::size_t b = 0; b <= a; ++b) {
      const auto& [column, by_column] = point.couples[b];
      system.matrix.block(row, column, by_row.rows(), by_column.rows()).noalias() -=
          explained * by_column.transpose();
    }
  }
}

RigidTransform changed_pose(const RigidTransform& pose, const Eigen::VectorXd& change) {
  const glm::dmat3 turn = rotation_from_rodrigues({change[0], change[1], change[2]});
  return {nearest_rotation(turn * pose.rotation),
          turn * pose.translation + glm::dvec3(change[3], change[4], change[5])};
}

}  // namespace

BundleLayout layout_of(const BundleProblem& problem, const BundleState& state) {
  BundleLayout layout;
  for (int i = 0; i < int(state.intrinsics.size()); ++i)
    if (problem.lens_free[std::size_t(i)]) layout.lens.push_back(i);
  layout.camera_offset = int(layout.lens.size());
  layout.body_offset = layout.camera(int(state.camera_from_world.size()));
  layout.kept_begin = layout.dense_size = layout.body(int(state.world_from_body.size()));
  layout.kept_offset.assign(state.points.size(), -1);
  const auto keep = [&layout](int point) {
    int& offset = layout.kept_offset[std::size_t(point)];
    if (offset >= 0) return;
    offset = layout.dense_size;
    layout.dense_size += 3;
  };
  for (const LengthRow& row : problem.lengths) keep(row.from), keep(row.to);
  for (const PlumbRow& row : problem.plumbs) keep(row.top), keep(row.foot);
  return layout;
}

NormalEquations normal_equations(const BundleProblem& problem, const BundleState& state,
                                 double loss_scale, const Progress& progress) {
  NormalEquations equations;
  equations.layout = layout_of(problem, state);
  const int size = equations.layout.dense_size;
  equations.dense = Eigen::MatrixXd::Zero(size, size);
  equations.gradient = Eigen::VectorXd::Zero(size);
  equations.points.resize(state.points.size());
  add_sightings(equations, problem, state, loss_scale, progress);
  for_each_row(problem, state, equations.layout,
               [&](const Row& row) { add_row(equations, row, loss_scale); });
  add_pins(equations, problem, state);
  return equations;
}

ReducedSystem reduced(const NormalEquations& equations, double damping, const Progress& progress) {
  constexpr double kNothingKnown = 1e-9;  // keeps what no residual sees from dividing by 0
  ReducedSystem system{equations.dense, equations.gradient, {}};
  system.matrix.diagonal().array() *= 1.0 + damping;
  system.matrix.diagonal().array() += kNothingKnown;
  system.own_inverse.assign(equations.points.size(), Matrix3d::Zero());
  for (std::size_t i = 0; i < equations.points.size(); ++i) {
    if (equations.layout.kept_offset[i] >= 0) continue;
    if (i % 64 == 0) progress.check();
    const EliminatedPoint& point = equations.points[i];
    Matrix3d own = point.own;
    own.diagonal() *= 1.0 + damping;
    own.diagonal().array() += kNothingKnown;
    system.own_inverse[i] = own.inverse();
    eliminate(system, point, system.own_inverse[i]);
  }
  return system;
}

Eigen::MatrixXd pixel_by_lens_and_camera(const BundleProblem& problem, const BundleState& state,
                                         const ProjectedSightings& projected, std::size_t i) {
  BundleLayout layout = layout_of(problem, state);
  Row row = sighting_row(layout);
  fill_row(row, {0, 0, glm::dvec2(0.0), 1.0, true}, projected, i, state, layout);
  Eigen::MatrixXd both(2, int(layout.lens.size()) + 6);
  both << row.parts[0].by, row.parts[1].by;
  return both;
}

glm::dvec3 mean_centre(const BundleState& state) {
  glm::dvec3 sum(0.0);
  for (const RigidTransform& camera : state.camera_from_world) sum += inverse(camera).translation;
  return sum / double(state.camera_from_world.size());
}

// A camera R, t turns by -R rotation, and moves by R (rotation x centre) + R rotation x t -
// R translation + growth (t + R centre), so that every point keeps its pixel.
Eigen::VectorXd gauge_direction(const BundleLayout& layout, const BundleState& state,
                                const GaugeMove& move, const glm::dvec3& centre) {
  const glm::dvec3 shift(move[0], move[1], move[2]), turn(move[3], move[4], move[5]);
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(layout.dense_size);
  for (std::size_t i = 0; i < state.camera_from_world.size(); ++i) {
    const auto& [rotation, translation] = state.camera_from_world[i];
    const glm::dvec3 turn_in_camera = rotation * turn;
    direction.segment<3>(layout.camera(int(i))) = -eigen(turn_in_camera);
    direction.segment<3>(layout.camera(int(i)) + 3) = eigen(
        rotation * (glm::cross(turn, centre) - shift) + glm::cross(turn_in_camera, translation) +
        move[6] * (translation + rotation * centre));
  }
  return direction;
}

BundleState changed(const BundleState& state, const BundleLayout& layout,
                    const Eigen::VectorXd& dense, std::span<const Eigen::Vector3d> points) {
  BundleState result = state;
  for (int i = 0; i < int(layout.lens.size()); ++i)
    result.intrinsics[std::size_t(layout.lens[std::size_t(i)])] += dense[i];
  for (std::size_t i = 0; i < result.camera_from_world.size(); ++i)
    result.camera_from_world[i] =
        changed_pose(result.camera_from_world[i], dense.segment(layout.camera(int(i)), 6));
  for (std::size_t i = 0; i < result.world_from_body.size(); ++i)
    result.world_from_body[i] =
        changed_pose(result.world_from_body[i], dense.segment(layout.body(int(i)), 6));
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const int kept = layout.kept_offset[i];
    result.points[i] += vec(kept >= 0 ? Vector3d(dense.segment<3>(kept)) : points[i]);
  }
  return result;
}

}  // namespace bosk
