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

// A row of the photo from a matte of another size: first between two of its rows, then along them.
class StretchedRow {
 public:
  StretchedRow(const Image<glm::vec4>& matte, int y, int rows)
      : between_(std::size_t(matte.width())) {
    const GridPlace place = grid_place(y, rows, matte.height());
    const glm::vec4* first = &matte(0, place.first);
    const glm::vec4* second = &matte(0, place.second);
    for (std::size_t x = 0; x < between_.size(); ++x) {
      between_[x] = glm::mix(first[x], second[x], place.mix);
    }
  }
  glm::vec4 at(const GridPlace& place) const {
    return glm::mix(between_[std::size_t(place.first)], between_[std::size_t(place.second)],
                    place.mix);
  }

 private:
  std::vector<glm::vec4> between_;
};

// Calls paint(x, the view's colour) for a row.
template <class Paint>
void colour_row(MatteView view, const MattedPhoto& parts, int y, int from,
                const std::vector<GridPlace>& columns, Paint paint) {
  const glm::vec3* photo = &parts.srgb(from, y);
  const int count = int(columns.size());
  if (view == MatteView::photo) {
    for (int i = 0; i < count; ++i) paint(from + i, photo[i]);
  } else if (parts.matte.width() == parts.srgb.width() &&
             parts.matte.height() == parts.srgb.height()) {
    const glm::vec4* matte = &parts.matte(from, y);
    for (int i = 0; i < count; ++i) paint(from + i, shown(view, photo[i], matte[i]));
  } else {
    const StretchedRow matte(parts.matte, y, parts.srgb.height());
    for (int i = 0; i < count; ++i) {
      paint(from + i, shown(view, photo[i], matte.at(columns[std::size_t(i)])));
    }
  }
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
  const glm::ivec2 size(picture.width(), picture.height());
  const auto [from, to] = overlap(box, {{0, 0}, size});
  if (from.x >= to.x || from.y >= to.y) return;
  if (parts.matte.empty()) view = MatteView::photo;
  const auto columns = places(from.x, to.x, size.x, std::max(1, parts.matte.width()));
  tbb::parallel_for(from.y, to.y, [&](int y) {
    colour_row(view, parts, y, from.x, columns, [&](int x, const glm::vec3& colour) {
      picture(x, y) =
          bytes_of(parts.strokes.empty() ? colour : under_stroke(colour, parts.strokes(x, y)));
    });
  });
}

}  // namespace bosk
