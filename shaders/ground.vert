#version 450
// A rectangle of the ground's grid, two triangles a mesh.

#include "scenery.glsl"

struct Point {
  vec4 place, normal;
};
layout(std430, binding = 0) readonly buffer Points { Point points[]; };
layout(location = 0) uniform ivec4 rectangle;  // first mesh across and down, meshes across and down

layout(location = 0) out vec3 place;
layout(location = 1) out vec3 normal;
// Shadows are laid over the ground by the same vertices and must meet its depth
invariant gl_Position;

void main() {
  int mesh = gl_VertexID / 6;
  const ivec2 corners[6] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(0, 1), ivec2(1, 0),
                                   ivec2(1, 1));
  ivec2 at = rectangle.xy + ivec2(mesh % rectangle.z, mesh / rectangle.z) + corners[gl_VertexID % 6];
  Point point = points[at.y * grid.x + at.x];
  place = point.place.xyz;
  normal = point.normal.xyz;
  gl_Position = clip_from_ground * vec4(place, 1.0);
}
