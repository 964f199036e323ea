#pragma once

#include <glm/glm.hpp>

#include "core/base/options.h"
#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/package/tree_model.h"
#include "core/photo/camera.h"
#include "core/render/draw_list.h"

namespace bosk {

struct RenderOptions {
  double detail = 1.0;           // DrawOptions::detail
  int level = -1;                // DrawOptions::only_level
  std::string blend = "fading";  // or "linear": DrawOptions::blend
  bool gpu_texels = false;       // decode the BC3 atlas, as a GPU sees it
};
Options describe(RenderOptions& options);

DrawOptions draw_options(const RenderOptions& options);

// The camera as a draw list sees it; the focal length is the mean of both axes.
Viewpoint viewpoint_of(const Camera& camera);

// The tree as the camera would photograph it, at the lens's full size and with its distortion:
// straight sRGB-encoded colour, alpha 0 to 1, colour 0 where alpha is 0. Billboards are composited
// back to front in sRGB-encoded values, each placed through the lens by a local affine map and
// sampled by area; no finished picture is resampled. Billboards whose centre the lens cannot see
// are left out.
Image<glm::vec4> render_tree(const PreparedTree& tree, const Camera& camera,
                             const RenderOptions& options, Progress& progress);

// The same with premultiplied colour: for averaging, as a smaller picture of the tree needs it.
Image<glm::vec4> render_tree_premultiplied(const PreparedTree& tree, const Camera& camera,
                                           const RenderOptions& options, Progress& progress);

// Straight colour, 0 to 1, from premultiplied; 0 where alpha is 0.
Image<glm::vec4> straight_from_premultiplied(Image<glm::vec4> image);

}  // namespace bosk
