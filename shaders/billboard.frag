#version 450
// Compiled with BC3_ATLAS, 0 or 1. Drivers that draw on the CPU run both sides of every `if` and one
// more round of every `while` or `for`, so what may be left out is the body of a `do`.
//
// Each pixel gets the mean over its own area of the billboard's texture: core/render/splat.cpp, with
// the sums of both passes written as one weight for each texel.

#include "frame.glsl"
#include "pairs.glsl"
#include "record.glsl"

const float kFadeSlack = 1.0 / 32.0;  // core/render/draw_list.h

layout(location = 0) flat in vec4 centre_and_passes;
layout(location = 1) flat in vec3 slants;
layout(location = 2) flat in uvec4 textures;
layout(location = 3) flat in vec4 tint;
layout(location = 4) flat in float weight_b;
#if BC3_ATLAS
layout(binding = 0) uniform sampler2DArray atlas;
#else
// Four texels a tile, side by side: its 16 alphas, reds, greens and blues, a component for each row of
// the tile and a byte for each column. One fetch instead of sixteen.
layout(binding = 0) uniform usampler2DArray atlas;
#endif
layout(location = 0) out vec4 premultiplied;

// Integrals of hats 4 * group ... of `count` from 0 to a position; Hats in splat.cpp.
vec4 cumulative(float position, int group, int count) {
  vec4 centres = float(4 * group) + vec4(0.5, 1.5, 2.5, 3.5);
  vec4 rise = vec4(group == 0 ? 0.0 : 0.5, 0.5, 0.5, 0.5);
  vec4 fall = vec4(-0.5, -0.5, -0.5, 4 * group + 4 == count ? 0.0 : -0.5);
  vec4 t = clamp(clamp(position, 0.0, float(count)) - centres, -1.0, 1.0);
  return 0.5 + t + mix(fall, rise, lessThan(t, vec4(0.0))) * t * t;
}

struct Pixel {
  float x, upper, lower;  // x from the billboard's centre; upper and lower edge in rows
};

Pixel pixel_in_rows(int rows) {
  vec2 pixel = vec2(gl_FragCoord.x, picture_px.y - gl_FragCoord.y) - 0.5 - centre_and_passes.xy;
  vec2 edges = vec2(-0.5, 0.5) + (pixel.y - slants.y * pixel.x);
  edges = edges / centre_and_passes.w + 0.5 * float(rows);
  return Pixel(pixel.x, edges.x, edges.y);
}

// First pass: integral of four columns' hats over the pixel's width, along a row that the shear has
// shifted.
vec4 along_row(Pixel pixel, float row_from_middle, int group, int texels) {
  float column_px = centre_and_passes.z;
  vec2 edges = vec2(-0.5, 0.5) + (pixel.x - slants.x * row_from_middle);
  edges = edges / column_px + 0.5 * float(texels);
  return column_px * (cumulative(edges.y, group, texels) - cumulative(edges.x, group, texels));
}

// Second pass: the same of four rows' hats over the pixel's height.
vec4 across_rows(Pixel pixel, int group, int rows) {
  return centre_and_passes.w *
         (cumulative(pixel.lower, group, rows) - cumulative(pixel.upper, group, rows));
}

// How much of the pixel each texel of a block fills; a column of the matrix is a row of the texture,
// whose rows run along x. A row of the passes lies on one of the texture's own or, where they are
// split, between two.
mat4 block_weights(Pixel pixel, int row_group, int group, int texels, int rows) {
  mat4 weights = mat4(0.0);
  vec4 rows_of_block = float(4 * row_group) + vec4(0.0, 1.0, 2.0, 3.0);
  float middle = 0.5 * float(rows), own_rows = float(texels) / float(rows);
  int pass_group = 0;
  do {
    vec4 down = across_rows(pixel, pass_group, rows);
    for (int i = 0; i < 4; ++i) {
      float row = float(4 * pass_group + i) + 0.5;
      float own_row = clamp(row * own_rows - 0.5, 0.0, float(texels - 1));
      vec4 share = down[i] * max(1.0 - abs(own_row - rows_of_block), 0.0);
      weights += outerProduct(along_row(pixel, row - middle, group, texels), share);
    }
    ++pass_group;
  } while (4 * pass_group < rows);
  return weights;
}

#if BC3_ATLAS
vec4 texel(ivec3 colour_corner, ivec3 alpha_corner, ivec3 at, float weight) {
  float alpha = weight * texelFetch(atlas, alpha_corner + at, 0).a;
  return alpha * vec4(texelFetch(atlas, colour_corner + at, 0).rgb, 1.0);
}

vec4 row_mean(ivec3 colour_corner, ivec3 alpha_corner, int row, vec4 weights) {
  if (weights == vec4(0.0)) return vec4(0.0);
  return texel(colour_corner, alpha_corner, ivec3(0, row, 0), weights.x) +
         texel(colour_corner, alpha_corner, ivec3(1, row, 0), weights.y) +
         texel(colour_corner, alpha_corner, ivec3(2, row, 0), weights.z) +
         texel(colour_corner, alpha_corner, ivec3(3, row, 0), weights.w);
}

// The mean of a block by the weights, premultiplied, from the places of its tiles.
vec4 block_mean(ivec3 alpha, ivec3 colour, mat4 weights) {
  const ivec3 kTileTexels = ivec3(4, 4, 1);
  ivec3 alpha_corner = alpha * kTileTexels, colour_corner = colour * kTileTexels;
  return row_mean(colour_corner, alpha_corner, 0, weights[0]) +
         row_mean(colour_corner, alpha_corner, 1, weights[1]) +
         row_mean(colour_corner, alpha_corner, 2, weights[2]) +
         row_mean(colour_corner, alpha_corner, 3, weights[3]);
}

#else

float weighted(uvec4 bytes, mat4 weights) {
  return dot(unpackUnorm4x8(bytes.x), weights[0]) + dot(unpackUnorm4x8(bytes.y), weights[1]) +
         dot(unpackUnorm4x8(bytes.z), weights[2]) + dot(unpackUnorm4x8(bytes.w), weights[3]);
}

vec4 block_mean(ivec3 alpha_tile, ivec3 colour_tile, mat4 weights) {
  const ivec3 kTileTexels = ivec3(4, 1, 1);
  ivec3 first = colour_tile * kTileTexels;
  uvec4 bytes = texelFetch(atlas, alpha_tile * kTileTexels, 0);
  mat4 alpha = mat4(unpackUnorm4x8(bytes.x) * weights[0], unpackUnorm4x8(bytes.y) * weights[1],
                    unpackUnorm4x8(bytes.z) * weights[2], unpackUnorm4x8(bytes.w) * weights[3]);
  return vec4(weighted(texelFetch(atlas, first + ivec3(1, 0, 0), 0), alpha),
              weighted(texelFetch(atlas, first + ivec3(2, 0, 0), 0), alpha),
              weighted(texelFetch(atlas, first + ivec3(3, 0, 0), 0), alpha),
              dot(alpha * vec4(1.0), vec4(1.0)));
}

#endif

// A tile's place in the atlas, counted in tiles.
ivec3 tile_place(uint packed_place, int layer) {
  return ivec3(packed_place & 127u, packed_place >> 7, layer);
}

// Both views' mean over the pixel; of a solid square its coverage.
vec4 pixel_mean() {
  uint kind = textures.z;
  int texels = int(kind & 15u), rows = int(textures.w >> 1), layer = int(kind >> 8);
  int blocks = texels / 4, view_count = weight_b > 0.0 ? 2 : 1;
  bool exchanged = (textures.w & 1u) != 0u, solid = (kind & kSolid) != 0u;
  Pixel pixel = pixel_in_rows(rows);
  vec4 mean = vec4(0.0);
  int block = 0;
  do {
    int row = block / blocks, column = block % blocks;
    mat4 weights = block_weights(pixel, exchanged ? column : row, exchanged ? row : column, texels,
                                 rows);
    if (exchanged) weights = transpose(weights);
    if (solid) mean += dot(weights * vec4(1.0), vec4(tint.a));
    int view = 0;
    do {
      uint pair = pairs[(view == 0 ? textures.x : textures.y) + uint(block)];
      float share = view == 0 ? 1.0 - weight_b : weight_b;
      if (!solid && (pair & 0xffffu) < kOutside)
        mean += share * block_mean(tile_place(pair & 0xffffu, layer), tile_place(pair >> 16, layer),
                                   weights);
      ++view;
    } while (view < view_count);
    ++block;
  } while (block < blocks * blocks);
  return mean;
}

void main() {
  vec4 mean = pixel_mean();
  mean.rgb = colours == kTree ? mean.rgb * tint.rgb : mean.a * tint.rgb;
  float fade = slants.z;
  if (fade < 1.0 && mean.a > 0.0)
    mean *= (1.0 - pow(max(1.0 - mean.a * (1.0 - kFadeSlack * (1.0 - fade)), 0.0), fade)) / mean.a;
  premultiplied = mean;
}
