// What was uploaded of the trees, all in one set of buffers; core/render/gl/gpu_trees.h.
struct Tree {
  uint first_level, level_count;
  uint first_order;  // of its order table
  uint layer;        // of the atlas array
  float corner_m;    // octree's lower corner from the middle of its cube, on each axis
  float foot_m;      // middle of the cube above the foot
  float inverse_height;
  int finest_level;
};

struct Level {
  uint first_cell, first_pair;  // in `cells`, in `pairs`
  uint first_view, view_count;
  int level, texels;
  float cell_m, half_m;  // sides of a cell, half sides of a billboard
};

layout(std430, binding = 0) readonly buffer Trees { Tree trees[]; };
layout(std430, binding = 1) readonly buffer Levels { Level levels[]; };
layout(std430, binding = 2) readonly buffer OrderTable { uint order_table[]; };
// Coordinates within the level: x from bit 0, y from bit 21, z from bit 42.
layout(std430, binding = 3) readonly buffer Cells { uvec2 cells[]; };
layout(std430, binding = 4) readonly buffer Views { vec4 views[]; };  // from the middle of the cube

uvec3 cell_coordinates(uint cell) {
  uvec2 packed_cell = cells[cell];
  return uvec3(packed_cell.x & 0x1fffffu, (packed_cell.x >> 21) | ((packed_cell.y & 0x3ffu) << 11),
               packed_cell.y >> 10);
}
