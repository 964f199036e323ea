#include "core/billboard/billboard.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "core/base/error.h"
#include "core/billboard/bake.h"
#include "core/billboard/coarser.h"
#include "core/billboard/morton.h"
#include "core/billboard/view_choice.h"
#include "core/billboard/visibility.h"

namespace bosk {
namespace {

constexpr double kBakingShare = 0.7;  // of a level's time, beside pruning: for the progress
constexpr int kLevelsOfCube = 5;      // a cube is baked from a volume with 2^5 cells along its edge
constexpr float kCubeSide =
    1.5f;  // a cube seen from any side up to 30 degrees above fits the square

Box crown_of(const RadianceVolume& volume) {
  glm::ivec3 lower(std::numeric_limits<int>::max()), upper(0);
  for (const glm::u16vec3& cell : volume.grid.cells()) {
    lower = glm::min(lower, glm::ivec3(cell));
    upper = glm::max(upper, glm::ivec3(cell) + 1);
  }
  return {volume.origin + glm::dvec3(lower) * volume.cell_m(),
          volume.origin + glm::dvec3(upper) * volume.cell_m()};
}

// Cells of `level` whose cubes any cell's kernel reaches, as ascending Morton codes.
std::vector<std::uint64_t> parents(const SparseGrid& grid, int level) {
  const int shift = grid.level() - level;
  std::vector<std::uint64_t> codes;
  for (const glm::u16vec3& cell : grid.cells()) {
    codes.push_back(morton_from_cell(glm::ivec3(cell)) >> (3 * shift));
  }
  std::sort(codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
  return codes;
}

void clear_billboard(BillboardLevel& level, std::size_t cell, std::size_t view) {
  const std::size_t size = level.texture_size();
  const auto first =
      level.texture.begin() + std::ptrdiff_t((cell * level.views.size() + view) * size);
  std::fill(first, first + std::ptrdiff_t(size), glm::u8vec4(0));
}

// Clears the textures that no one would miss: hidden from their view by the rest of the crown, or
// next to clear themselves.
void prune_views(const RadianceVolume& volume, const std::vector<glm::dvec3>& positions,
                 double prune, BillboardLevel& level, Progress& progress) {
  std::vector<glm::dvec3> views;
  for (const std::uint32_t view : level.views) views.push_back(positions[view]);
  const std::vector<float> reach =
      transmittance_to_views(volume, level.level, level.cells, views, progress);
  const std::size_t size = level.texture_size();
  for (std::size_t i = 0; i < level.cells.size() * views.size(); ++i) {
    int opacity = 0;
    for (std::size_t t = 0; t < size; ++t) {
      opacity = std::max(opacity, int(level.texture[i * size + t].a));
    }
    if (double(reach[i]) * opacity / 255.0 < prune) {
      clear_billboard(level, i / views.size(), i % views.size());
    }
  }
}

// Drops finest cells that are hidden from every direction.
RadianceVolume without_hidden(const RadianceVolume& volume, const std::vector<glm::dvec3>& views,
                              double prune, Progress& progress) {
  const int level = std::min(volume.grid.level(), 6);
  const std::vector<std::uint64_t> blocks = parents(volume.grid, level);
  const std::vector<float> reach = transmittance_to_views(volume, level, blocks, views, progress);
  std::vector<float> best(blocks.size(), 0.0f);
  for (std::size_t i = 0; i < reach.size(); ++i) {
    best[i / views.size()] = std::max(best[i / views.size()], reach[i]);
  }
  const int shift = volume.grid.level() - level;
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < volume.grid.size(); ++i) {
    progress.check();
    const std::uint64_t block = morton_from_cell(glm::ivec3(volume.grid.cells()[i])) >> (3 * shift);
    const auto at = std::lower_bound(blocks.begin(), blocks.end(), block) - blocks.begin();
    const float alpha = 1.0f - std::exp(-volume.extinction[i]);
    if (double(best[std::size_t(at)] * alpha) >= prune) kept.push_back(std::uint32_t(i));
  }
  return subset(volume, kept, progress);
}

std::vector<std::uint32_t> all_of(const std::vector<glm::dvec3>& views) {
  std::vector<std::uint32_t> all(views.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

// Textures towards all views, baked from `source`: `volume` or a coarser one.
BillboardLevel cubes_of(const RadianceVolume& volume, const RadianceVolume& source, int number,
                        const std::vector<glm::dvec3>& views, const BillboardOptions& options,
                        Progress& progress) {
  BillboardLevel level;
  level.level = number;
  level.texels = options.texels <= 4 ? 4 : 8;
  level.side_factor = kCubeSide;
  level.views = all_of(views);
  level.cells = parents(volume.grid, number);
  std::optional<ProgressPart> part(std::in_place, progress, 0.0, kBakingShare);
  bake_cubes(source, VolumeSampler(source), views, level, progress);
  part.emplace(progress, kBakingShare, 1.0);
  prune_views(volume, views, options.prune, level, progress);
  return level;
}

// One kernel a cell; towards all views only where colour depends on the view.
BillboardLevel kernels_of(const RadianceVolume& volume, const std::vector<glm::dvec3>& views,
                          Progress& progress) {
  BillboardLevel level;
  level.level = volume.grid.level();
  level.views = volume.degree == 0 ? std::vector<std::uint32_t>{0} : all_of(views);
  bake_kernels(volume, views, level, progress);
  return level;
}

}  // namespace

Options describe(BillboardOptions& options) {
  return {
      {"coarsest_level",
       "",
       "octree level of the coarsest billboards",
       &options.coarsest_level,
       0,
       7,
       {}},
      {"views", "", "directions that coarse levels have textures for", &options.views, 1, 64, {}},
      {"texels",
       "",
       "texels along the edge of a coarse billboard: 4 or 8",
       &options.texels,
       4,
       8,
       {}},
      {"kernel_levels",
       "",
       "finest levels drawn as one soft kernel a cell, the same from all sides",
       &options.kernel_levels,
       1,
       6,
       {}},
      {"prune",
       "",
       "a billboard is dropped when less than this share of light shows it",
       &options.prune,
       0.0,
       0.5,
       {}},
  };
}

Billboards bake_billboards(const RadianceVolume& volume, const std::vector<Camera>& cameras,
                           const BillboardOptions& options, Progress& progress) {
  if (volume.grid.size() == 0) {
    throw Error("the volume is empty: check the mattes, nothing in the photos is opaque");
  }
  Billboards result{volume.origin, volume.size_m, {}, {}};
  result.view_positions = hemisphere_views(cameras, crown_of(volume), options.views);

  const int finest = volume.grid.level();
  const int coarsest = std::min(options.coarsest_level, finest);
  const int first_kernels = std::max(coarsest, finest + 1 - options.kernel_levels);
  const double level_share = 1.0 / (finest - coarsest + 2);  // hidden cells count as one
  std::optional<ProgressPart> part(std::in_place, progress, 0.0, level_share);
  const RadianceVolume visible =
      without_hidden(volume, result.view_positions, options.prune, progress);
  const auto begin_level = [&](int level) {
    const double start = level_share * (level - coarsest + 1);
    part.emplace(progress, start, start + level_share);
  };
  std::vector<RadianceVolume> volumes(1, visible);  // fine to coarse
  while (volumes.back().grid.level() > std::min(first_kernels, coarsest + kLevelsOfCube))
    volumes.push_back(coarser_volume(volumes.back()));
  const auto volume_of = [&](int level) -> const RadianceVolume& {
    return volumes[std::size_t(finest - std::min(level, finest))];
  };
  for (int level = coarsest; level < first_kernels; ++level) {
    begin_level(level);
    result.levels.push_back(cubes_of(visible, volume_of(level + kLevelsOfCube), level,
                                     result.view_positions, options, progress));
  }
  for (int level = first_kernels; level <= finest; ++level) {
    begin_level(level);
    result.levels.push_back(kernels_of(volume_of(level), result.view_positions, progress));
  }
  return result;
}

void write(BinaryWriter& writer, const Billboards& billboards) {
  writer.value(billboards.origin);
  writer.value(billboards.size_m);
  writer.array(billboards.view_positions);
  writer.value(std::uint64_t(billboards.levels.size()));
  for (const BillboardLevel& level : billboards.levels) {
    writer.value(level.level);
    writer.value(level.texels);
    writer.value(level.side_factor);
    writer.value(level.max_cell_px);
    writer.array(level.views);
    writer.array(level.cells);
    writer.array(level.texture);
  }
}

Billboards read_billboards(BinaryReader& reader) {
  Billboards billboards;
  billboards.origin = reader.value<glm::dvec3>();
  billboards.size_m = reader.value<double>();
  billboards.view_positions = reader.array<glm::dvec3>();
  const auto count = reader.value<std::uint64_t>();
  if (count > 16) throw Error("stored billboards are inconsistent");
  for (std::uint64_t i = 0; i < count; ++i) {
    BillboardLevel level;
    level.level = reader.value<int>();
    level.texels = reader.value<int>();
    level.side_factor = reader.value<float>();
    level.max_cell_px = reader.value<float>();
    level.views = reader.array<std::uint32_t>();
    level.cells = reader.array<std::uint64_t>();
    level.texture = reader.array<glm::u8vec4>();
    const std::size_t expected = level.cells.size() * level.views.size() * level.texture_size();
    if (level.texture.size() != expected) throw Error("stored billboards are inconsistent");
    billboards.levels.push_back(std::move(level));
  }
  return billboards;
}

}  // namespace bosk
