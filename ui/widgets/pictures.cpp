#include "ui/widgets/pictures.h"

#include <utility>

namespace bosk {
namespace {

constexpr std::uint64_t kFramesKept = 120;  // a picture that is out of sight for longer is freed

}  // namespace

Pictures::~Pictures() { clear(); }

void Pictures::clear() {
  for (auto& [name, held] : held_) release(held);
  held_.clear();
}

void Pictures::release(Held& held) {
  if (held.texture) device_.free(held.texture.id);
  held.texture = {};
}

Texture Pictures::show(const std::string& name, std::uint64_t revision,
                       const std::function<Image<glm::u8vec4>()>& make) {
  const auto [place, is_new] = held_.try_emplace(name);
  Held& held = place->second;
  held.last_frame = frame_;
  if (!is_new && held.revision == revision) return held.texture;
  held.revision = revision;
  const Image<glm::u8vec4> picture = make();
  const glm::ivec2 size(picture.width(), picture.height());
  if (size != held.texture.size_px) release(held);
  if (size.x > 0 && size.y > 0) held.texture = {device_.upload(picture, held.texture.id), size};
  return held.texture;
}

Texture Pictures::newest(const std::string& name) {
  const auto place = held_.find(name);
  if (place == held_.end()) return {};
  place->second.last_frame = frame_;
  return place->second.texture;
}

void Pictures::end_frame() {
  ++frame_;
  for (auto place = held_.begin(); place != held_.end();) {
    if (frame_ - place->second.last_frame <= kFramesKept) {
      ++place;
      continue;
    }
    release(place->second);
    place = held_.erase(place);
  }
}

}  // namespace bosk
