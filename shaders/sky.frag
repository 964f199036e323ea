#version 450
// Clear sky: from horizon to zenith, brighter around the sun.

#include "scenery.glsl"

layout(location = 0) out vec4 colour;

void main() {
  vec2 pixel = vec2(gl_FragCoord.x, picture_px.y - gl_FragCoord.y) - 0.5;
  vec3 in_camera = normalize(vec3((pixel - lens.zw) / lens.xy, 1.0));
  vec3 direction = vec3(dot(world_from_camera[0].xyz, in_camera),
                        dot(world_from_camera[1].xyz, in_camera),
                        dot(world_from_camera[2].xyz, in_camera));
  vec3 sky = mix(horizon.rgb, zenith.rgb, sqrt(clamp(direction.z, 0.0, 1.0)));
  float towards_sun = max(dot(direction, to_sun.xyz), 0.0);
  colour = vec4(mix(sky, vec3(1.0), 0.35 * pow(towards_sun, 24.0)), 1.0);
}
