#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/image/image.h"
#include "core/photo/photo.h"

namespace bosk {

// A made-up photo whose matte is known: leaves of varied greens and a trunk before a sky that grows
// paler downwards and a meadow. Mixed in linear light, noise and 8-bit steps added.
struct LeafyScene {
  Photo photo;
  Image<float> alpha;
  Image<glm::vec3> front_linear;  // the tree's own colour, also where it is clear
  Image<std::uint8_t> strokes;    // a few lines in the crown, the sky and the meadow
};

struct LeafyOptions {
  int width = 180, height = 140;
  glm::vec3 gain{1.0f};         // exposure and white balance, in linear light
  float sky = 0.8f;             // brightest linear value; above 1 the photo clips it
  std::uint32_t leaf_seed = 1;  // another tree of the same kind
};

LeafyScene leafy_scene(const LeafyOptions& options = {});

double mean_absolute_error(const Image<float>& alpha, const Image<float>& truth);
Image<float> alpha_of(const Image<glm::vec4>& rgba);

}  // namespace bosk
