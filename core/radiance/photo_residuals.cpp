#include "core/radiance/photo_residuals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/opacity/ray_cache.h"
#include "core/radiance/volume_march.h"

namespace bosk {
namespace {

PhotoResidual residual_of(const VolumeSnapshot& volume, const SmallMatte& matte) {
  const Image<glm::vec4> seen = premultiplied_picture(volume, matte.camera);
  double alpha = 0.0, square = 0.0, count = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const glm::vec4& truth = matte.premultiplied.pixels()[i];
    const glm::vec4 error = seen.pixels()[i] - truth;
    if (truth.a <= 0.0f && seen.pixels()[i].a <= 0.0f) continue;
    count += 1.0;
    alpha += std::abs(double(error.a));
    square += volume.has_colour ? double(glm::dot(error, error)) / 4.0
                                : double(error.a) * double(error.a);
  }
  PhotoResidual residual{matte.name, 0.0, std::numeric_limits<double>::infinity()};
  if (count > 0.0) residual.alpha_error = alpha / count;
  if (square > 0.0) residual.psnr_db = -10.0 * std::log10(square / count);
  return residual;
}

}  // namespace

std::vector<SmallMatte> small_mattes(const Photos& photos, const Mattes& mattes, int longest_px) {
  assert(photos.size() == mattes.size() && longest_px > 0);
  std::vector<SmallMatte> small;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const int longest = std::max(mattes[i].rgba.width(), mattes[i].rgba.height());
    const int step = std::max(1, (longest + longest_px - 1) / longest_px);
    SmallMatte matte{photos[i].name, photos[i].camera, premultiplied_at(mattes[i], step)};
    Lens& lens = matte.camera.lens;  // not `scaled`: a last block that isn't whole is left out
    lens.width_px = matte.premultiplied.width();
    lens.height_px = matte.premultiplied.height();
    lens.focal_px /= double(step);
    lens.principal_px = (lens.principal_px + 0.5) / double(step) - 0.5;
    small.push_back(std::move(matte));
  }
  return small;
}

std::vector<PhotoResidual> photo_residuals(const VolumeSnapshot& volume,
                                           const std::vector<SmallMatte>& mattes) {
  std::vector<PhotoResidual> residuals;
  for (const SmallMatte& matte : mattes) residuals.push_back(residual_of(volume, matte));
  return residuals;
}

}  // namespace bosk
