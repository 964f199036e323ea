// A billboard on the screen, written by billboard.comp and drawn by billboard.vert.
struct Record {
  vec2 centre_px, across_px, down_px;  // as Splat in core/render/splat.h
  float depth_ndc;
  float fade;
  uint first_pair_a, first_pair_b;
  float weight_b;
  uint kind;  // texels, layer << 8, kSolid; texels 0: nothing
  vec4 tint;
};
const uint kSolid = 0x80u;  // a plain square, no texture
