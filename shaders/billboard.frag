#version 450
// Each pixel gets the mean over its own area of the billboard's texture: core/render/splat.cpp, with
// the sums of both passes written as one weight for each texel.

#include "frame.glsl"
#include "pairs.glsl"
#include "record.glsl"

layout(location = 0) flat in vec4 centre_and_passes;
layout(location = 1) flat in vec3 slants;
layout(location = 2) flat in uvec4 textures;
layout(location = 3) flat in vec4 tint;
layout(location = 4) flat in float weight_b;
layout(binding = 0) uniform sampler2DArray atlas;
layout(location = 0) out vec4 premultiplied;

// Integrals of hats 4 * group ... of `count` from 0 to a position; Hats in splat.cpp.
vec4 cumulative(float position, int group, int count) {
  vec4 centres = float(4 * group) + vec4(0.5, 1.5, 2.5, 3.5);
  vec4 rise = vec4(group == 0 ? 0.0 : 0.5, 0.5, 0.5, 0.5);
  vec4 fall = vec4(-0.5, -0.5, -0.5, 4 * group + 4 == count ? 0.0 : -0.5);
  vec4 t = clamp(clamp(position, 0.0, float(count)) - centres, -1.0, 1.0);
  return 0.5 + t + mix(fall, rise, lessThan(t, vec4(0.0))) * t * t;
}

// How much of the pixel each texel fills, of a texture with rows along x; [2 * row + group of four
// columns].
vec4 weights[16];

void find_weights(vec2 pixel, int texels, int rows) {
  vec2 centre = centre_and_passes.xy;
  float column_px = centre_and_passes.z, row_px = centre_and_passes.w;
  float middle = 0.5 * float(rows);
  float column_centre = centre.y + slants.y * (pixel.x - centre.x);
  float upper = (pixel.y - 0.5 - column_centre) / row_px + middle;
  float lower = (pixel.y + 0.5 - column_centre) / row_px + middle;
  for (int i = 0; i < 2 * texels; ++i) weights[i] = vec4(0.0);
  for (int row_group = 0; row_group < rows / 4; ++row_group) {
    vec4 down = row_px * (cumulative(lower, row_group, rows) - cumulative(upper, row_group, rows));
    for (int i = 0; i < 4; ++i) {
      if (down[i] == 0.0) continue;
      float row = float(4 * row_group + i) + 0.5;
      float from_row = pixel.x - centre.x - slants.x * (row - middle);
      float left = (from_row - 0.5) / column_px + 0.5 * float(texels);
      float right = (from_row + 0.5) / column_px + 0.5 * float(texels);
      // Where the texture's row stands between two of its own, when rows are split
      float v = clamp(row * float(texels) / float(rows) - 0.5, 0.0, float(texels - 1));
      int above = min(int(v), texels - 2);
      vec2 share = vec2(float(above + 1) - v, v - float(above)) * (down[i] * column_px);
      for (int group = 0; group < texels / 4; ++group) {
        vec4 across = cumulative(right, group, texels) - cumulative(left, group, texels);
        weights[2 * above + group] += share.x * across;
        weights[2 * above + 2 + group] += share.y * across;
      }
    }
  }
}

ivec3 tile_corner(uint place, int layer) {
  return ivec3(4u * (place & 127u), 4u * (place >> 7), layer);
}

// The mean of one view's texture by the weights, premultiplied.
vec4 view_mean(uint first_pair, int texels, bool exchanged, int layer) {
  vec4 mean = vec4(0.0);
  int blocks = texels / 4;
  for (int row_block = 0; row_block < blocks; ++row_block) {
    for (int group = 0; group < blocks; ++group) {
      int block = exchanged ? group * blocks + row_block : row_block * blocks + group;
      uint pair = pairs[first_pair + uint(block)];
      if ((pair & 0xffffu) >= kOutside) continue;
      ivec3 alpha_corner = tile_corner(pair & 0xffffu, layer);
      ivec3 colour_corner = tile_corner(pair >> 16, layer);
      for (int row = 0; row < 4; ++row) {
        vec4 weight = weights[2 * (4 * row_block + row) + group];
        for (int i = 0; i < 4; ++i) {
          if (weight[i] == 0.0) continue;
          ivec3 texel = exchanged ? ivec3(row, i, 0) : ivec3(i, row, 0);
          float alpha = weight[i] * texelFetch(atlas, alpha_corner + texel, 0).a;
          mean += alpha * vec4(texelFetch(atlas, colour_corner + texel, 0).rgb, 1.0);
        }
      }
    }
  }
  return mean;
}

float coverage(int texels) {
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 2 * texels; ++i) sum += weights[i];
  return dot(sum, vec4(1.0));
}

void main() {
  uint kind = textures.z;
  int texels = int(kind & 15u), rows = int(textures.w >> 1), layer = int(kind >> 8);
  bool exchanged = (textures.w & 1u) != 0u;
  vec2 pixel = vec2(gl_FragCoord.x, picture_px.y - gl_FragCoord.y) - 0.5;
  find_weights(pixel, texels, rows);
  vec4 mean = vec4(0.0);
  if ((kind & kSolid) != 0u) {
    mean = vec4(coverage(texels) * tint.a);
  } else {
    mean = (1.0 - weight_b) * view_mean(textures.x, texels, exchanged, layer);
    if (weight_b > 0.0) mean += weight_b * view_mean(textures.y, texels, exchanged, layer);
  }
  mean.rgb = colours == kTree ? mean.rgb * tint.rgb : mean.a * tint.rgb;
  float fade = slants.z;
  if (fade < 1.0 && mean.a > 0.0)
    mean *= (1.0 - pow(max(1.0 - mean.a, 0.0), fade)) / mean.a;
  premultiplied = mean;
}
