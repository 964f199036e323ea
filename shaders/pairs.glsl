// Places of an alpha and a colour codeword in the atlas, 16 bits each: column and row of the tile, 7
// bits each. [cell][view][block row][block column].
layout(std430, binding = 5) readonly buffer Pairs { uint pairs[]; };
const uint kPruned = 0xffffu;
const uint kOutside = 0xfffeu;  // draws nothing either, but wasn't pruned
