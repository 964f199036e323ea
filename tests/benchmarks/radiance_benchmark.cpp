// Speed against accuracy of opacity and radiance: for each preset, processor time and what rays of
// photos that took no part say of the volume.
//   radiance_benchmark PROJECT [N]    holds out every N-th photo (6); runs mattes when not yet done

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>

#include "core/project/capture.h"
#include "core/project/presets.h"
#include "core/project/run.h"
#include "tests/radiance/march.h"

namespace bosk {
namespace {

struct Split {
  Photos photos, held_photos;
  Mattes mattes, held_mattes;
};

Split split(const Results& results, std::size_t every) {
  Split parts;
  for (std::size_t i = 0; i < results.views->size(); ++i) {
    const bool held = i % every == every - 1;
    (held ? parts.held_photos : parts.photos).push_back((*results.views)[i]);
    (held ? parts.held_mattes : parts.mattes).push_back((*results.mattes)[i]);
  }
  return parts;
}

double seconds_since(std::clock_t start) { return double(std::clock() - start) / CLOCKS_PER_SEC; }

double db_from_rms(double rms) { return -20.0 * std::log10(std::max(rms, 1e-6)); }

MarchError error_on(const RadianceVolume& volume, const Photos& photos, const Mattes& mattes) {
  Progress progress;
  const TrilinearSupport support(volume.grid);
  const RayCache cache = cache_rays(photos, mattes, 1, {volume.origin, volume.size_m},
                                    volume.grid.level(), support, progress);
  return march_error(volume, cache, support);
}

void measure(const Split& parts, const Preset& preset) {
  Recipe recipe;
  apply_preset(recipe, preset.name);
  Progress progress;
  const std::clock_t start = std::clock();
  const OpacityTree opacity =
      estimate_opacity(parts.photos, parts.mattes, recipe.opacity, progress);
  const double opacity_s = seconds_since(start);
  const RadianceVolume volume =
      refine_radiance(parts.photos, parts.mattes, opacity, recipe.radiance, progress);
  const double radiance_s = seconds_since(start) - opacity_s;
  const MarchError error = error_on(volume, parts.held_photos, parts.held_mattes);
  std::printf("%-8s %9zu %10.1f %11.1f %12.2f %11.2f\n", preset.name.c_str(), volume.grid.size(),
              opacity_s, radiance_s, db_from_rms(error.colour), db_from_rms(error.alpha));
  std::fflush(stdout);
}

void measure_project(const char* folder, std::size_t every) {
  const Project project = read_project(folder);
  Progress progress;
  const Run run = run_stages(project, gather_capture(project), {"view", "matte"}, progress);
  const Split parts = split(run.results, every);
  std::printf("%zu photos, %zu held out; over the held-out rays that meet the volume\n",
              parts.photos.size(), parts.held_photos.size());
  std::printf("preset       cells opacity, s radiance, s  colour, dB  alpha, dB\n");
  for (const Preset& preset : presets()) measure(parts, preset);
}

}  // namespace
}  // namespace bosk

int main(int count, char** arguments) {
  const int every = count > 2 ? std::atoi(arguments[2]) : 6;
  if (count < 2 || every < 2) {
    std::fprintf(stderr, "usage: radiance_benchmark PROJECT [N]\n");
    return 2;
  }
  try {
    bosk::measure_project(arguments[1], std::size_t(every));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
