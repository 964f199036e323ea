#include "core/calibrate/bundle_rows.h"

#include <algorithm>
#include <cmath>

#include "core/calibrate/bundle_loss.h"

namespace bosk {
namespace {

using Eigen::Matrix3d;
using Eigen::RowVector3d;
using Eigen::Vector3d;

Vector3d eigen(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Row::Part point_part(const BundleLayout& layout, int point, const Jacobian& by) {
  const int kept = layout.kept_offset[std::size_t(point)];
  return kept >= 0 ? Row::Part{kept, -1, by} : Row::Part{-1, point, by};
}

Row single(double residual) {
  Row row;
  row.residual = Eigen::VectorXd::Constant(1, residual);
  return row;
}

Row row_of(const LengthRow& length, const BundleState& state, const BundleLayout& layout) {
  const Vector3d apart =
      eigen(state.points[std::size_t(length.to)]) - eigen(state.points[std::size_t(length.from)]);
  const double distance = std::max(apart.norm(), 1e-12);
  Row row = single((distance - length.length) / length.sigma);
  const RowVector3d by = apart.transpose() / (distance * length.sigma);
  row.parts = {point_part(layout, length.from, -by), point_part(layout, length.to, by)};
  return row;
}

Row row_of(const CoordinateRow& coordinate, const BundleState& state, const BundleLayout& layout) {
  const double at = state.points[std::size_t(coordinate.point)][coordinate.axis];
  Row row = single((at - coordinate.value) / coordinate.sigma);
  RowVector3d by = RowVector3d::Zero();
  by[coordinate.axis] = 1.0 / coordinate.sigma;
  row.parts = {point_part(layout, coordinate.point, by)};
  return row;
}

// The lean's change with the stick's length is left out: second order for sticks that stand.
Row row_of(const PlumbRow& plumb, const BundleState& state, const BundleLayout& layout) {
  const Vector3d apart =
      eigen(state.points[std::size_t(plumb.top)]) - eigen(state.points[std::size_t(plumb.foot)]);
  const double scale = 1.0 / (std::max(apart.norm(), 1e-12) * plumb.sigma);
  const double fallen = apart.z() > 0.0 ? 0.0 : 1.0 / plumb.sigma;  // upside down
  Row row;
  row.residual = Vector3d(apart.x() * scale, apart.y() * scale, fallen);
  const Matrix3d by = scale * Vector3d(1.0, 1.0, 0.0).asDiagonal().toDenseMatrix();
  row.parts = {point_part(layout, plumb.top, by), point_part(layout, plumb.foot, -by)};
  return row;
}

Row row_of(const BodyRow& body, const BundleState& state, const BundleLayout& layout) {
  const Vector3d in_world = eigen(state.world_from_body[std::size_t(body.body)] * body.in_body);
  Row row;
  row.doubted = false;
  row.residual = (eigen(state.points[std::size_t(body.point)]) - in_world) / body.sigma;
  Eigen::Matrix<double, 3, 6> by_pose;
  by_pose << cross_matrix(in_world), -Matrix3d::Identity();
  row.parts = {{layout.body(body.body), -1, by_pose / body.sigma},
               point_part(layout, body.point, Matrix3d::Identity() / body.sigma)};
  return row;
}

Row row_of(const UpRow& up, const BundleState& state, const BundleLayout& layout) {
  const Vector3d z =
      eigen(state.camera_from_world[std::size_t(up.camera)].rotation * glm::dvec3(0.0, 0.0, 1.0));
  Row row;
  row.residual = (z - eigen(up.up_in_camera)) / up.sigma;
  Eigen::Matrix<double, 3, 6> by_pose = Eigen::Matrix<double, 3, 6>::Zero();
  by_pose.leftCols<3>() = -cross_matrix(z) / up.sigma;
  row.parts = {{layout.camera(up.camera), -1, by_pose}};
  return row;
}

Row lens_row(const BundleLayout& layout, double residual) {
  Row row = single(residual);
  row.doubted = false;
  row.parts = {{0, -1, Jacobian::Zero(1, int(layout.lens.size()))}};
  return row;
}

void visit_lens(const BundleProblem& problem, const BundleState& state, const BundleLayout& layout,
                const std::function<void(const Row&)>& visit) {
  int fx = -1, fy = -1;
  for (int i = 0; i < int(layout.lens.size()); ++i) {
    const int index = layout.lens[std::size_t(i)];
    if (index == 0) fx = i;
    if (index == 1) fy = i;
    const double sigma = problem.lens.sigma[std::size_t(index)];
    Row row = lens_row(
        layout,
        (state.intrinsics[std::size_t(index)] - problem.lens.mean[std::size_t(index)]) / sigma);
    row.parts[0].by(0, i) = 1.0 / sigma;
    visit(row);
  }
  if (fx < 0 || fy < 0) return;
  const double sigma = problem.lens.aspect_sigma * problem.lens.mean[1];
  const double aspect = problem.lens.mean[0] / problem.lens.mean[1];
  Row row = lens_row(layout, (state.intrinsics[0] - aspect * state.intrinsics[1]) / sigma);
  row.parts[0].by(0, fx) = 1.0 / sigma;
  row.parts[0].by(0, fy) = -aspect / sigma;
  visit(row);
}

}  // namespace

void for_each_row(const BundleProblem& problem, const BundleState& state,
                  const BundleLayout& layout, const std::function<void(const Row&)>& visit) {
  for (const LengthRow& row : problem.lengths)
    if (row.used) visit(row_of(row, state, layout));
  for (const CoordinateRow& row : problem.coordinates)
    if (row.used) visit(row_of(row, state, layout));
  for (const PlumbRow& row : problem.plumbs) visit(row_of(row, state, layout));
  for (const BodyRow& row : problem.bodies) visit(row_of(row, state, layout));
  for (const UpRow& row : problem.ups) visit(row_of(row, state, layout));
  visit_lens(problem, state, layout, visit);
}

double row_cost(const Row& row, double loss_scale) {
  return robust_loss(row.residual.squaredNorm(), row.doubted ? loss_scale : kLeastSquares).cost;
}

}  // namespace bosk
