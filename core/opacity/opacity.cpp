#include "core/opacity/opacity.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/opacity/em_solver.h"
#include "core/opacity/hull.h"
#include "core/opacity/ray_cache.h"
#include "core/opacity/resample.h"

namespace bosk {
namespace {

constexpr float kSilhouetteAlpha = 0.0f;  // any opacity keeps a cell in the hull
constexpr int kCoarsestLevel = 5;
constexpr int kFinestLevel = 9;   // 512 cells a side
constexpr int kFinestChosen = 8;  // unless asked for: leaves one level to radiance
constexpr int kCountedLevel = 7;  // this and the one above tell how the hull's cells grow in number
constexpr double kRaysAcrossCell =
    1.25;  // pixels averaged so that about this many cross a cell: more gave no better start
constexpr double kCrownShare = 0.05, kCastingShare = 0.4;  // of the time, for the progress
constexpr float kFirstExtinction = 0.15f;  // of the coarsest level's cells, per cell edge

std::vector<Silhouette> silhouettes_of(const Photos& photos, const Mattes& mattes) {
  if (photos.size() != mattes.size() || photos.size() < 2) {
    throw Error("opacity needs at least 2 photos with mattes, " + std::to_string(mattes.size()) +
                " given: add photos from other sides of the tree");
  }
  std::vector<Silhouette> silhouettes;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    silhouettes.emplace_back(photos[i].camera, mattes[i].rgba, kSilhouetteAlpha);
    if (silhouettes.back().pixels_above() == 0) {
      throw Error("the matte of photo " + photos[i].name +
                  " is clear everywhere: mark the tree in it, or leave the photo out");
    }
  }
  return silhouettes;
}

// Median over the photos of the size in pixels of one metre at the crown's centre.
double pixels_per_metre(const Photos& photos, const Cube& crown) {
  const glm::dvec3 centre = crown.origin + 0.5 * crown.size_m;
  std::vector<double> sizes;
  for (const Photo& photo : photos) {
    const double distance = glm::length(photo.camera.centre_in_world() - centre);
    sizes.push_back(photo.camera.lens.focal_px.x / std::max(distance, 1e-9));
  }
  std::nth_element(sizes.begin(), sizes.begin() + std::ptrdiff_t(sizes.size() / 2), sizes.end());
  return sizes[sizes.size() / 2];
}

// The cube around the tree and its finest level: as many levels as cells of `cell_px` ask for, and
// the cube grown about its centre until the finest have just that size. Cells outside the tree cost
// nothing, so the growth is free.
struct Frame {
  Cube cube;
  int finest = kCoarsestLevel;
};

std::size_t parent_count(const std::vector<glm::ivec3>& cells, int level) {
  std::vector<std::uint32_t> parents;
  parents.reserve(cells.size());
  for (const glm::ivec3& cell : cells) {
    const glm::uvec3 parent = glm::uvec3(cell) / 2u;
    parents.push_back((((parent.z << (level - 1)) + parent.y) << (level - 1)) + parent.x);
  }
  std::sort(parents.begin(), parents.end());
  return std::size_t(std::unique(parents.begin(), parents.end()) - parents.begin());
}

// Cells across the crown with which the hull holds about `most` cells: the hull's count at two
// levels gives the power of the edge that it grows with (3 for a solid, near 2 for thin branches).
double cells_across_for(double most, const std::vector<Silhouette>& silhouettes, const Cube& crown,
                        Progress& progress) {
  const std::vector<glm::ivec3> cells = carve_hull(silhouettes, crown, kCountedLevel, progress);
  const auto fine = double(std::max<std::size_t>(cells.size(), 1));
  const auto coarse = double(std::max<std::size_t>(parent_count(cells, kCountedLevel), 1));
  const double power = std::clamp(std::log2(fine / coarse), 1.0, 3.0);
  return double(1 << kCountedLevel) * std::pow(most / fine, 1.0 / power);
}

Frame frame_of(const Cube& crown, double cells, int finest_level) {
  if (finest_level > 0) return {crown, finest_level};
  const int finest = std::clamp(int(std::ceil(std::log2(cells))), kCoarsestLevel, kFinestChosen);
  const double growth = std::clamp(double(1 << finest) / cells, 1.0, 2.0);
  return {{crown.origin - 0.5 * (growth - 1.0) * crown.size_m, growth * crown.size_m}, finest};
}

int pixel_step(double cell_px) { return std::max(1, int(std::floor(cell_px / kRaysAcrossCell))); }

// Share of the time behind when a level is done: each takes about four times the one before.
double share_up_to(int level, int finest) { return std::pow(4.0, level - finest); }

OpacityTree start_level(const OpacityTree& coarser, const std::vector<Silhouette>& silhouettes,
                        const Cube& crown, int level, Progress& progress) {
  OpacityTree tree{crown.origin,
                   crown.size_m,
                   SparseGrid(level, carve_hull(silhouettes, crown, level, progress)),
                   {}};
  if (coarser.extinction.empty()) {
    tree.extinction.assign(tree.grid.size(), kFirstExtinction);
  } else {
    tree.extinction = refined_extinction(coarser.grid, coarser.extinction, tree.grid, progress);
  }
  return tree;
}

// Counts iterations over all levels, tells the watcher, and says whether to go on.
class Iterations {
 public:
  Iterations(const OpacityOptions& options, int levels, const Photos& photos, const Mattes& mattes,
             const OpacityWatcher& watcher)
      : stop_after_(options.stop_after),
        planned_(levels * options.passes),
        photos_(photos),
        mattes_(mattes),
        watcher_(watcher) {
    if (stop_after_ > 0) planned_ = std::min(planned_, stop_after_);
  }

  bool go_on(const OpacityTree& tree, double mean_error) {
    ++iteration_;
    const bool wanted =
        !watcher_ || watcher_({tree, iteration_, planned_, mean_error, photos_, mattes_});
    return wanted && iteration_ != stop_after_;
  }

 private:
  int stop_after_ = 0, planned_ = 0, iteration_ = 0;
  const Photos& photos_;
  const Mattes& mattes_;
  const OpacityWatcher& watcher_;
};

// The passes of one level; whether to go on with the next.
bool solve_level(const RayCache& cache, const TrilinearSupport& support,
                 const OpacityOptions& options, OpacityTree& tree, Iterations& iterations,
                 Progress& progress) {
  double last_error = 2.0;
  for (int pass = 0; pass < options.passes; ++pass) {
    progress.begin("Opacity, level " + std::to_string(tree.level()), cache.tiles(),
                   double(pass) / options.passes, double(pass + 1) / options.passes);
    const double error = em_pass(cache, support, options.subsets, tree.extinction, progress);
    if (!iterations.go_on(tree, error)) return false;
    if (error > last_error) break;  // more passes would only fit noise
    last_error = error;
  }
  return true;
}

}  // namespace

Options describe(OpacityOptions& options) {
  return {
      {"finest_level",
       "",
       "octree level of the finest cells, 2^level a side; 0 chooses it by cell_px",
       &options.finest_level,
       0,
       kFinestLevel,
       {}},
      {"cell_px",
       "px",
       "size of the finest cells in the photos, at most 256 cells across; smaller is sharper, "
       "slower and bigger",
       &options.cell_px,
       1.0,
       100.0,
       {}},
      {"max_cells",
       "thousand",
       "cells, about, that may hold something: they are made larger where a dense tree would need "
       "more; 0 is any number",
       &options.max_cells,
       0.0,
       1e6,
       {}},
      {"passes",
       "",
       "passes of the solver over all rays at each level",
       &options.passes,
       1,
       20,
       {}},
      {"subsets",
       "",
       "updates per pass, each from its share of the pixels",
       &options.subsets,
       1,
       64,
       {}},
      {"stop_after",
       "",
       "ends after so many passes, counted over all levels, and keeps what there is; 0 is never",
       &options.stop_after,
       0,
       1000,
       {}},
  };
}

OpacityTree estimate_opacity(const Photos& photos, const Mattes& mattes,
                             const OpacityOptions& options, Progress& progress,
                             const OpacityWatcher& watcher) {
  const std::vector<Silhouette> silhouettes = silhouettes_of(photos, mattes);
  std::optional<ProgressPart> part(std::in_place, progress, 0.0, kCrownShare);
  const Cube box = find_crown(silhouettes, progress);
  const double px_per_metre = pixels_per_metre(photos, box);
  double cells_across = box.size_m * px_per_metre / options.cell_px;
  if (options.max_cells > 0.0) {
    const double most = 1e3 * options.max_cells;
    cells_across = std::min(cells_across, cells_across_for(most, silhouettes, box, progress));
  }
  const auto [crown, finest] = frame_of(box, cells_across, options.finest_level);
  const double crown_px = crown.size_m * px_per_metre;

  OpacityTree tree;
  const int coarsest = std::min(kCoarsestLevel, finest);
  Iterations iterations(options, finest - coarsest + 1, photos, mattes, watcher);
  for (int level = coarsest; level <= finest; ++level) {
    const double end = std::max(kCrownShare, share_up_to(level, finest));
    const double start = std::max(kCrownShare, share_up_to(level - 1, finest));
    part.emplace(progress, start, start + kCastingShare * (end - start));
    tree = start_level(tree, silhouettes, crown, level, progress);
    const TrilinearSupport support(tree.grid);
    const int step = pixel_step(crown_px / double(1 << level));
    const RayCache cache = cache_rays(photos, mattes, step, crown, level, support, progress);
    part.emplace(progress, start + kCastingShare * (end - start), end);
    if (!solve_level(cache, support, options, tree, iterations, progress)) break;
  }
  return tree;
}

void write(BinaryWriter& writer, const OpacityTree& tree) {
  writer.value(tree.origin);
  writer.value(tree.size_m);
  write(writer, tree.grid);
  writer.array(tree.extinction);
}

OpacityTree read_opacity_tree(BinaryReader& reader) {
  OpacityTree tree;
  tree.origin = reader.value<glm::dvec3>();
  tree.size_m = reader.value<double>();
  tree.grid = read_sparse_grid(reader);
  tree.extinction = reader.array<float>();
  if (tree.extinction.size() != tree.grid.size()) throw Error("stored opacity is inconsistent");
  return tree;
}

}  // namespace bosk
