#include "core/calibrate/ball_circle.h"

#include <algorithm>
#include <cmath>

namespace bosk {
namespace {

using glm::dvec2;
using glm::dvec3;

struct Circle {
  dvec2 centre{0.0};
  double radius = 0.0;
};

std::optional<Circle> circle_through(const dvec2& a, const dvec2& b, const dvec2& c) {
  const dvec2 ab = b - a, ac = c - a;
  const double cross = 2.0 * (ab.x * ac.y - ab.y * ac.x);
  if (std::abs(cross) < 1e-6) return {};
  const double ab2 = glm::dot(ab, ab), ac2 = glm::dot(ac, ac);
  const dvec2 offset = dvec2(ac.y * ab2 - ab.y * ac2, ab.x * ac2 - ac.x * ab2) / cross;
  return Circle{a + offset, glm::length(offset)};
}

// A point inside the circle says nothing, since something may hide the edge there; one outside
// speaks against it.
double support(std::span<const dvec2> edge, const Circle& circle, double tolerance) {
  double sum = 0.0;
  for (const dvec2& point : edge) {
    const double off = (glm::length(point - circle.centre) - circle.radius) / tolerance;
    sum += off > 1.0 ? std::max(-0.7, 1.0 - off) : std::max(0.0, 1.0 - off * off);
  }
  return sum;
}

// Triples a quarter, a third and less of the edge apart, so that a visible arc holds some.
std::optional<Circle> best_circle(std::span<const dvec2> edge, double least, double most,
                                  double tolerance) {
  std::optional<Circle> best;
  double best_support = 0.0;
  const std::size_t count = edge.size();
  for (std::size_t step = std::max<std::size_t>(2, count / 8); step <= count / 3; ++step)
    for (std::size_t i = 0; i < count; ++i) {
      const auto circle =
          circle_through(edge[i], edge[(i + step) % count], edge[(i + 2 * step) % count]);
      if (!circle || circle->radius < least || circle->radius > most) continue;
      const double agree = support(edge, *circle, tolerance);
      if (agree <= best_support) continue;
      best_support = agree;
      best = circle;
    }
  return best;
}

// J^T J of the distances from the circle; their gradient is (-direction, -1).
struct NormalEquations {
  glm::dmat3 matrix{0.0};
  dvec3 right{0.0};
  double squares = 0.0;
  int count = 0;
};

NormalEquations normal_equations(std::span<const dvec2> edge, const Circle& circle,
                                 double tolerance) {
  NormalEquations sums;
  for (const dvec2& point : edge) {
    const dvec2 away = point - circle.centre;
    const double length = glm::length(away);
    const double off = length - circle.radius;
    if (std::abs(off) > tolerance || length < 1e-9) continue;
    const dvec3 row(away / length, 1.0);
    sums.matrix += glm::outerProduct(row, row);
    sums.right += row * off;
    sums.squares += off * off;
    ++sums.count;
  }
  return sums;
}

bool solvable(const NormalEquations& sums) {
  return sums.count >= 5 && glm::determinant(sums.matrix) > 1e-6 * std::pow(sums.count, 3);
}

}  // namespace

std::optional<CircleFit> fit_circle(std::span<const dvec2> edge, double least, double most,
                                    double tolerance) {
  if (edge.size() < 5) return {};
  std::optional<Circle> circle = best_circle(edge, least, most, tolerance);
  if (!circle) return {};
  for (int round = 0; round < 8; ++round) {
    const NormalEquations sums = normal_equations(edge, *circle, tolerance);
    if (!solvable(sums)) return {};
    const dvec3 change = glm::inverse(sums.matrix) * sums.right;
    circle->centre += dvec2(change);
    circle->radius += change.z;
  }
  const NormalEquations sums = normal_equations(edge, *circle, tolerance);
  if (!solvable(sums) || circle->radius < least || circle->radius > most) return {};
  CircleFit fit;
  fit.centre = circle->centre;
  fit.radius = circle->radius;
  fit.rms = std::sqrt(sums.squares / sums.count);
  const glm::dmat3 inverse = glm::inverse(sums.matrix);
  fit.centre_sigma = std::sqrt(0.5 * (inverse[0][0] + inverse[1][1]));
  for (const dvec2& point : edge)
    fit.belongs.push_back(std::abs(glm::length(point - fit.centre) - fit.radius) <= tolerance);
  fit.inliers = sums.count;
  return fit;
}

}  // namespace bosk
