// One frame's constants; FrameBlock in core/render/gl/forest_renderer.cpp.
layout(std140, binding = 0) uniform Frame {
  vec2 focal_px, principal_px;
  vec4 distortion_low, distortion_high;  // Lens::distortion
  vec2 picture_px;
  float fold;      // beyond it the lens model folds over: radius squared, or angle from the axis
  int lens_model;  // kStraight, kOpencv, kFisheye
  int blend_rule;  // kLinear, kFading
  int colours;     // kTree ...
  uint range_count;
  uint first_cell;  // of this batch, counted through all ranges
  uint cell_count;  // of this batch
  float near_m;     // gl_camera.h
  float wind;       // 0: still
  float widest_focal_px;
};

const int kStraight = 0, kOpencv = 1, kFisheye = 2;
const int kLinear = 0, kFading = 1;
const int kTree = 0, kLevels = 1, kCells = 2, kPrunedCells = 3;
