#include "core/render/scatter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/render/billboard_geometry.h"
#include "core/render/disc_filling.h"

namespace bosk {
namespace {

constexpr std::size_t kMostCandidates = 4'000'000;
// Discs of radius r fill a plane with about 0.7 / (2 r)^2 of them per square metre.
constexpr double kFilling = 0.7;
constexpr double kLeastCrown = 0.05;  // metres; a tree without cells stands somewhere too

double mean_of(const Image<float>& density) {
  if (density.empty()) return 1.0;
  double sum = 0.0;
  for (const float value : density.pixels()) sum += double(std::clamp(value, 0.0f, 1.0f));
  return sum / double(density.size());
}

// Of the map's pixel at a place in the area, whose middle is (0, 0).
double density_at(const Image<float>& density, const glm::dvec2& area, const glm::dvec2& place) {
  if (density.empty()) return 1.0;
  const auto pixel = [](double share, int count) {
    return std::clamp(int(share * count), 0, count - 1);
  };
  const int x = pixel(place.x / area.x + 0.5, density.width());
  const int y = pixel(0.5 - place.y / area.y, density.height());
  return double(density(x, y));
}

// What a trunk's disc may be. `looseness` makes all of them larger than they need to be.
struct Kinds {
  std::span<const double> crown_radii;
  double smallest_scale, largest_scale, spacing, looseness = 1.0;

  double radius(std::size_t kind, double scale) const {
    return looseness * spacing * scale * std::max(kLeastCrown, crown_radii[kind]);
  }
  Disc operator()(Random& random) const {
    Disc disc;
    disc.kind = std::uint32_t(random.below(crown_radii.size()));
    disc.scale = random.uniform(smallest_scale, largest_scale);
    disc.radius = radius(disc.kind, disc.scale);
    return disc;
  }
  double largest_radius() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < crown_radii.size(); ++i) {
      largest = std::max(largest, radius(i, largest_scale));
    }
    return largest;
  }
  // Of two trees that touch.
  double mean_square_distance() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < crown_radii.size(); ++i) {
      sum += std::pow(2.0 * radius(i, 0.5 * (smallest_scale + largest_scale)), 2);
    }
    return sum / double(crown_radii.size());
  }
};

Kinds kinds_of(std::span<const double> crown_radii, const ScatterOptions& options) {
  return {crown_radii, std::min(options.smallest_scale, options.largest_scale),
          std::max(options.smallest_scale, options.largest_scale), options.spacing};
}

// Those that the density leaves, and of these `wanted` at random.
std::vector<Disc> thinned(std::vector<Disc> discs, const Image<float>& density,
                          const glm::dvec2& area, std::size_t wanted, Random& random) {
  std::erase_if(discs, [&](const Disc& disc) {
    return random.uniform() >= density_at(density, area, disc.centre);
  });
  for (std::size_t i = 0; i < std::min(wanted, discs.size()); ++i) {
    std::swap(discs[i], discs[i + random.below(discs.size() - i)]);
  }
  if (discs.size() > wanted) discs.resize(wanted);
  return discs;
}

[[noreturn]] void refuse_area(const ScatterOptions& options, std::size_t fit) {
  throw Error("only " + std::to_string(fit) + " of " + std::to_string(options.trees) +
              " trees fit into the area: give more area_m, fewer trees or less spacing");
}

// Fills the area with discs as large as still leaves enough of them, at most `looseness` times
// their size; fewer than wanted when they do not fit at their own size.
std::vector<Disc> fill(const glm::dvec2& area, Kinds kinds, double looseness,
                       const Image<float>& density, const ScatterOptions& options) {
  const auto wanted = std::size_t(options.trees);
  for (double factor = std::max(1.0, looseness);; factor = std::max(1.0, 0.96 * factor)) {
    kinds.looseness = factor;
    Random random(std::uint64_t(options.seed));
    std::vector<Disc> discs =
        fill_with_discs(area, kinds, kinds.largest_radius(), kMostCandidates, random);
    discs = thinned(std::move(discs), density, area, wanted, random);
    if (discs.size() == wanted || factor == 1.0) return discs;
  }
}

std::vector<Disc> discs_of(std::span<const double> crown_radii, const Image<float>& density,
                           const ScatterOptions& options) {
  const double share = mean_of(density);
  if (share <= 0.0) {
    throw Error(
        "the density map is black all over, so no tree can stand: paint it grey or white "
        "where trees shall stand");
  }
  const double candidates = double(options.trees) / share;
  if (candidates > 0.5 * double(kMostCandidates)) {
    throw Error("the density map is too dark for " + std::to_string(options.trees) +
                " trees (its mean is " + std::to_string(share) +
                "): paint it lighter or give fewer trees");
  }
  const Kinds kinds = kinds_of(crown_radii, options);
  const double needed_m2 = candidates * kinds.mean_square_distance() / kFilling;
  const double shape = density.empty() ? 1.0 : double(density.height()) / double(density.width());
  if (options.area_m > 0.0) {
    const glm::dvec2 area(options.area_m, options.area_m * shape);
    const double looseness = std::sqrt(area.x * area.y / needed_m2);
    std::vector<Disc> discs = fill(area, kinds, 1.05 * looseness, density, options);
    if (discs.size() < std::size_t(options.trees)) refuse_area(options, discs.size());
    return discs;
  }
  for (double width = std::sqrt(needed_m2 / shape);; width *= 1.04) {
    std::vector<Disc> discs = fill({width, width * shape}, kinds, 1.0, density, options);
    if (discs.size() == std::size_t(options.trees)) return discs;
  }
}

// Around white.
glm::vec3 random_tint(double spread, Random& random) {
  const double light = random.uniform(-spread, spread), warmth = random.uniform(-spread, spread);
  return {1.0 + light + 0.5 * warmth, 1.0 + light, 1.0 + light - 0.5 * warmth};
}

}  // namespace

Options describe(ScatterOptions& o) {
  return {
      {"trees",
       "",
       "trees in the forest, of all packages mixed; 0 shows one of each, side by side",
       &o.trees,
       0,
       1000000,
       {}},
      {"area_m",
       "m",
       "width of the area they stand in; 0 takes the smallest that holds them",
       &o.area_m,
       0,
       1000000,
       {}},
      {"spacing",
       "",
       "least distance between trunks, 1 where crowns just touch",
       &o.spacing,
       0.05,
       100,
       {}},
      {"smallest_scale", "", "of trees, drawn at random", &o.smallest_scale, 0.05, 20, {}},
      {"largest_scale", "", "of trees, drawn at random", &o.largest_scale, 0.05, 20, {}},
      {"tint_spread",
       "",
       "share by which trees are brighter or darker, redder or bluer at most",
       &o.tint_spread,
       0,
       0.5,
       {}},
      {"terrain_m",
       "m",
       "relief of the ground, valley to hill; 0 is flat",
       &o.terrain_m,
       0,
       1000,
       {}},
      {"hill_m", "m", "from one hill to the next", &o.hill_m, 1, 100000, {}},
      {"seed", "", "another number grows another forest", &o.seed, 0, 2147483647, {}},
  };
}

Terrain terrain_of(const ScatterOptions& options) {
  return {options.terrain_m, options.hill_m, std::uint64_t(options.seed)};
}

double crown_radius(const TreeModel& tree) {
  if (tree.levels.empty() || tree.levels.back().cells.empty()) return 0.0;
  const TreeLevel& finest = tree.levels.back();
  std::vector<double> distances;
  distances.reserve(finest.cells.size());
  for (const std::uint64_t code : finest.cells) {
    const glm::dvec3 centre = cell_centre_in_world(tree, finest.level, code);
    distances.push_back(std::sqrt(centre.x * centre.x + centre.y * centre.y));
  }
  const auto outer = distances.begin() + std::ptrdiff_t(distances.size() * 95 / 100);
  std::nth_element(distances.begin(), outer, distances.end());
  return *outer;
}

std::vector<TreeInstance> scatter_trees(std::span<const double> crown_radii,
                                        const Image<float>& density,
                                        const ScatterOptions& options) {
  if (options.trees == 0) return {};
  Random turns(std::uint64_t(options.seed), 1);
  std::vector<TreeInstance> instances;
  for (const Disc& disc : discs_of(crown_radii, density, options)) {
    TreeInstance instance;
    instance.tree = disc.kind;
    instance.place = glm::dvec3(disc.centre, 0.0);
    instance.scale = disc.scale;
    instance.turn = turns.uniform(0.0, 2.0 * std::numbers::pi);
    instance.tint = random_tint(options.tint_spread, turns);
    instances.push_back(instance);
  }
  return instances;
}

std::vector<TreeInstance> line_up(std::span<const double> crown_radii) {
  constexpr double kGap = 1.1;
  const double length = 2.0 * kGap * std::accumulate(crown_radii.begin(), crown_radii.end(), 0.0);
  std::vector<TreeInstance> instances;
  double x = -0.5 * length;
  for (std::size_t i = 0; i < crown_radii.size(); ++i) {
    TreeInstance instance;
    instance.tree = std::uint32_t(i);
    instance.place.x = crown_radii.size() == 1 ? 0.0 : x + kGap * crown_radii[i];
    x += 2.0 * kGap * crown_radii[i];
    instances.push_back(instance);
  }
  return instances;
}

void stand_on(const Terrain& terrain, std::span<TreeInstance> instances) {
  for (TreeInstance& instance : instances) {
    instance.place.z = height_at(terrain, instance.place.x, instance.place.y);
  }
}

}  // namespace bosk
