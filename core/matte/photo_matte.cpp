#include "core/matte/photo_matte.h"

#include <tbb/parallel_for.h>

#include "core/image/colour.h"
#include "core/matte/clean_alpha.h"
#include "core/matte/foreground.h"
#include "core/matte/local_alpha.h"

namespace bosk {
namespace {

Matte with_foreground(const std::string& name, const Image<glm::vec3>& linear,
                      const Image<float>& alpha, Progress& progress) {
  const Image<glm::vec3> front = estimate_foreground(linear, alpha, progress);
  Matte matte{name, {alpha.width(), alpha.height()}};
  tbb::parallel_for(0, alpha.height(), [&](int y) {
    progress.check();
    for (int x = 0; x < alpha.width(); ++x) {
      matte.rgba(x, y) = glm::vec4(srgb_from_linear(front(x, y)), alpha(x, y));
    }
  });
  return matte;
}

}  // namespace

Image<glm::vec3> linear_light(const Image<glm::vec3>& srgb, const Progress& progress) {
  Image<glm::vec3> linear(srgb.width(), srgb.height());
  tbb::parallel_for(0, srgb.height(), [&](int y) {
    progress.check();
    for (int x = 0; x < srgb.width(); ++x) linear(x, y) = linear_from_srgb(srgb(x, y));
  });
  return linear;
}

Matte matte_from_study(const Photo& photo, const Image<glm::vec3>& linear, const Study& study,
                       const MatteOptions& options, Progress& progress) {
  Image<float> alpha = alpha_of_photo(photo, study, options, progress);
  refine_locally(linear, float(options.local_caution), alpha, progress);
  stretch_ends(alpha, float(options.clear_below), float(options.opaque_above));
  return with_foreground(photo.name, linear, alpha, progress);
}

Matte matte_from_alpha(const Photo& photo, const Image<float>& alpha, Progress& progress) {
  return with_foreground(photo.name, linear_light(photo.srgb, progress), alpha, progress);
}

}  // namespace bosk
