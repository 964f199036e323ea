#include "core/compress/blocks.h"

#include <algorithm>

namespace bosk {
namespace {

constexpr std::size_t kEdge = 4;

// One over the fourth power of the distance between two texels, [hole][texel].
constexpr auto nearness_table() {
  std::array<std::array<float, 16>, 16> table{};
  for (std::size_t hole = 0; hole < 16; ++hole) {
    for (std::size_t i = 0; i < 16; ++i) {
      const std::size_t row = i / kEdge, hole_row = hole / kEdge;
      const float x = float(i % kEdge) - float(hole % kEdge);
      const float y = float(row) - float(hole_row);
      const float square = std::max(1.0f, x * x + y * y);
      table[hole][i] = 1.0f / (square * square);
    }
  }
  return table;
}
constexpr auto kNearness = nearness_table();

// Mean of the visible texels' colours, by alpha and nearness.
glm::u8vec3 colour_around(const BlockTexels& texels, std::size_t hole) {
  float r = 0.0f, g = 0.0f, b = 0.0f, total = 0.0f;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const float weight = float(texels[i].a) * kNearness[hole][i];
    r += weight * float(texels[i].r);
    g += weight * float(texels[i].g);
    b += weight * float(texels[i].b);
    total += weight;
  }
  return glm::u8vec3(glm::vec3(r, g, b) / total + 0.5f);
}

}  // namespace

std::size_t block_count(const BillboardLevel& level) { return level.texture.size() / 16; }

BlockTexels block_texels(const BillboardLevel& level, std::size_t block) {
  const std::size_t edge = std::size_t(level.texels);
  const std::size_t blocks_across = edge / kEdge;
  const std::size_t blocks_each = blocks_across * blocks_across;
  const std::size_t place = block % blocks_each;
  const std::size_t corner = block / blocks_each * edge * edge +
                             place / blocks_across * kEdge * edge + place % blocks_across * kEdge;
  BlockTexels texels;
  for (std::size_t row = 0; row < kEdge; ++row) {
    const auto start = level.texture.begin() + std::ptrdiff_t(corner + row * edge);
    std::copy_n(start, kEdge, texels.begin() + std::ptrdiff_t(row * kEdge));
  }
  return texels;
}

BlockAlphas block_alphas(const BlockTexels& texels) {
  BlockAlphas alphas{};
  std::transform(texels.begin(), texels.end(), alphas.begin(),
                 [](const glm::u8vec4& texel) { return texel.a; });
  return alphas;
}

bool is_pruned(const BlockTexels& texels) {
  return std::all_of(texels.begin(), texels.end(), [](auto texel) { return texel.a == 0; });
}

bool is_constant(const BlockTexels& texels) {
  const auto visible = [](const glm::u8vec4& texel) { return texel.a > 0; };
  const auto first = std::find_if(texels.begin(), texels.end(), visible);
  return std::all_of(first, texels.end(), [&](const glm::u8vec4& texel) {
    return texel.a == 0 || glm::u8vec3(texel) == glm::u8vec3(*first);
  });
}

ColourBlock colour_block(const BlockTexels& texels) {
  ColourBlock block{{}, block_alphas(texels)};
  if (is_pruned(texels)) return block;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    block.srgb[i] = texels[i].a > 0 ? glm::u8vec3(texels[i]) : colour_around(texels, i);
  }
  if (is_constant(texels)) block.alpha.fill(255);
  return block;
}

KindSample sample_kinds(const DistinctBlocks& blocks, std::size_t limit) {
  KindSample sample;
  const std::size_t kinds = blocks.first_block.size();
  if (kinds <= limit) {
    for (std::uint32_t kind = 0; kind < kinds; ++kind) sample.kinds.push_back(kind);
    sample.weights = blocks.weight;
    return sample;
  }
  double total = 0.0;
  for (const float weight : blocks.weight) total += double(weight);
  const double step = total / double(limit);
  double passed = 0.0;
  std::size_t met = 0;  // marks at (i + 0.5) * step that lie behind
  for (std::uint32_t kind = 0; kind < kinds; ++kind) {
    passed += double(blocks.weight[kind]);
    const auto marks = std::size_t(std::max(0.0, passed / step + 0.5));
    if (marks <= met) continue;
    sample.kinds.push_back(kind);
    sample.weights.push_back(float(double(marks - met) * step));
    met = marks;
  }
  return sample;
}

}  // namespace bosk
