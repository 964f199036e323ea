// One frame's constants of sky and ground; SceneryBlock in core/render/gl/scenery_renderer.cpp. The
// ground's frame is the world's, moved to the middle of its grid.
layout(std140, binding = 0) uniform Scenery {
  mat4 clip_from_ground;
  vec4 world_from_camera[3];  // rows
  vec4 lens;                  // focal lengths, principal point
  vec4 picture_px;            // xy
  vec4 eye;                   // w: how far one sees, metres
  vec4 to_sun;                // unit length; w: share of the light that the shade keeps
  vec4 zenith, horizon, ground;  // sRGB-encoded
  ivec4 grid;                    // points across, points down
};

vec3 linear_from_srgb(vec3 c) {
  return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045)));
}
vec3 srgb_from_linear(vec3 c) {
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, c * 12.92,
             lessThanEqual(c, vec3(0.0031308)));
}
