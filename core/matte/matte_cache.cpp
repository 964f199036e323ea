#include "core/matte/matte.h"

namespace bosk {

void write(BinaryWriter& writer, const Mattes& mattes) {
  writer.value(std::uint64_t(mattes.size()));
  for (const Matte& matte : mattes) {
    writer.text(matte.name);
    writer.value(matte.rgba.width());
    writer.value(matte.rgba.height());
    writer.array(matte.rgba.pixels());
  }
}

Mattes read_mattes(BinaryReader& reader) {
  Mattes mattes;
  const auto count = reader.value<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    Matte matte;
    matte.name = reader.text();
    const auto width = reader.value<int>(), height = reader.value<int>();
    const auto pixels = reader.array<glm::vec4>();
    if (width < 0 || height < 0 || std::uint64_t(width) * std::uint64_t(height) != pixels.size()) {
      throw Error("stored mattes are damaged");
    }
    matte.rgba = Image<glm::vec4>(width, height);
    matte.rgba.pixels() = pixels;
    mattes.push_back(std::move(matte));
  }
  return mattes;
}

}  // namespace bosk
