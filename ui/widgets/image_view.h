#pragma once

#include <imgui.h>

#include <glm/glm.hpp>

#include "ui/widgets/pictures.h"

namespace bosk {

// Which part of a picture is seen, and how large; kept between frames. Several views that share one
// show the same part.
struct ImageView {
  double zoom = 1.0;            // 1 shows all of the picture; at most kMostZoom
  glm::dvec2 middle{0.5, 0.5};  // of what is seen, 0 to 1 across the picture

  bool operator==(const ImageView&) const = default;
};
inline constexpr double kMostZoom = 64.0;

// A view as it lies on the screen. Picture coordinates are pixels of a picture of `size_px`, (0, 0)
// the centre of the first pixel.
struct ImagePlace {
  ImVec2 least{0, 0}, most{0, 0};  // the item on the screen
  glm::dvec2 size_px{1.0};
  double scale = 1.0;      // screen points per pixel
  glm::dvec2 origin{0.0};  // where the picture's pixel (-0.5, -0.5) is on the screen
  bool hovered = false;

  glm::dvec2 screen_from_picture(const glm::dvec2& pixel) const {
    return origin + (pixel + 0.5) * scale;
  }
  glm::dvec2 picture_from_screen(const glm::dvec2& point) const {
    return (point - origin) / scale - 0.5;
  }
  glm::dvec2 mouse_px() const;  // where the mouse is in the picture
};

// Where a picture of `size_px` would lie in an area of the screen.
ImagePlace place_of(const ImageView& view, const glm::dvec2& size_px, const ImVec2& least,
                    const ImVec2& most);

// Draws the texture in an item of `area` (0: all that is left) and lets wheel (at the mouse),
// middle drag, left drag with Space, and Home change the view; left and right button are the
// caller's. `size_px` is the size that picture coordinates mean, which the texture may be a reduced
// copy of. Marked as landmark `name`.
ImagePlace draw_image_view(const std::string& name, ImageView& view, const Texture& texture,
                           const glm::dvec2& size_px, ImVec2 area = {0, 0});

// The view zoomed by a factor so that what is at `at_px` stays where it is.
ImageView zoomed(const ImageView& view, const ImagePlace& place, const glm::dvec2& at_px,
                 double factor);

}  // namespace bosk
