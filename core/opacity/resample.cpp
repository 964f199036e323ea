#include "core/opacity/resample.h"

#include <tbb/parallel_for.h>

#include "core/opacity/ray_cache.h"

namespace bosk {

namespace {

// Interpolates; `mean` divides by the present corners' weights.
std::vector<float> interpolated(const SparseGrid& coarser, const std::vector<float>& values,
                                std::size_t stride, const SparseGrid& finer, bool mean,
                                const Progress& progress) {
  std::vector<float> result(finer.size() * stride, 0.0f);
  const auto& cells = finer.cells();
  tbb::parallel_for(std::size_t(0), cells.size(), [&](std::size_t n) {
    progress.check();
    const glm::vec3 at = (glm::vec3(cells[n]) + 0.5f) * 0.5f - 0.5f;
    const glm::vec3 base = glm::floor(at);
    float weights[8], present = 0.0f;
    trilinear_weights(at - base, weights);
    float* value = &result[n * stride];
    for (int i = 0; i < 8; ++i) {
      const glm::ivec3 c = glm::ivec3(base) + glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
      const std::int32_t number = coarser.find(c.x, c.y, c.z);
      if (number < 0) continue;
      present += weights[i];
      for (std::size_t k = 0; k < stride; ++k) {
        value[k] += weights[i] * values[std::size_t(number) * stride + k];
      }
    }
    if (!mean || present <= 0.0f) return;
    for (std::size_t k = 0; k < stride; ++k) value[k] /= present;
  });
  return result;
}

}  // namespace

std::vector<float> refined_mean(const SparseGrid& coarser, const std::vector<float>& values,
                                std::size_t stride, const SparseGrid& finer,
                                const Progress& progress) {
  return interpolated(coarser, values, stride, finer, true, progress);
}

std::vector<float> refined_extinction(const SparseGrid& coarser,
                                      const std::vector<float>& extinction, const SparseGrid& finer,
                                      const Progress& progress) {
  std::vector<float> result = interpolated(coarser, extinction, 1, finer, false, progress);
  for (float& value : result) value *= 0.5f;
  return result;
}

void write(BinaryWriter& writer, const SparseGrid& grid) {
  writer.value(grid.level());
  writer.array(grid.cells());
}

SparseGrid read_sparse_grid(BinaryReader& reader) {
  const int level = reader.value<int>();
  const std::vector<glm::u16vec3> cells = reader.array<glm::u16vec3>();
  if (level < 2 || level > 10) throw Error("stored grid is inconsistent");
  std::vector<glm::ivec3> wide;
  for (const glm::u16vec3& cell : cells) {
    if (glm::any(glm::greaterThanEqual(glm::ivec3(cell), glm::ivec3(1 << level)))) {
      throw Error("stored grid is inconsistent");
    }
    wide.emplace_back(cell);
  }
  return SparseGrid(level, wide);
}

}  // namespace bosk
