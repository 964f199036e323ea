#include "core/radiance/radiance.h"

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/opacity/hull.h"
#include "core/opacity/ray_cache.h"
#include "core/opacity/resample.h"
#include "core/radiance/fit.h"

namespace bosk {
namespace {

// Extinction per cell edge below which a level's start is dropped. Far below what shows: thin twigs
// begin as haze, and dropping haze of 0.02 cost 0.35 dB on new views of a dense crown.
constexpr float kFaintStart = 0.001f;
constexpr int kFinestLevel = 9;
constexpr int kCoarsestStep =
    4;  // photos of coarse levels are averaged over at most this many pixels
constexpr int kCountedStep = 8;  // rays of blocks of so many pixels a side tell how many samples

// Casting a phase's rays, for the progress: in passes over them, and as a share of a typical phase.
constexpr double kCastingPasses = 0.5, kCastingShare = 0.15;

RadianceVolume without_faint(const RadianceVolume& volume, float least, const Progress& progress) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < volume.grid.size(); ++i) {
    if (volume.extinction[i] >= least) kept.push_back(i);
  }
  return subset(volume, kept, progress);
}

// The volume one level finer: children that no photo sees empty, values interpolated.
RadianceVolume refined_volume(const RadianceVolume& volume,
                              const std::vector<Silhouette>& silhouettes, Progress& progress) {
  std::vector<glm::ivec3> parents;
  for (const glm::u16vec3& cell : volume.grid.cells()) parents.emplace_back(cell);
  const int level = volume.grid.level() + 1;
  RadianceVolume finer{volume.origin, volume.size_m, {}, volume.degree, {}, {}};
  finer.grid = SparseGrid(
      level, carve_children(silhouettes, {volume.origin, volume.size_m}, parents, level, progress));
  progress.check();
  finer.extinction = refined_extinction(volume.grid, volume.extinction, finer.grid, progress);
  finer.colour = refined_mean(volume.grid, volume.colour, std::size_t(volume.coefficients()) * 3,
                              finer.grid, progress);
  return without_faint(finer, kFaintStart, progress);
}

// One stretch of the fit: a level, photos averaged over step x step pixels, and the extinction
// below which cells are dropped behind it.
struct Phase {
  int level = 0, step = 1, epochs = 1;
  float rate = 1.0f, faintest = kFaintStart;
};

// Coarse to fine; at the finest level first on halved photos, then on all pixels. Faint cells go in
// two steps, each followed by passes that let the rest take over what they held.
std::vector<Phase> phases_of(const RadianceOptions& options, int first_level, int finest_step) {
  const int finest = std::min(first_level + options.finer_levels, kFinestLevel);
  const auto faintest = float(options.faintest);
  std::vector<Phase> phases;
  for (int level = first_level; level < finest; ++level) {
    const int step = finest_step * std::min(1 << (finest - level), kCoarsestStep);
    const bool last = level + 1 == finest && finest - first_level > 1;
    phases.push_back({level, step, options.coarse_epochs, 1.0f, last ? faintest : kFaintStart});
  }
  if (finest - first_level <= 1) {
    phases.push_back({finest, 2 * finest_step, options.coarse_epochs, 1.0f, 0.25f * faintest});
  }
  phases.push_back({finest, finest_step, options.epochs, 0.7f, faintest});
  if (options.last_epochs > 0)
    phases.push_back({finest, finest_step, options.last_epochs, 0.3f, 0.5f * faintest});
  return phases;
}

// What share of the time each phase takes, roughly: its passes times its rays.
std::vector<double> shares_of(const std::vector<Phase>& phases) {
  std::vector<double> ends = {0.0};
  for (const Phase& phase : phases) {
    const double rays = 1.0 / double(phase.step * phase.step);
    ends.push_back(ends.back() + rays * (phase.epochs + kCastingPasses));
  }
  const double total = ends.back();
  for (double& end : ends) end /= total;
  return ends;
}

FitSchedule schedule_of(const RadianceOptions& options, const Phase& phase) {
  FitSchedule schedule;
  schedule.epochs = phase.epochs;
  schedule.subsets = options.subsets;
  schedule.extinction_rate = phase.rate * float(options.extinction_rate);
  schedule.colour_rate = phase.rate * float(options.colour_rate);
  schedule.colour_variation = options.colour_variation;
  schedule.extinction_variation = options.extinction_variation;
  return schedule;
}

// Pixels, each way, to average photos over so that their rays have at most `max_samples` million
// samples in the volume's cells. Counted on a share of the rays.
int finest_step(const Photos& photos, const Mattes& mattes, const RadianceVolume& volume,
                double max_samples, Progress& progress) {
  if (max_samples <= 0.0) return 1;
  const TrilinearSupport support(volume.grid);
  const ProgressPart part(progress, 0.0, 0.0);
  const RayCache cache = cache_rays(photos, mattes, kCountedStep, {volume.origin, volume.size_m},
                                    volume.grid.level(), support, progress);
  double samples = 0.0;
  for (const SampleSpan& span : cache.spans) samples += span.last - span.first;
  const double all = samples * double(kCountedStep * kCountedStep);
  return std::clamp(int(std::ceil(std::sqrt(all / (1e6 * max_samples)))), 1, kCountedStep);
}

// Counts epochs over all phases, tells the watcher, and says whether to go on.
class Epochs {
 public:
  Epochs(const RadianceOptions& options, const std::vector<Phase>& phases, const Photos& photos,
         const Mattes& mattes, const RadianceWatcher& watcher)
      : stop_after_(options.stop_after), photos_(photos), mattes_(mattes), watcher_(watcher) {
    for (const Phase& phase : phases) planned_ += phase.epochs;
    if (stop_after_ > 0) planned_ = std::min(planned_, stop_after_);
  }

  bool go_on(const RadianceVolume& volume, double psnr_db) {
    ++done_;
    const bool wanted = !watcher_ || watcher_({volume, done_, planned_, psnr_db, photos_, mattes_});
    stopped_ = !wanted || done_ == stop_after_;
    return !stopped_;
  }
  int done() const { return done_; }
  bool stopped() const { return stopped_; }

 private:
  int stop_after_ = 0, planned_ = 0, done_ = 0;
  bool stopped_ = false;
  const Photos& photos_;
  const Mattes& mattes_;
  const RadianceWatcher& watcher_;
};

[[noreturn]] void throw_empty() {
  throw Error(
      "nothing opaque is left of the volume: check that mattes and cameras belong together");
}

}  // namespace

Options describe(RadianceOptions& options) {
  return {
      {"degree",
       "",
       "degree of the spherical harmonics of colour: 0 is one colour from all sides",
       &options.degree,
       0,
       2,
       {}},
      {"finer_levels",
       "",
       "octree levels below opacity's finest; each doubles detail and time",
       &options.finer_levels,
       0,
       3,
       {}},
      {"max_samples",
       "million",
       "samples along the photos' rays in opacity's cells; photos are averaged over 2x2, 3x3... "
       "pixels until no more are left; 0 is any number",
       &options.max_samples,
       0.0,
       1e6,
       {}},
      {"epochs",
       "",
       "passes over all pixels at the finest level; more is sharper and slower",
       &options.epochs,
       1,
       100,
       {}},
      {"last_epochs",
       "",
       "passes over all pixels after faint cells are dropped",
       &options.last_epochs,
       0,
       100,
       {}},
      {"coarse_epochs",
       "",
       "passes at each coarser level, over averaged pixels",
       &options.coarse_epochs,
       1,
       100,
       {}},
      {"subsets",
       "",
       "updates per pass, each from its share of the pixels",
       &options.subsets,
       1,
       1000,
       {}},
      {"extinction_rate",
       "",
       "first step of an update of opacity",
       &options.extinction_rate,
       1e-4,
       1.0,
       {}},
      {"colour_rate", "", "first step of an update of colour", &options.colour_rate, 1e-4, 1.0, {}},
      {"colour_variation",
       "",
       "how much neighbouring cells are pulled to one colour",
       &options.colour_variation,
       0.0,
       100.0,
       {}},
      {"extinction_variation",
       "",
       "how much neighbouring cells are pulled to one opacity",
       &options.extinction_variation,
       0.0,
       100.0,
       {}},
      {"faintest",
       "",
       "extinction per cell edge below which a finished cell is dropped",
       &options.faintest,
       0.0,
       1.0,
       {}},
      {"stop_after",
       "",
       "ends after so many passes, counted over all levels, and keeps what there is; 0 is never",
       &options.stop_after,
       0,
       10000,
       {}},
  };
}

RadianceVolume subset(const RadianceVolume& volume, const std::vector<std::uint32_t>& kept,
                      const Progress& progress) {
  RadianceVolume result{volume.origin, volume.size_m, {}, volume.degree, {}, {}};
  const std::size_t stride = std::size_t(volume.coefficients()) * 3;
  std::vector<glm::ivec3> cells;
  cells.reserve(kept.size());
  result.extinction.reserve(kept.size());
  result.colour.reserve(kept.size() * stride);
  for (const std::uint32_t cell : kept) {
    progress.check();
    cells.emplace_back(volume.grid.cells()[cell]);
    result.extinction.push_back(volume.extinction[cell]);
    const auto first = volume.colour.begin() + std::ptrdiff_t(cell * stride);
    result.colour.insert(result.colour.end(), first, first + std::ptrdiff_t(stride));
  }
  result.grid = SparseGrid(volume.grid.level(), cells);
  return result;
}

RadianceVolume refine_radiance(const Photos& photos, const Mattes& mattes,
                               const OpacityTree& opacity, const RadianceOptions& options,
                               Progress& progress, const RadianceWatcher& watcher) {
  std::vector<Silhouette> silhouettes;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    silhouettes.emplace_back(photos[i].camera, mattes[i].rgba, 0.0f);
  }
  RadianceVolume volume{opacity.origin, opacity.size_m,     opacity.grid,
                        options.degree, opacity.extinction, {}};
  volume.colour.assign(volume.grid.size() * std::size_t(volume.coefficients()) * 3, 0.0f);
  volume = without_faint(volume, kFaintStart, progress);
  const std::vector<Phase> phases = phases_of(
      options, opacity.level(), finest_step(photos, mattes, volume, options.max_samples, progress));
  Epochs epochs(options, phases, photos, mattes, watcher);
  const std::vector<double> shares = shares_of(phases);
  std::optional<Phase> cast;  // the phase whose rays `cache` holds
  RayCache cache;
  for (std::size_t at = 0; at < phases.size() && !epochs.stopped(); ++at) {
    const Phase& phase = phases[at];
    const ProgressPart phase_part(progress, shares[at], shares[at + 1]);
    std::optional<ProgressPart> step_part(std::in_place, progress, 0.0, kCastingShare);
    if (phase.level > volume.grid.level()) volume = refined_volume(volume, silhouettes, progress);
    if (volume.grid.size() == 0) throw_empty();
    progress.check();
    const TrilinearSupport support(volume.grid);
    progress.check();
    if (!cast || cast->level != phase.level || cast->step != phase.step) {
      cast = phase;
      cache = cache_rays(photos, mattes, phase.step, {volume.origin, volume.size_m}, phase.level,
                         support, progress);
    }  // else only cells were dropped since: the rays' stretches still hold all that are left
    if (epochs.done() == 0) back_project_colour(volume, cache, support, progress);
    step_part.emplace(progress, kCastingShare, 1.0);
    fit_volume(volume, cache, support, schedule_of(options, phase), progress,
               [&](double psnr_db) { return epochs.go_on(volume, psnr_db); });
    volume = without_faint(volume, phase.faintest, progress);
  }
  return volume;
}

void write(BinaryWriter& writer, const RadianceVolume& volume) {
  writer.value(volume.origin);
  writer.value(volume.size_m);
  write(writer, volume.grid);
  writer.value(volume.degree);
  writer.array(volume.extinction);
  writer.array(volume.colour);
}

RadianceVolume read_radiance_volume(BinaryReader& reader) {
  RadianceVolume volume;
  volume.origin = reader.value<glm::dvec3>();
  volume.size_m = reader.value<double>();
  volume.grid = read_sparse_grid(reader);
  volume.degree = reader.value<int>();
  volume.extinction = reader.array<float>();
  volume.colour = reader.array<float>();
  const bool consistent =
      volume.degree >= 0 && volume.degree <= 2 && volume.extinction.size() == volume.grid.size() &&
      volume.colour.size() == volume.grid.size() * std::size_t(volume.coefficients()) * 3;
  if (!consistent) throw Error("stored volume is inconsistent");
  return volume;
}

}  // namespace bosk
