#include "core/project/binary_items.h"

namespace bosk {

void write_text(BinaryWriter& writer, const std::string& text) { writer.text(text); }

void write_camera(BinaryWriter& writer, const Camera& camera) {
  writer.text(camera.name);
  writer.value(camera.lens);
  writer.value(camera.camera_from_world);
}

void write_lens_identity(BinaryWriter& writer, const LensIdentity& identity) {
  writer.text(identity.make);
  writer.text(identity.model);
  write_optional(writer, identity.focal_mm);
}

std::string read_text(BinaryReader& reader) { return reader.text(); }

Camera read_camera(BinaryReader& reader) {
  Camera camera;
  camera.name = reader.text();
  camera.lens = reader.value<Lens>();
  camera.camera_from_world = reader.value<RigidTransform>();
  return camera;
}

LensIdentity read_lens_identity(BinaryReader& reader) {
  LensIdentity identity;
  identity.make = reader.text();
  identity.model = reader.text();
  identity.focal_mm = read_optional<double>(reader);
  return identity;
}

}  // namespace bosk
