#include "ui/widgets/fitted_picture.h"

#include <algorithm>

#include "core/image/orientation.h"

namespace bosk {

void draw_fitted(const Texture& texture, const ImVec2& least, const ImVec2& area, int orientation) {
  if (!texture) return;
  const glm::vec2 size(upright_size(texture.size_px, orientation));
  const float scale = std::min(area.x / size.x, area.y / size.y);
  const ImVec2 from(least.x + 0.5f * (area.x - scale * size.x),
                    least.y + 0.5f * (area.y - scale * size.y));
  const ImVec2 to(from.x + scale * size.x, from.y + scale * size.y);
  const auto uv = corner_textures(orientation);
  const auto corner = [&](std::size_t i) { return ImVec2(uv[i].x, uv[i].y); };
  ImGui::GetWindowDrawList()->AddImageQuad(texture.id, from, {to.x, from.y}, to, {from.x, to.y},
                                           corner(0), corner(1), corner(2), corner(3));
}

}  // namespace bosk
