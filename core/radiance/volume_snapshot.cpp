#include "core/radiance/volume_snapshot.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace bosk {
namespace {

constexpr int kBrick = VolumeSnapshot::kBrick, kStored = VolumeSnapshot::kStored;
constexpr float kNothing = 1e-4f;  // extinction per cell: a ray through 100 of them keeps 99 %
constexpr std::size_t kBrickCells = std::size_t(kBrick * kBrick * kBrick);

// What a snapshot is made from; `colour` is null where there is none, else `stride` numbers a cell
// of which the first three are the mean colour.
struct Source {
  const SparseGrid& grid;
  const std::vector<float>& extinction;
  const float* colour = nullptr;
  std::size_t stride = 0;
};

// One brick while it is filled: extinction in w, colour times extinction in xyz.
struct OpenBrick {
  glm::ivec3 at{0};        // among the bricks, shifted by one
  std::uint8_t edges = 0;  // bit m: a cell lies in the first layers along the axes of the set m
  std::array<glm::vec4, kBrickCells> sums{};
};

std::size_t place_of(const VolumeSnapshot& snapshot, const glm::ivec3& brick) {
  const auto across = std::size_t(snapshot.bricks_across());
  return (std::size_t(brick.z) * across + std::size_t(brick.y)) * across + std::size_t(brick.x);
}

OpenBrick& brick_for(const glm::ivec3& at, VolumeSnapshot& snapshot,
                     std::vector<OpenBrick>& bricks) {
  std::int32_t& number = snapshot.brick_at[place_of(snapshot, at)];
  if (number == VolumeSnapshot::kNone) {
    number = std::int32_t(bricks.size());
    bricks.emplace_back().at = at;
  }
  return bricks[std::size_t(number)];
}

// Adds each cell to the one that holds it, `shift` levels up. Extinction per cell edge: each of the
// 2^shift layers a ray crosses has the mean over 4^shift columns.
std::vector<OpenBrick> filled_bricks(const Source& source, int shift, VolumeSnapshot& snapshot) {
  std::vector<OpenBrick> bricks;
  glm::ivec3 lowest(1 << 20), highest(-1);
  const float share = 1.0f / float(1 << (2 * shift));
  const auto& cells = source.grid.cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const glm::ivec3 cell = glm::ivec3(cells[i]) >> shift, inside = cell & (kBrick - 1);
    lowest = glm::min(lowest, cell), highest = glm::max(highest, cell);
    OpenBrick& brick = brick_for(cell / kBrick + 1, snapshot, bricks);
    const int edge = (inside.x == 0) | (inside.y == 0) << 1 | (inside.z == 0) << 2;
    brick.edges = std::uint8_t(brick.edges | 1 << edge);
    const float extinction = source.extinction[i] * share;
    const float* rgb = source.colour ? source.colour + i * source.stride : nullptr;
    const glm::vec3 colour = rgb ? glm::vec3(rgb[0], rgb[1], rgb[2]) : glm::vec3(0.5f);
    const int place = (inside.z * kBrick + inside.y) * kBrick + inside.x;
    brick.sums[std::size_t(place)] += glm::vec4(colour * extinction, extinction);
  }
  const double cell_m = snapshot.size_m / snapshot.side();
  snapshot.bounds = {snapshot.origin, snapshot.origin + snapshot.size_m};
  if (!cells.empty()) {
    snapshot.bounds = {snapshot.origin + glm::dvec3(lowest) * cell_m,
                       snapshot.origin + glm::dvec3(highest + 1) * cell_m};
  }
  return bricks;
}

// Points just below a brick's first layers lie in the brick before it, which may be empty.
void add_bricks_before(VolumeSnapshot& snapshot, std::vector<OpenBrick>& bricks) {
  const std::size_t filled = bricks.size();
  for (std::size_t i = 0; i < filled; ++i) {
    for (int axes = 1; axes < 8; ++axes) {
      bool reached = false;
      for (int edge = 0; edge < 8; ++edge) {
        reached = reached || ((edge & axes) == axes && (bricks[i].edges >> edge & 1) != 0);
      }
      const glm::ivec3 at = bricks[i].at - glm::ivec3(axes & 1, axes >> 1 & 1, axes >> 2);
      if (reached) brick_for(at, snapshot, bricks);
    }
  }
}

VolumeSnapshot::Cell cell_of(const glm::vec4& sum) {
  VolumeSnapshot::Cell cell;
  cell.extinction = sum.w;
  if (sum.w <= 0.0f) return cell;
  const glm::vec3 straight = glm::clamp(glm::vec3(sum) / sum.w, 0.0f, 1.0f);
  cell.srgb = glm::u8vec4(glm::u8vec3(straight * 255.0f + 0.5f), 255);
  return cell;
}

void mark_anything(VolumeSnapshot::Brick& brick) {
  const auto extinction = [&](int x, int y, int z) {
    return brick.cells[std::size_t((z * kStored + y) * kStored + x)].extinction;
  };
  for (int z = 0; z < kBrick; ++z) {
    for (int y = 0; y < kBrick; ++y) {
      for (int x = 0; x < kBrick; ++x) {
        float most = 0.0f;
        for (int i = 0; i < 8; ++i) {
          most = std::max(most, extinction(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2)));
        }
        if (most > kNothing) brick.layers[std::size_t(z)] |= std::uint64_t(1) << (8 * y + x);
      }
    }
  }
}

// The brick's cells and the first layers of the seven bricks behind it.
VolumeSnapshot::Brick closed_brick(const OpenBrick& open, const VolumeSnapshot& snapshot,
                                   const std::vector<OpenBrick>& bricks) {
  std::array<const OpenBrick*, 8> behind{};
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 at = open.at + glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
    if (glm::any(glm::greaterThanEqual(at, glm::ivec3(snapshot.bricks_across())))) continue;
    const std::int32_t number = snapshot.brick_at[place_of(snapshot, at)];
    if (number >= 0) behind[std::size_t(i)] = &bricks[std::size_t(number)];
  }
  VolumeSnapshot::Brick closed{};
  std::size_t place = 0;
  for (int z = 0; z < kStored; ++z) {
    for (int y = 0; y < kStored; ++y) {
      for (int x = 0; x < kStored; ++x, ++place) {
        const int next = x / kBrick | y / kBrick << 1 | z / kBrick << 2;
        const OpenBrick* brick = behind[std::size_t(next)];
        if (!brick) continue;
        const int inside = (z % kBrick * kBrick + y % kBrick) * kBrick + x % kBrick;
        closed.cells[place] = cell_of(brick->sums[std::size_t(inside)]);
      }
    }
  }
  mark_anything(closed);
  return closed;
}

VolumeSnapshot snapshot_from(const Source& source, const glm::dvec3& origin, double size_m,
                             int finest_level) {
  VolumeSnapshot snapshot;
  snapshot.origin = origin;
  snapshot.size_m = size_m;
  snapshot.level = std::min(source.grid.level(), finest_level);
  snapshot.has_colour = source.colour != nullptr;
  snapshot.cells = source.grid.size();
  const auto across = std::size_t(snapshot.bricks_across());
  snapshot.brick_at.assign(across * across * across, VolumeSnapshot::kNone);
  auto bricks = filled_bricks(source, source.grid.level() - snapshot.level, snapshot);
  add_bricks_before(snapshot, bricks);
  snapshot.bricks.resize(bricks.size());
  tbb::parallel_for(std::size_t(0), bricks.size(), [&](std::size_t i) {
    snapshot.bricks[i] = closed_brick(bricks[i], snapshot, bricks);
  });
  return snapshot;
}

}  // namespace

VolumeSnapshot snapshot_of(const OpacityTree& tree, int finest_level) {
  return snapshot_from({tree.grid, tree.extinction}, tree.origin, tree.size_m, finest_level);
}

VolumeSnapshot snapshot_of(const RadianceVolume& volume, int finest_level) {
  const Source source{volume.grid, volume.extinction, volume.colour.data(),
                      std::size_t(volume.coefficients()) * 3};
  return snapshot_from(source, volume.origin, volume.size_m, finest_level);
}

}  // namespace bosk
