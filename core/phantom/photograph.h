#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/phantom/light.h"
#include "core/phantom/ray_scene.h"
#include "core/phantom/scene.h"
#include "core/phantom/tree.h"
#include "core/photo/camera.h"

namespace bosk {

// A lit tree in its surroundings, ready to be photographed from anywhere.
struct Studio {
  Tree tree;
  RayScene resting_rays, distant_rays;
  World world;
  GroundLight ground_light;
  TreeLight tree_light;
};
// `ground_map` is the side of the ground's shadow map.
Studio set_up_studio(Tree tree, World world, int ground_map, Progress& progress);

// One press of the shutter.
struct Shot {
  std::uint64_t seed = 1;  // of the noise, the sampling and the gust
  double exposure = 1.0;   // factor on the light
  double noise = 1.0;      // factor on the deviation of the noise; 0 none
  double wind = 0.0;       // metres of sway at the top
  int samples = 8;         // rays a pixel are samples x samples, a multiple of 8
  bool background = true;  // else the photograph is black behind the tree, and quicker
};

// The photograph and its truth, in the lens's distorted pixels. In linear light, photograph =
// alpha F + (1 - alpha) B up to noise, clipping and 8 bits, wherever nothing stands in front.
struct Exposure {
  Image<glm::u8vec3> photograph;  // sRGB
  Image<glm::u8vec4> matte;  // the tree alone: straight sRGB colour and alpha; 0 where alpha is 0
  Image<std::uint8_t> in_front;  // share of the pixel where a marker or board hides what is behind
};

// Every pixel gathers its rays under the filter (1 3 3 1)/8 at half-pixel steps, the same for
// colour and alpha, so alpha is area coverage under that filter. Light moves with the leaves: wind
// changes where they are, not how they are lit.
Exposure photograph(const Studio& studio, const Camera& camera, const Shot& shot,
                    Progress& progress);

// Share of a marker's disc that shows, tree at rest; 0 outside the picture.
double visible_share(const Studio& studio, const Camera& camera, std::size_t marker);

}  // namespace bosk
