#pragma once

#include <vector>

#include "core/base/binary.h"
#include "core/base/progress.h"
#include "core/opacity/sparse_grid.h"

namespace bosk {

// Values of a coarser level (one level up), interpolated at the centres of `finer`'s cells;
// `stride` numbers per cell. The mean is over the present coarse cells alone: for colours, which
// have no zero. Throws Cancelled.
std::vector<float> refined_mean(const SparseGrid& coarser, const std::vector<float>& values,
                                std::size_t stride, const SparseGrid& finer,
                                const Progress& progress);
// The same for extinction per cell edge, which halves with the edge. Absent coarse cells count as
// 0.
std::vector<float> refined_extinction(const SparseGrid& coarser,
                                      const std::vector<float>& extinction, const SparseGrid& finer,
                                      const Progress& progress);

void write(BinaryWriter& writer, const SparseGrid& grid);
SparseGrid read_sparse_grid(BinaryReader& reader);

}  // namespace bosk
