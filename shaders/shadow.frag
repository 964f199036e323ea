#version 450
// Shade of one crown, multiplied onto the ground: core/render/gl/crown_shadow.h.

#include "scenery.glsl"

layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 1) uniform int shadow;
layout(binding = 0) uniform sampler2DArray transmittances;
layout(location = 0) out vec4 factor;

struct Shadow {
  vec4 across, down;  // texture coordinates of a place on the ground: dot(xyz, place) + w
  vec4 along;         // towards the sun, in radii of the crown from its middle
  ivec4 layer;
};
layout(std430, binding = 1) readonly buffer Shadows { Shadow shadows[]; };

void main() {
  Shadow s = shadows[shadow];
  vec2 at = vec2(dot(s.across.xyz, place) + s.across.w, dot(s.down.xyz, place) + s.down.w);
  float transmittance = texture(transmittances, vec3(at, float(s.layer.x))).r;
  // Not on slopes that face the sun from behind the crown
  bool behind = dot(s.along.xyz, place) + s.along.w < 1.0;
  if (!behind || any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0))))
    transmittance = 1.0;
  float haze = 1.0 - exp(-distance(place, eye.xyz) / eye.w);
  float light = mix(transmittance, 1.0, to_sun.w);
  // The framebuffer is sRGB-encoded: nearly the power 1 / 2.2 of light
  factor = vec4(vec3(mix(pow(light, 1.0 / 2.2), 1.0, haze)), 1.0);
}
