#include "core/project/calibration_store.h"

#include "core/base/error.h"
#include "core/project/binary_items.h"

namespace bosk {
namespace {

constexpr int kMaxMapEdge = 1 << 16;

void write_sentences(BinaryWriter& writer, const std::vector<std::string>& sentences) {
  write_list(writer, sentences, write_text);
}
std::vector<std::string> read_sentences(BinaryReader& reader) {
  return read_list(reader, read_text);
}

void write_photo(BinaryWriter& writer, const PhotoFinding& photo) {
  writer.text(photo.photo);
  writer.value(photo.fate);
  writer.text(photo.reason);
  writer.value(photo.sightings);
  writer.value(photo.outliers);
  writer.value(photo.rms_px);
  writer.value(photo.crown_sigma_px);
  writer.value(photo.centre_covariance_m2);
}

PhotoFinding read_photo(BinaryReader& reader) {
  PhotoFinding photo;
  photo.photo = reader.text();
  photo.fate = read_kind<PhotoFate>(reader, 3);
  photo.reason = reader.text();
  photo.sightings = reader.value<int>();
  photo.outliers = reader.value<int>();
  photo.rms_px = reader.value<double>();
  photo.crown_sigma_px = reader.value<double>();
  photo.centre_covariance_m2 = reader.value<glm::dmat3>();
  return photo;
}

void write_point(BinaryWriter& writer, const SolvedPoint& point) {
  writer.text(point.name);
  writer.value(point.in_world);
  writer.value(point.covariance_m2);
  writer.value(point.photos);
  writer.value(point.rms_px);
}

SolvedPoint read_point(BinaryReader& reader) {
  SolvedPoint point;
  point.name = reader.text();
  point.in_world = reader.value<glm::dvec3>();
  point.covariance_m2 = reader.value<glm::dmat3>();
  point.photos = reader.value<int>();
  point.rms_px = reader.value<double>();
  return point;
}

void write_residual(BinaryWriter& writer, const SightingResidual& residual) {
  writer.text(residual.photo);
  writer.text(residual.point);
  writer.value(residual.pixel);
  writer.value(residual.error_px);
  writer.value(residual.outlier);
}

SightingResidual read_residual(BinaryReader& reader) {
  SightingResidual residual;
  residual.photo = reader.text();
  residual.point = reader.text();
  residual.pixel = reader.value<glm::dvec2>();
  residual.error_px = reader.value<glm::dvec2>();
  residual.outlier = reader.value<bool>();
  return residual;
}

void write_map(BinaryWriter& writer, const Image<float>& map) {
  writer.value(glm::ivec2(map.width(), map.height()));
  writer.array(map.pixels());
}

Image<float> read_map(BinaryReader& reader) {
  const auto size = reader.value<glm::ivec2>();
  const auto values = reader.array<float>();
  const bool sound = size.x >= 0 && size.y >= 0 && size.x <= kMaxMapEdge && size.y <= kMaxMapEdge &&
                     std::size_t(size.x) * std::size_t(size.y) == values.size();
  if (!sound) throw Error("stored map is damaged");
  Image<float> map(size.x, size.y);
  map.pixels() = values;
  return map;
}

void write_profile(BinaryWriter& writer, const LensProfile& profile) {
  write_lens_identity(writer, profile.taken_with);
  writer.value(profile.lens);
  writer.value(profile.rms_px);
  writer.value(profile.boards);
  writer.value(profile.corners);
  write_map(writer, profile.coverage);
  write_map(writer, profile.uncertainty_px);
}

LensProfile read_profile(BinaryReader& reader) {
  LensProfile profile;
  profile.taken_with = read_lens_identity(reader);
  profile.lens = reader.value<Lens>();
  profile.rms_px = reader.value<double>();
  profile.boards = reader.value<int>();
  profile.corners = reader.value<int>();
  profile.coverage = read_map(reader);
  profile.uncertainty_px = read_map(reader);
  return profile;
}

void write_board(BinaryWriter& writer, const BoardFinding& board) {
  writer.text(board.photo);
  writer.value(board.used);
  writer.text(board.reason);
  writer.value(board.corners);
  writer.value(board.outliers);
  writer.value(board.rms_px);
  writer.value(board.tilt);
  writer.value(board.camera_from_board);
}

BoardFinding read_board(BinaryReader& reader) {
  BoardFinding board;
  board.photo = reader.text();
  board.used = reader.value<bool>();
  board.reason = reader.text();
  board.corners = reader.value<int>();
  board.outliers = reader.value<int>();
  board.rms_px = reader.value<double>();
  board.tilt = reader.value<double>();
  board.camera_from_board = reader.value<RigidTransform>();
  return board;
}

void write_trial(BinaryWriter& writer, const LensTrial& trial) {
  writer.text(trial.model);
  writer.value(trial.rms_px);
  writer.value(trial.held_out_rms_px);
  writer.value(trial.chosen);
}

LensTrial read_trial(BinaryReader& reader) {
  LensTrial trial;
  trial.model = reader.text();
  trial.rms_px = reader.value<double>();
  trial.held_out_rms_px = reader.value<double>();
  trial.chosen = reader.value<bool>();
  return trial;
}

void write_sighting(BinaryWriter& writer, const Sighting& sighting) {
  writer.text(sighting.point);
  writer.value(sighting.pixel);
  writer.value(sighting.sigma_px);
  writer.value(sighting.by);
}

Sighting read_sighting(BinaryReader& reader) {
  Sighting sighting;
  sighting.point = reader.text();
  sighting.pixel = reader.value<glm::dvec2>();
  sighting.sigma_px = reader.value<double>();
  sighting.by = read_kind<SightedBy>(reader, 5);
  return sighting;
}

void write_sightings(BinaryWriter& writer, const PhotoSightings& photo) {
  writer.text(photo.photo);
  writer.value(glm::ivec2(photo.width_px, photo.height_px));
  write_optional(writer, photo.exif_focal_px);
  write_optional(writer, photo.up_in_camera);
  write_list(writer, photo.sightings, write_sighting);
}

PhotoSightings read_sightings(BinaryReader& reader) {
  PhotoSightings photo;
  photo.photo = reader.text();
  const auto size_px = reader.value<glm::ivec2>();
  photo.width_px = size_px.x;
  photo.height_px = size_px.y;
  photo.exif_focal_px = read_optional<double>(reader);
  photo.up_in_camera = read_optional<glm::dvec3>(reader);
  photo.sightings = read_list(reader, read_sighting);
  return photo;
}

}  // namespace

void write(BinaryWriter& writer, const Calibration& calibration) {
  writer.value(calibration.verdict);
  write_sentences(writer, calibration.sentences);
  writer.value(calibration.lens);
  writer.value(calibration.lens_was_known);
  write_list(writer, calibration.cameras, write_camera);
  write_list(writer, calibration.photos, write_photo);
  write_list(writer, calibration.points, write_point);
  write_list(writer, calibration.residuals, write_residual);
  writer.value(calibration.scale_known);
  writer.value(calibration.up_known);
  writer.value(calibration.scale_sigma);
  writer.value(calibration.rms_px);
}

Calibration read_calibration(BinaryReader& reader) {
  Calibration calibration;
  calibration.verdict = read_kind<Verdict>(reader, 3);
  calibration.sentences = read_sentences(reader);
  calibration.lens = reader.value<Lens>();
  calibration.lens_was_known = reader.value<bool>();
  calibration.cameras = read_list(reader, read_camera);
  calibration.photos = read_list(reader, read_photo);
  calibration.points = read_list(reader, read_point);
  calibration.residuals = read_list(reader, read_residual);
  calibration.scale_known = reader.value<bool>();
  calibration.up_known = reader.value<bool>();
  calibration.scale_sigma = reader.value<double>();
  calibration.rms_px = reader.value<double>();
  return calibration;
}

void write(BinaryWriter& writer, const LensCalibration& calibration) {
  writer.value(calibration.verdict);
  write_sentences(writer, calibration.sentences);
  write_profile(writer, calibration.profile);
  write_list(writer, calibration.boards, write_board);
  writer.array(calibration.residuals);
  write_list(writer, calibration.trials, write_trial);
  writer.value(calibration.focal_sigma);
  writer.value(calibration.board_warp_m);
  writer.value(calibration.corner_sigma_px);
}

LensCalibration read_lens_calibration(BinaryReader& reader) {
  LensCalibration calibration;
  calibration.verdict = read_kind<Verdict>(reader, 3);
  calibration.sentences = read_sentences(reader);
  calibration.profile = read_profile(reader);
  calibration.boards = read_list(reader, read_board);
  calibration.residuals = reader.array<CornerResidual>();
  calibration.trials = read_list(reader, read_trial);
  calibration.focal_sigma = reader.value<double>();
  calibration.board_warp_m = reader.value<glm::dvec2>();
  calibration.corner_sigma_px = reader.value<double>();
  return calibration;
}

void write(BinaryWriter& writer, const FeatureSightings& features) {
  write_list(writer, features.photos, write_sightings);
  write_list(writer, features.camera_from_world, write_optional<RigidTransform>);
  writer.value(features.lens);
  write_sentences(writer, features.sentences);
}

FeatureSightings read_feature_sightings(BinaryReader& reader) {
  FeatureSightings features;
  features.photos = read_list(reader, read_sightings);
  features.camera_from_world = read_list(reader, read_optional<RigidTransform>);
  features.lens = reader.value<Lens>();
  features.sentences = read_sentences(reader);
  return features;
}

}  // namespace bosk
