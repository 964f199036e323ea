#include "ui/workstation/preview/comparison.h"

#include <algorithm>

#include "core/image/image_io.h"
#include "core/measure/contact_sheet.h"
#include "core/project/original_pixels.h"
#include "core/render/reference.h"

namespace bosk {
namespace {

bool shows_something(const Image<glm::u8vec4>& picture) {
  return std::any_of(picture.pixels().begin(), picture.pixels().end(),
                     [](const glm::u8vec4& pixel) { return pixel.a > 0; });
}

Image<glm::vec4> opaque(const Image<glm::vec3>& srgb) {
  Image<glm::vec4> picture(srgb.width(), srgb.height());
  std::transform(srgb.pixels().begin(), srgb.pixels().end(), picture.pixels().begin(),
                 [](const glm::vec3& colour) { return glm::vec4(colour, 1.0f); });
  return picture;
}

Image<glm::u8vec4> with_alpha(const Image<glm::u8vec3>& picture) {
  Image<glm::u8vec4> opaque_picture(picture.width(), picture.height());
  std::transform(picture.pixels().begin(), picture.pixels().end(), opaque_picture.pixels().begin(),
                 [](const glm::u8vec3& colour) { return glm::u8vec4(colour, 255); });
  return opaque_picture;
}

}  // namespace

Comparison compare_with_photo(const PreparedTree& tree, const Photo& view,
                              const Image<glm::vec3>& srgb, const Image<glm::vec4>& matte,
                              Progress& progress) {
  Photo in_lens{view.name, view.camera, view.original_camera, {}};
  Lens& lens = in_lens.original_camera.lens;
  lens = scaled(lens, view.camera.lens.width_px, view.camera.lens.height_px);
  const Image<glm::vec4> drawn = render_tree(tree, in_lens.original_camera, {}, progress);
  Comparison comparison = comparison_of(rgba8_from_straight(in_original_pixels(matte, in_lens)),
                                        rgba8_from_straight(drawn));
  if (!srgb.empty()) {
    const Image<glm::vec4> photo = in_original_pixels(opaque(srgb), in_lens);
    comparison.photo = shown_over_white(rgba8_from_straight(photo));
  }
  return comparison;
}

Comparison comparison_of(const Image<glm::u8vec4>& truth, const Image<glm::u8vec4>& render) {
  Comparison comparison{shown_over_white(truth), truth, render, {}};
  if (shows_something(truth)) comparison.score = score_view(render, truth);
  return comparison;
}

Image<glm::u8vec4> shown_over_white(const Image<glm::u8vec4>& straight) {
  Image<glm::u8vec4> shown(straight.width(), straight.height());
  std::transform(straight.pixels().begin(), straight.pixels().end(), shown.pixels().begin(),
                 [](const glm::u8vec4& pixel) {
                   const glm::vec3 colour(pixel);
                   const float alpha = float(pixel.a) / 255.0f;
                   return glm::u8vec4(glm::u8vec3(colour * alpha + 255.0f * (1.0f - alpha) + 0.5f),
                                      255);
                 });
  return shown;
}

Image<glm::u8vec4> shown_difference(const Comparison& comparison) {
  return with_alpha(difference_picture(comparison.render, comparison.truth));
}

}  // namespace bosk
