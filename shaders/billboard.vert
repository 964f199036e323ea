#version 450
// The box around a billboard on the screen, two triangles a record.

#include "frame.glsl"
#include "record.glsl"

layout(std430, binding = 8) readonly buffer Records { Record records[]; };

// The two passes of the area filter; Passes in core/render/splat.cpp.
layout(location = 0) flat out vec4 centre_and_passes;  // centre.xy, column_px, row_px
layout(location = 1) flat out vec3 slants;             // shift_px, slope, fade
layout(location = 2) flat out uvec4 textures;          // pairs of a, b; kind; rows << 1 | exchanged
layout(location = 3) flat out vec4 tint;
layout(location = 4) flat out float weight_b;

void set_passes(Record record) {
  vec2 across = record.across_px, down = record.down_px;
  bool exchanged = abs(across.x) < abs(down.x);
  if (exchanged) {
    across = record.down_px;
    down = record.across_px;
  }
  float texels = float(record.kind & 15u);
  uint rows = record.kind & 15u;
  // Split the rows until one shifts against the next by less than half a pixel
  float shift_px = 2.0 * down.x / texels;
  while (abs(shift_px) > 0.5 && rows < 64u) {
    rows *= 2u;
    shift_px *= 0.5;
  }
  float slope = across.y / across.x;
  float row_px = 2.0 * (down.y - down.x * slope) / float(rows);
  centre_and_passes = vec4(record.centre_px, 2.0 * across.x / texels, row_px);
  slants = vec3(shift_px, slope, record.fade);
  textures = uvec4(record.first_pair_a, record.first_pair_b, record.kind,
                   rows << 1 | uint(exchanged));
}

void main() {
  Record record = records[gl_VertexID / 6];
  const vec2 corners[6] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(-1, 1), vec2(1, -1),
                                 vec2(1, 1));
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // off the screen
  centre_and_passes = vec4(0.0);
  slants = vec3(0.0);
  textures = uvec4(0u);
  tint = record.tint;
  weight_b = record.weight_b;
  if (record.kind == 0u) return;
  set_passes(record);
  // No wider than that would do: the reference leaves such a sliver out too
  if (!(max(abs(record.across_px.x), abs(record.down_px.x)) > 1e-12)) return;
  vec2 extent_px = abs(record.across_px) + abs(record.down_px) + 0.5;
  vec2 corner_px = record.centre_px + corners[gl_VertexID % 6] * extent_px;
  vec2 ndc = (corner_px + 0.5) / picture_px * 2.0 - 1.0;
  gl_Position = vec4(ndc.x, -ndc.y, record.depth_ndc, 1.0);
}
