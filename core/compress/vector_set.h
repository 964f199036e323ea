#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace bosk {

// Vectors to be coded. A vector has `groups` weights and groups * channels values: a weight says
// how much the values of its group count. Colour blocks are 16 groups (texels) of 3 channels, alpha
// blocks one group of 16 channels. The distance of a vector x to a codeword c is
//   sum over groups g of weight[g] * sum over channels of (x[g] - c[g])^2.
struct VectorSet {
  std::size_t groups = 1, channels = 1;
  std::vector<float> values, weights;

  std::size_t size() const { return weights.size() / groups; }
  std::size_t dimension() const { return groups * channels; }
  std::span<const float> value_row(std::size_t vector) const {
    return {values.data() + vector * dimension(), dimension()};
  }
  std::span<const float> weight_row(std::size_t vector) const {
    return {weights.data() + vector * groups, groups};
  }
};

}  // namespace bosk
