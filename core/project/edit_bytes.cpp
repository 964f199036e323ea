#include "core/project/edit_bytes.h"

#include <cmath>
#include <string>

#include "core/base/binary.h"
#include "core/base/error.h"
#include "core/project/binary_items.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

std::int32_t steps(double px) { return std::int32_t(std::lround(px / kStrokeStepPx)); }
double pixels(std::int32_t steps) { return steps * kStrokeStepPx; }

void write(BinaryWriter& writer, const fs::path& path) { writer.text(path.string()); }

void write(BinaryWriter& writer, const Stroke& stroke) {
  writer.value(stroke.kind);
  writer.value(steps(stroke.radius_px));
  std::vector<glm::ivec2> places;
  places.reserve(stroke.points_px.size());
  for (const glm::dvec2& point : stroke.points_px) {
    places.emplace_back(steps(point.x), steps(point.y));
  }
  writer.array(places);
}

void write(BinaryWriter& writer, const SetOption& edit) {
  writer.text(edit.name);
  writer.text(edit.before);
  writer.text(edit.after);
}

void write(BinaryWriter& writer, const std::optional<HandSighting>& place) {
  writer.value(std::uint8_t(!place ? 0 : place->there ? 2 : 1));
  if (place && place->there) writer.value(place->pixel);
}
void write(BinaryWriter& writer, const SetSighting& edit) {
  writer.text(edit.photo);
  writer.text(edit.point);
  write(writer, edit.before);
  write(writer, edit.after);
}
void write(BinaryWriter& writer, const Tape& tape) {
  writer.text(tape.from);
  writer.text(tape.to);
  writer.value(tape.length_m);
  writer.value(tape.sigma_m);
}
void write(BinaryWriter& writer, const Height& height) {
  writer.text(height.point);
  writer.value(height.height_m);
  writer.value(height.sigma_m);
}
void write(BinaryWriter& writer, const SurveyedPoint& point) {
  writer.text(point.point);
  writer.value(point.in_world);
  writer.value(point.sigma_m);
}

template <class Item>
void write_list(BinaryWriter& writer, const std::vector<Item>& items) {
  writer.value(std::uint64_t(items.size()));
  for (const Item& item : items) write(writer, item);
}

void write(BinaryWriter& writer, const SetPhotos& edit) {
  write_list(writer, edit.before);
  write_list(writer, edit.after);
}
void write(BinaryWriter& writer, const SetFiles& edit) {
  writer.value(edit.which);
  write(writer, edit.before);
  write(writer, edit.after);
}
void write(BinaryWriter& writer, const AddStroke& edit) {
  writer.text(edit.photo);
  write(writer, edit.stroke);
}
void write(BinaryWriter& writer, const ClearStrokes& edit) {
  writer.text(edit.photo);
  write_list(writer, edit.before);
}
void write(BinaryWriter& writer, const UseAll& edit) {
  writer.text(edit.photo);
  write_list(writer, edit.before);
}
void write(BinaryWriter& writer, const SetOptions& edit) {
  writer.text(edit.what);
  write_list(writer, edit.options);
}

void write(BinaryWriter& writer, const SetSightings& edit) {
  writer.text(edit.what);
  write_list(writer, edit.sightings);
}

void write(BinaryWriter& writer, const Measurements& measurements) {
  write_list(writer, measurements.tapes);
  write_list(writer, measurements.heights);
  write_list(writer, measurements.points);
}
void write(BinaryWriter& writer, const SetMeasurements& edit) {
  write(writer, edit.before);
  write(writer, edit.after);
}

void write(BinaryWriter& writer, const RenamePoint& edit) {
  write(writer, edit.seen);
  write(writer, edit.measured);
}

fs::path read_path(BinaryReader& reader) { return reader.text(); }

Stroke read_stroke(BinaryReader& reader) {
  Stroke stroke;
  stroke.kind = read_kind<StrokeKind>(reader, 4);
  stroke.radius_px = pixels(reader.value<std::int32_t>());
  const auto places = reader.array<glm::ivec2>();
  stroke.points_px.reserve(places.size());
  for (const glm::ivec2& place : places) {
    stroke.points_px.emplace_back(pixels(place.x), pixels(place.y));
  }
  return rounded_stroke(std::move(stroke));
}

SetOption read_option(BinaryReader& reader) {
  SetOption edit;
  edit.name = reader.text();
  edit.before = reader.text();
  edit.after = reader.text();
  return edit;
}

SetPhotos read_photo_places(BinaryReader& reader) {
  SetPhotos edit;
  edit.before = read_list(reader, read_path);
  edit.after = read_list(reader, read_path);
  return edit;
}

SetFiles read_files(BinaryReader& reader) {
  SetFiles edit;
  edit.which = read_kind<FileKind>(reader, 5);
  edit.before = read_path(reader);
  edit.after = read_path(reader);
  return edit;
}

AddStroke read_added(BinaryReader& reader) {
  AddStroke edit;
  edit.photo = reader.text();
  edit.stroke = read_stroke(reader);
  return edit;
}

template <class Edit>
Edit read_cleared(BinaryReader& reader) {
  Edit edit;
  edit.photo = reader.text();
  edit.before = read_list(reader, read_stroke);
  return edit;
}

SetOptions read_options(BinaryReader& reader) {
  SetOptions edit;
  edit.what = reader.text();
  edit.options = read_list(reader, read_option);
  return edit;
}

std::optional<HandSighting> read_place(BinaryReader& reader) {
  switch (reader.value<std::uint8_t>()) {
    case 0:
      return std::nullopt;
    case 1:
      return HandSighting{false, {}};
    case 2:
      return HandSighting{true, reader.value<glm::dvec2>()};
    default:
      throw Error("there is no such kind");
  }
}

SetSighting read_sighting(BinaryReader& reader) {
  SetSighting edit;
  edit.photo = reader.text();
  edit.point = reader.text();
  edit.before = read_place(reader);
  edit.after = read_place(reader);
  for (const auto& place : {edit.before, edit.after}) {
    if (place) check(edit.point, *place);
  }
  return edit;
}

SetSightings read_sightings(BinaryReader& reader) {
  SetSightings edit;
  edit.what = reader.text();
  edit.sightings = read_list(reader, read_sighting);
  return edit;
}

Tape read_tape(BinaryReader& reader) {
  Tape tape;
  tape.from = reader.text();
  tape.to = reader.text();
  tape.length_m = reader.value<double>();
  tape.sigma_m = reader.value<double>();
  return tape;
}

Height read_height(BinaryReader& reader) {
  Height height;
  height.point = reader.text();
  height.height_m = reader.value<double>();
  height.sigma_m = reader.value<double>();
  return height;
}

SurveyedPoint read_surveyed(BinaryReader& reader) {
  SurveyedPoint point;
  point.point = reader.text();
  point.in_world = reader.value<glm::dvec3>();
  point.sigma_m = reader.value<double>();
  return point;
}

Measurements read_measurements(BinaryReader& reader) {
  Measurements measurements;
  measurements.tapes = read_list(reader, read_tape);
  measurements.heights = read_list(reader, read_height);
  measurements.points = read_list(reader, read_surveyed);
  check(measurements);
  return measurements;
}

SetMeasurements read_measuring(BinaryReader& reader) {
  SetMeasurements edit;
  edit.before = read_measurements(reader);
  edit.after = read_measurements(reader);
  return edit;
}

Edit read_edit(BinaryReader& reader) {
  switch (reader.value<std::uint8_t>()) {
    case 0:
      return read_option(reader);
    case 1:
      return read_photo_places(reader);
    case 2:
      return read_files(reader);
    case 3:
      return read_added(reader);
    case 4:
      return read_cleared<ClearStrokes>(reader);
    case 5:
      return read_options(reader);
    case 6:
      return read_sighting(reader);
    case 7:
      return read_sightings(reader);
    case 8:
      return read_measuring(reader);
    case 9: {
      SetSightings seen = read_sightings(reader);
      return RenamePoint{std::move(seen), read_measuring(reader)};
    }
    case 10:
      return read_cleared<UseAll>(reader);
    default:
      throw Error("there is no such edit");
  }
}

}  // namespace

std::vector<std::byte> bytes_of_edit(const Edit& edit) {
  BinaryWriter writer;
  writer.value(std::uint8_t(edit.index()));
  std::visit([&](const auto& kind) { write(writer, kind); }, edit);
  return writer.bytes();
}

Edit edit_of_bytes(std::span<const std::byte> bytes) {
  BinaryReader reader(bytes);
  Edit edit = read_edit(reader);
  if (!reader.at_end()) throw Error("an edit is too long");
  return edit;
}

}  // namespace bosk
