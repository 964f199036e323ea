#version 450
// Grass from afar: one colour, a little uneven, lit by sun and sky in linear light, lost in the haze.

#include "scenery.glsl"

layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec4 colour;

float random(ivec2 cell) {
  uint hash = uint(cell.x) * 0x9e3779b9u ^ uint(cell.y) * 0x85ebca6bu;
  hash = (hash ^ (hash >> 15)) * 0x2c1b3c6du;
  return float((hash ^ (hash >> 13)) & 0xffffu) / 65535.0;
}

float uneven(vec2 at) {
  ivec2 cell = ivec2(floor(at));
  vec2 t = smoothstep(0.0, 1.0, at - floor(at));
  return mix(mix(random(cell), random(cell + ivec2(1, 0)), t.x),
             mix(random(cell + ivec2(0, 1)), random(cell + ivec2(1, 1)), t.x), t.y);
}

void main() {
  float distance_m = distance(place, eye.xyz);
  // Each pattern ends before its meshes fall below a pixel
  float pattern = uneven(place.xy / 7.0) - 0.5 +
                  0.6 * (uneven(place.xy / 0.9) - 0.5) / (1.0 + 0.001 * distance_m * distance_m);
  vec3 albedo = linear_from_srgb(ground.rgb) * (1.0 + 0.35 * pattern);
  float sun = max(dot(normalize(normal), to_sun.xyz), 0.0) / max(to_sun.z, 0.2);
  vec3 lit = albedo * mix(sun, 1.0, to_sun.w);
  float haze = 1.0 - exp(-distance_m / eye.w);
  colour = vec4(mix(srgb_from_linear(clamp(lit, 0.0, 1.0)), horizon.rgb, haze), 1.0);
}
