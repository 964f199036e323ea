#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>

#include "core/image/image.h"

namespace bosk {

// How one rendered view compares with the truth. Both are composited in sRGB over white, as the
// NeRF benchmarks do. The crop is the bounding box of true alpha > 0, grown by 8 px and clipped:
// the background cannot flatter it.
struct ViewScore {
  double psnr = 0.0;       // dB over the whole frame; 99 for equal pictures
  double ssim = 0.0;       // Gaussian window 11x11, sigma 1.5, mean of R, G and B
  double crop_psnr = 0.0;  // dB inside the crop
  double crop_ssim = 0.0;  // mean inside the crop of the whole frame's SSIM
  double alpha_mae = 0.0;  // mean |alpha - truth| inside the crop
  double edge_ratio =
      0.0;  // mean gradient of luma inside the crop over truth's: < 1 blur, > 1 noise
  double colour_error = 0.0;  // mean CIEDE2000 inside the crop; about 1 is just visible
};

// Pictures of the same size, 8-bit sRGB with straight alpha. Error when the sizes differ or the
// truth shows nothing. A truth without any gradient has edge ratio 1 against another such, else
// infinity.
ViewScore score_view(const Image<glm::u8vec4>& rendered, const Image<glm::u8vec4>& truth);

// One measure of a ViewScore: for tables, charts and JSON.
struct ScoreField {
  const char* name;
  double ViewScore::*value;
  bool less_is_better;
};
inline constexpr std::array<ScoreField, 7> kScoreFields{
    {{"psnr", &ViewScore::psnr, false},
     {"ssim", &ViewScore::ssim, false},
     {"crop_psnr", &ViewScore::crop_psnr, false},
     {"crop_ssim", &ViewScore::crop_ssim, false},
     {"alpha_mae", &ViewScore::alpha_mae, true},
     {"edge_ratio", &ViewScore::edge_ratio, false},
     {"colour_error", &ViewScore::colour_error, true}}};

// -10 log10 of the mean squared error; 99 when that is 0. Values 0 to 1.
double psnr_db(const Image<glm::dvec3>& a, const Image<glm::dvec3>& b);

// The structural similarity of each pixel and channel (Wang et al. 2004), window and constants as
// ViewScore says, borders mirrored without repeating the edge.
Image<glm::dvec3> ssim_map(const Image<glm::dvec3>& a, const Image<glm::dvec3>& b);

// rgb * alpha + white * (1 - alpha), 0 to 1.
Image<glm::dvec3> over_white(const Image<glm::u8vec4>& rgba);

}  // namespace bosk
