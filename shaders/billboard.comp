#version 450
// From ranges of a draw list (core/render/draw_list.h) to billboards on the screen, one invocation a
// cell: what draw_items.cpp and reference.cpp do for the CPU.

#include "frame.glsl"
#include "tree.glsl"
#include "pairs.glsl"
#include "record.glsl"
#include "lens.glsl"

layout(local_size_x = 64) in;

struct Range {
  uint start;  // cells in the ranges before it
  uint first;
  uint instance;
  uint flags;  // backwards, split << 8, high << 16
  float fade;
};

struct Instance {
  vec4 camera_from_tree[3];  // rows; lengths in the tree's own metres, from the middle of its cube
  vec4 eye;                  // same frame; w: scale
  ivec4 eye_cell;            // w: tree
  vec4 tint;
  vec4 sway;  // of the tree's top, camera's axes, the tree's own metres
};

layout(std430, binding = 6) readonly buffer Ranges { Range ranges[]; };
layout(std430, binding = 7) readonly buffer Instances { Instance instances[]; };
layout(std430, binding = 8) writeonly buffer Records { Record records[]; };

Range range_of(uint cell) {
  uint low = 0u, high = range_count;
  while (high - low > 1u) {
    uint middle = (low + high) / 2u;
    if (ranges[middle].start <= cell)
      low = middle;
    else
      high = middle;
  }
  return ranges[low];
}

Level level_of(Tree tree, uint cell) {
  uint slot = tree.first_level + tree.level_count - 1u;
  while (slot > tree.first_level && levels[slot].first_cell > cell) --slot;
  return levels[slot];
}

bool in_half(Range range, uvec3 cell, Level level, ivec3 eye_cell, int finest_level) {
  ivec3 corner = ivec3(cell) << max(finest_level - level.level, 0);
  for (int axis = 0; axis < 3; ++axis) {
    if ((range.flags >> (8 + axis) & 1u) == 0u) continue;
    if ((corner[axis] > eye_cell[axis]) != ((range.flags >> (16 + axis) & 1u) != 0u)) return false;
  }
  return true;
}

struct Blend {
  uint a, b;
  float weight_b;
};

float inverse_angle(uint view, vec3 centre, vec3 to_eye) {
  vec3 to_view = views[view].xyz - centre;
  // Unlike the arc cosine this keeps small angles
  return 1.0 / max(atan(length(cross(to_view, to_eye)), dot(to_view, to_eye)), 1e-9);
}

// ViewPicker::pick; views counted within the level.
Blend pick_views(Level level, vec3 centre, vec3 to_eye) {
  uvec3 nearest = uvec3(level.view_count);
  vec3 best = vec3(-3.4e38);
  for (uint view = 0u; view < level.view_count; ++view) {
    vec3 to_view = views[level.first_view + view].xyz - centre;
    float cosine = dot(to_view, to_eye) / sqrt(dot(to_view, to_view) + 1e-30);
    if (cosine > best.x) {
      best = vec3(cosine, best.xy);
      nearest = uvec3(view, nearest.xy);
    } else if (cosine > best.y) {
      best.yz = vec2(cosine, best.y);
      nearest.yz = uvec2(view, nearest.y);
    } else if (cosine > best.z) {
      best.z = cosine;
      nearest.z = view;
    }
  }
  if (nearest.y >= level.view_count) return Blend(nearest.x, nearest.x, 0.0);
  vec2 share = vec2(inverse_angle(level.first_view + nearest.x, centre, to_eye),
                    inverse_angle(level.first_view + nearest.y, centre, to_eye));
  if (blend_rule == kFading && nearest.z < level.view_count)
    share = max(share - inverse_angle(level.first_view + nearest.z, centre, to_eye), 0.0);
  float sum = share.x + share.y;
  return Blend(nearest.x, nearest.y, sum > 0.0 ? share.y / sum : 0.0);
}

bool is_pruned(uint first_pair, uint blocks) {
  for (uint block = 0u; block < blocks; ++block)
    if ((pairs[first_pair + block] & 0xffffu) != kPruned) return false;
  return true;
}

vec3 false_colour(uint number) {
  uint hash = number * 0x9e3779b9u;
  hash = (hash ^ (hash >> 15)) * 0x85ebca6bu;
  hash ^= hash >> 13;
  return 0.25 + 0.75 * vec3(hash & 255u, hash >> 8 & 255u, hash >> 16 & 255u) / 255.0;
}

// Fixed, so that a level keeps its colour from tree to tree; neighbours differ clearly.
vec3 level_colour(int level) {
  const vec3 colours[6] = vec3[](vec3(0.90, 0.30, 0.25), vec3(0.95, 0.65, 0.15),
                                 vec3(0.85, 0.85, 0.25), vec3(0.30, 0.75, 0.35),
                                 vec3(0.25, 0.60, 0.90), vec3(0.65, 0.40, 0.85));
  return colours[level % 6];
}

// Textures and colours of the record; kind 0 where there is nothing to draw.
void choose_textures(Level level, uint cell, vec3 centre, vec3 to_eye, uint layer, vec3 tint,
                     inout Record record) {
  Blend blend = pick_views(level, centre, to_eye);
  if (blend.a >= level.view_count) return;
  uint blocks = uint(level.texels / 4) * uint(level.texels / 4);
  uint first = level.first_pair + (cell - level.first_cell) * level.view_count * blocks;
  record.first_pair_a = first + blend.a * blocks;
  record.first_pair_b = first + blend.b * blocks;
  record.weight_b = blend.weight_b;
  bool no_a = is_pruned(record.first_pair_a, blocks);
  bool no_b = blend.b == blend.a ? no_a : is_pruned(record.first_pair_b, blocks);
  if (no_a) record.first_pair_a = record.first_pair_b;
  if (no_a || no_b) record.weight_b = 0.0;
  record.kind = uint(level.texels) | layer << 8;
  record.tint = vec4(colours == kLevels  ? level_colour(level.level)
                     : colours == kCells ? false_colour(cell)
                                         : tint,
                     1.0);
  if (colours == kPrunedCells) {
    record.tint.rgb = no_a || no_b ? vec3(0.95, 0.6, 0.1) : vec3(0.55);
    if (no_a && no_b) record.tint = vec4(0.9, 0.1, 0.1, 0.25);
    if (no_a && no_b) record.kind |= kSolid;
  } else if (no_a && no_b) {
    record.kind = 0u;
  }
}

// Unit axes of the square that faces the eye, as billboard_geometry.h: columns right and up.
mat2x3 billboard_axes(vec3 from_eye) {
  vec3 forward = normalize(from_eye);
  float horizontal = length(forward.xy);
  vec3 right = vec3(1.0, 0.0, 0.0);
  if (horizontal > 1e-6) right = vec3(forward.y, -forward.x, 0.0) / horizontal;
  return mat2x3(right, cross(right, forward));
}

// Whether the splat comes near the picture, as Projector in reference.cpp; false also for numbers
// that are not finite.
bool reaches_picture(Record record, float half_m, float depth) {
  vec2 outside = max(-0.5 - record.centre_px, record.centre_px - (picture_px - 0.5));
  vec2 extent = abs(record.across_px) + abs(record.down_px);
  return all(lessThan(outside, vec2(8.0 * widest_focal_px * half_m / depth))) &&
         all(lessThan(outside, extent)) && all(lessThan(extent, vec2(1e5)));
}

void place(Level level, Instance instance, Tree tree, vec3 centre, inout Record record) {
  vec3 centre_in_camera;
  mat3 camera_from_tree;  // rotation
  for (int row = 0; row < 3; ++row) {
    vec4 m = instance.camera_from_tree[row];
    centre_in_camera[row] = dot(m.xyz, centre) + m.w;
    for (int column = 0; column < 3; ++column) camera_from_tree[column][row] = m[column];
  }
  if (wind > 0.0) {
    float height = max((centre.z + tree.foot_m) * tree.inverse_height, 0.0);
    centre_in_camera += instance.sway.xyz * (height * height);
  }
  Seen seen = seen_through_lens(centre_in_camera);
  mat2x3 axes = billboard_axes(centre - instance.eye.xyz);
  record.centre_px = seen.pixel;
  record.across_px = seen.derivative * (camera_from_tree * axes[0]) * level.half_m;
  record.down_px = seen.derivative * (camera_from_tree * axes[1]) * -level.half_m;
  // Nearer than the near plane it is still drawn, in front of all else
  float depth_m = max(centre_in_camera.z * instance.eye.w, near_m);
  record.depth_ndc = 1.0 - 2.0 * near_m / depth_m;
  if (!seen.inside || !reaches_picture(record, level.half_m, centre_in_camera.z)) record.kind = 0u;
}

void main() {
  if (gl_GlobalInvocationID.x >= cell_count) return;
  uint position = first_cell + gl_GlobalInvocationID.x;
  Range range = range_of(position);
  Instance instance = instances[range.instance];
  Tree tree = trees[instance.eye_cell.w];
  uint entry = position - range.start;
  entry = (range.flags & 1u) != 0u ? range.first - entry : range.first + entry;
  uint cell = order_table[tree.first_order + entry];
  Level level = level_of(tree, cell);
  uvec3 coordinates = cell_coordinates(cell);
  vec3 centre = tree.corner_m + (vec3(coordinates) + 0.5) * level.cell_m;

  Record record;
  record.kind = 0u;
  record.fade = range.fade;
  vec3 to_eye = instance.eye.xyz - centre;
  bool faces_eye = dot(to_eye, to_eye) > level.half_m * level.half_m;
  if (faces_eye && in_half(range, coordinates, level, instance.eye_cell.xyz, tree.finest_level))
    choose_textures(level, cell, centre, to_eye, tree.layer, instance.tint.rgb, record);
  if (record.kind != 0u) place(level, instance, tree, centre, record);
  records[gl_GlobalInvocationID.x] = record;
}
