#include "core/matte/matte_views.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/matte/grid.h"
#include "core/matte/scribbles.h"

namespace bosk {
namespace {

constexpr float kStrokeCover = 0.65f;  // of a stroke over the picture
constexpr glm::vec3 kDimSrgb{0.16f, 0.09f, 0.24f};
constexpr float kDimCover = 0.75f;  // of the tint over the background

glm::u8vec4 bytes_of(const glm::vec3& srgb) {
  return {glm::clamp(srgb, 0.0f, 1.0f) * 255.0f + 0.5f, 255};
}

glm::vec3 shown(MatteView view, const glm::vec3& photo, const glm::vec4& matte) {
  const glm::vec3 front(matte);
  switch (view) {
    case MatteView::photo:
      return photo;
    case MatteView::overlay:
      return glm::mix(glm::mix(photo, kDimSrgb, kDimCover), photo, matte.a);
    case MatteView::on_black:
      return front * matte.a;
    case MatteView::on_white:
      return glm::mix(glm::vec3(1.0f), front, matte.a);
    case MatteView::matte:
      return glm::vec3(matte.a);
    case MatteView::foreground:
      return matte.a > 0.0f ? front : glm::vec3(0.5f);
  }
  return photo;
}

glm::vec3 under_stroke(const glm::vec3& colour, std::uint8_t stroke) {
  if (stroke == kForegroundStroke) return glm::mix(colour, kForegroundStrokeSrgb, kStrokeCover);
  if (stroke == kBackgroundStroke) return glm::mix(colour, kBackgroundStrokeSrgb, kStrokeCover);
  return colour;
}

std::vector<GridPlace> places(int from, int to, int pixels, int cells) {
  std::vector<GridPlace> result;
  for (int i = from; i < to; ++i) result.push_back(grid_place(i, pixels, cells));
  return result;
}

glm::vec4 sample(const Image<glm::vec4>& matte, const GridPlace& x, const GridPlace& y) {
  return glm::mix(glm::mix(matte(x.first, y.first), matte(x.second, y.first), x.mix),
                  glm::mix(matte(x.first, y.second), matte(x.second, y.second), x.mix), y.mix);
}

}  // namespace

const char* name_of(MatteView view) {
  constexpr std::array<const char*, kMatteViews> kNames{"photo",    "overlay", "on black",
                                                        "on white", "matte",   "pure foreground"};
  return kNames[std::size_t(view)];
}

MatteView view_after(MatteView view) { return MatteView((int(view) + 1) % kMatteViews); }

Image<glm::u8vec4> picture_of(MatteView view, const MattedPhoto& parts) {
  const glm::ivec2 size(parts.srgb.width(), parts.srgb.height());
  Image<glm::u8vec4> picture(size.x, size.y);
  repaint(view, parts, {{0, 0}, size}, picture);
  return picture;
}

void repaint(MatteView view, const MattedPhoto& parts, const PixelBox& box,
             Image<glm::u8vec4>& picture) {
  const Image<glm::vec4>& matte = parts.matte;
  const glm::ivec2 size(picture.width(), picture.height());
  const glm::ivec2 from = glm::max(box.from, 0), to = glm::min(box.to, size);
  if (from.x >= to.x || from.y >= to.y) return;
  if (matte.empty()) view = MatteView::photo;
  const auto columns =
      matte.empty() ? std::vector<GridPlace>() : places(from.x, to.x, size.x, matte.width());
  const bool same_size = matte.width() == size.x && matte.height() == size.y;
  tbb::parallel_for(from.y, to.y, [&](int y) {
    const GridPlace row = grid_place(y, size.y, std::max(1, matte.height()));
    for (int x = from.x; x < to.x; ++x) {
      glm::vec3 colour = parts.srgb(x, y);
      if (view != MatteView::photo) {
        colour =
            shown(view, colour,
                  same_size ? matte(x, y) : sample(matte, columns[std::size_t(x - from.x)], row));
      }
      if (!parts.strokes.empty()) colour = under_stroke(colour, parts.strokes(x, y));
      picture(x, y) = bytes_of(colour);
    }
  });
}

}  // namespace bosk
