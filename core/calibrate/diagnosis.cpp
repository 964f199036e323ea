#include "core/calibrate/diagnosis.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/calibrate/diagnosis_lens.h"
#include "core/calibrate/diagnosis_verdict.h"
#include "core/calibrate/photo_quirks.h"

namespace bosk {
namespace {

glm::dmat3 glm_matrix(const Eigen::Matrix3d& m) {
  glm::dmat3 result(0.0);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result[column][row] = m(row, column);
  return result;
}

PhotoFinding refused_finding(const PhotoSightings& photo, const std::string& reason) {
  PhotoFinding finding;
  finding.photo = photo.photo;
  finding.fate = PhotoFate::refused;
  finding.reason = reason;
  finding.sightings = int(photo.sightings.size());
  return finding;
}

void add_sighting(PhotoFinding& finding, double& squares, const BundleSighting& sighting,
                  const glm::dvec2& error_px) {
  ++finding.sightings;
  if (sighting.used)
    squares += glm::dot(error_px, error_px);
  else
    ++finding.outliers;
}

double root_mean(double squares, int count) {
  return count > 0 ? std::sqrt(squares / (2.0 * count)) : 0.0;
}

// Findings of the cameras, but for their fates.
std::vector<PhotoFinding> camera_findings(const Solution& solution, const SolveQuestion& question,
                                          const std::vector<glm::dvec2>& errors) {
  std::vector<PhotoFinding> findings(solution.input.cameras());
  std::vector<double> squares(findings.size(), 0.0);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const BundleSighting& sighting = solution.input.problem.sightings[i];
    const auto camera = std::size_t(sighting.camera);
    add_sighting(findings[camera], squares[camera], sighting, errors[i]);
  }
  for (std::size_t i = 0; i < findings.size(); ++i) {
    findings[i].photo = question.photos[solution.input.photo_of_camera[i]].photo;
    findings[i].rms_px = root_mean(squares[i], findings[i].sightings - findings[i].outliers);
  }
  return findings;
}

CrownView crown_view(const Solution& solution) {
  const Lens& lens = solution.input.lens;
  return {crown_point(solution.state), 0.1 * std::min(lens.width_px, lens.height_px)};
}

void add_uncertainties(const Solution& solution, const BundleCovariance& covariance,
                       std::vector<PhotoFinding>& findings) {
  const BundleProblem& problem = solution.input.problem;
  const CrownView view = crown_view(solution);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    findings[i].crown_sigma_px = crown_sigma_px(covariance, problem, solution.state, int(i), view);
    findings[i].centre_covariance_m2 = glm_matrix(covariance.centre(int(i)));
  }
}

std::vector<SolvedPoint> solved_points(const Solution& solution, const BundleCovariance& covariance,
                                       const std::vector<glm::dvec2>& errors,
                                       const Progress& progress) {
  std::vector<SolvedPoint> points(solution.input.points.size());
  std::vector<double> squares(points.size(), 0.0);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const BundleSighting& sighting = solution.input.problem.sightings[i];
    if (!sighting.used) continue;
    squares[std::size_t(sighting.point)] += glm::dot(errors[i], errors[i]);
    ++points[std::size_t(sighting.point)].photos;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 64 == 0) progress.check();
    points[i].name = solution.input.points[i];
    points[i].in_world = solution.state.points[i];
    points[i].rms_px = root_mean(squares[i], points[i].photos);
    points[i].covariance_m2 = glm_matrix(covariance.points(int(i), int(i)));
  }
  std::erase_if(points, [](const SolvedPoint& point) { return point.photos < 2; });
  return points;
}

std::vector<SightingResidual> residuals_of(const Solution& solution, const SolveQuestion& question,
                                           const std::vector<glm::dvec2>& errors) {
  std::vector<SightingResidual> residuals;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const BundleSighting& sighting = solution.input.problem.sightings[i];
    const auto photo = solution.input.photo_of_camera[std::size_t(sighting.camera)];
    residuals.push_back({question.photos[photo].photo,
                         solution.input.points[std::size_t(sighting.point)], sighting.pixel,
                         errors[i], !sighting.used});
  }
  return residuals;
}

double rms_of(const std::vector<SightingResidual>& residuals) {
  double squares = 0.0;
  int count = 0;
  for (const SightingResidual& residual : residuals) {
    if (residual.outlier) continue;
    squares += glm::dot(residual.error_px, residual.error_px);
    ++count;
  }
  return root_mean(squares, count);
}

// In the order of the photos as given.
std::vector<PhotoFinding> all_findings(const SolveInput& input, const SolveQuestion& question,
                                       const std::vector<PhotoFinding>& of_cameras) {
  std::vector<PhotoFinding> all;
  for (std::size_t i = 0; i < question.photos.size(); ++i)
    all.push_back(refused_finding(question.photos[i], input.refused[i]));
  for (std::size_t i = 0; i < of_cameras.size(); ++i) all[input.photo_of_camera[i]] = of_cameras[i];
  return all;
}

Lens solved_lens(const Solution& solution, const LensKnowledge& knowledge) {
  if (knowledge.known) return knowledge.lens;
  return lens_of(solution.input.problem.family, solution.state.intrinsics, knowledge.lens.width_px,
                 knowledge.lens.height_px);
}

void add_cameras(const Solution& solution, const std::vector<PhotoFinding>& findings,
                 Calibration& calibration) {
  for (std::size_t i = 0; i < findings.size(); ++i)
    if (findings[i].fate != PhotoFate::refused)
      calibration.cameras.push_back(
          {findings[i].photo, calibration.lens, solution.state.camera_from_world[i]});
}

}  // namespace

std::optional<std::string> too_little(const SolveInput& input, const SolveQuestion& question) {
  if (question.photos.size() < 3)
    return "photos to place: " + std::to_string(question.photos.size()) +
           ", and places of cameras need three at least: take 12 or more round the tree";
  if (points_on_a_line(question.photos, input.refused))
    return "all points lie on one straight line, which leaves the cameras free to turn about it: "
           "put three or more of them well off that line";
  if (input.cameras() < 3 || input.points.size() < 4)
    return "only " + std::to_string(input.cameras()) + " photos see enough of the " +
           std::to_string(input.points.size()) +
           " points that two photos or more see: mark the same points in more photos; eight or "
           "more, round the trunk and at several heights, serve well";
  return std::nullopt;
}

Calibration refused_calibration(const SolveInput& input, const SolveQuestion& question,
                                std::vector<std::string> sentences) {
  Calibration calibration;
  calibration.sentences = std::move(sentences);
  calibration.lens = question.lens.lens;
  calibration.lens_was_known = question.lens.known;
  for (std::size_t i = 0; i < question.photos.size(); ++i) {
    const std::string& reason = input.refused[i];
    calibration.photos.push_back(
        refused_finding(question.photos[i], reason.empty() ? "the solve was refused" : reason));
    if (!reason.empty())
      calibration.sentences.push_back("photo " + question.photos[i].photo + " " + reason);
  }
  return calibration;
}

Calibration report(const Solution& solution, const SolveQuestion& question,
                   const Progress& progress) {
  const BundleProblem& problem = solution.input.problem;
  const double noise = noise_factor(problem, solution.state);
  const auto errors = sighting_errors(problem, solution.state);
  Calibration calibration;
  calibration.lens = solved_lens(solution, question.lens);
  calibration.lens_was_known = question.lens.known;
  std::vector<PhotoFinding> findings = camera_findings(solution, question, errors);
  const BundleCovariance covariance(problem, solution.state, noise, progress);
  add_uncertainties(solution, covariance, findings);
  judge_photos(solution, question, findings);
  calibration.points = solved_points(solution, covariance, errors, progress);
  calibration.residuals = residuals_of(solution, question, errors);
  calibration.rms_px = rms_of(calibration.residuals);
  calibration.photos = all_findings(solution.input, question, findings);
  calibration.scale_known = solution.determined.scale;
  calibration.up_known = solution.determined.up;
  if (calibration.scale_known) calibration.scale_sigma = covariance.scale_sigma();
  judge(solution, question, noise, lens_doubt(solution, question, covariance, progress),
        calibration);
  if (calibration.verdict != Verdict::refused) add_cameras(solution, findings, calibration);
  return calibration;
}

}  // namespace bosk
