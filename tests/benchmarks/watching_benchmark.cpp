// What it costs to look at a tree while it is made, and how near the curve over codewords comes to
// the packages.
//   watching_benchmark PROJECT [CODEWORDS...]    runs what isn't finished; packs for each CODEWORDS

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>

#include "core/compress/rate_distortion.h"
#include "core/package/assemble.h"
#include "core/package/codebook_curve.h"
#include "core/package/writer.h"
#include "core/project/capture.h"
#include "core/project/run.h"
#include "core/radiance/photo_residuals.h"
#include "core/radiance/volume_picture.h"

namespace bosk {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The shortest of five, in milliseconds of processor time.
template <class Work>
double least_ms(const Work& work) {
  double least = 1e9;
  for (int i = 0; i < 5; ++i) {
    const std::clock_t start = std::clock();
    work();
    least = std::min(least, 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

template <class Volume>
void measure_volume(const char* name, const Volume& volume, const std::vector<SmallMatte>& mattes,
                    const Camera& photo) {
  for (int level = volume.grid.level(); level >= 7; --level) {
    const VolumeSnapshot snapshot = snapshot_of(volume, level);
    double error = 0.0, psnr = 0.0;
    for (const PhotoResidual& residual : photo_residuals(snapshot, mattes)) {
      error += residual.alpha_error / double(mattes.size());
      psnr += residual.psnr_db / double(mattes.size());
    }
    const Camera orbit = orbit_camera(snapshot, 0.5, 0.2, 1.6, 300, 400);
    std::printf("%-8s %5d %9.1f %9.1f %9.1f %9.1f %9.1f %9.1f %9.4f %9.2f\n", name, level,
                double(snapshot.bricks.size() * sizeof(VolumeSnapshot::Brick)) / 1e6,
                least_ms([&] { snapshot_of(volume, level); }),
                least_ms([&] { volume_picture(snapshot, photo, 300, 400); }),
                least_ms([&] { volume_picture(snapshot, orbit, 300, 400); }),
                least_ms([&] { slice_picture(snapshot, 0, 0.5, 256, SliceLook::extinction); }),
                least_ms([&] { photo_residuals(snapshot, mattes); }), error, psnr);
  }
}

void measure_looking(const Results& results) {
  const auto mattes = small_mattes(*results.views, *results.mattes);
  std::printf("processor time in ms, shortest of five; residuals of %zu photos at %d x %d\n\n",
              mattes.size(), mattes[0].premultiplied.width(), mattes[0].premultiplied.height());
  std::printf(
      "volume   level        MB  snapshot     photo     orbit     slice residuals     alpha        "
      "dB\n");
  measure_volume("opacity", *results.opacity, mattes, results.views->front().camera);
  measure_volume("radiance", *results.radiance, mattes, results.views->front().camera);
}

void print_point(const CodebookPoint& point) {
  std::printf("%9d %10.2f %10.2f %9.3f %9.3f %9.3f\n", point.codewords, point.colour_psnr_db,
              point.alpha_psnr_db, double(point.colour_bytes) / 1e6,
              double(point.alpha_bytes) / 1e6, double(point.package_bytes()) / 1e6);
  std::fflush(stdout);
}

void measure_curve(const Billboards& billboards) {
  std::printf("\ncodewords colour, dB  alpha, dB colour MB  alpha MB       all\n");
  Progress progress;
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t work = std::clock();
  codebook_curve(billboards, {}, usual_codeword_counts(), progress, print_point);
  std::printf("%.1f s, %.1f s of processor time\n", seconds_since(start),
              double(std::clock() - work) / CLOCKS_PER_SEC);
}

void measure_package(const Billboards& billboards, int codewords) {
  CompressOptions options;
  options.colour_codewords = options.alpha_codewords = codewords;
  Progress progress;
  const CodedTextures textures = compress_billboards(billboards, options, progress);
  const OverallPsnr psnr = overall_psnr(rate_distortion(billboards, textures, false, progress));
  const auto bytes = package_bytes(assemble_tree(billboards, textures, {}), progress);
  std::printf("%9d %10.2f %10.2f %29.3f  packed\n", codewords, psnr.colour_db, psnr.alpha_db,
              double(bytes.size()) / 1e6);
  std::fflush(stdout);
}

void measure(int count, char** arguments) {
  const Project project = read_project(arguments[1]);
  Progress progress;
  const Run run = run_stages(project, gather_capture(project),
                             {"view", "matte", "opacity", "radiance", "texture"}, progress);
  measure_looking(run.results);
  measure_curve(*run.results.billboards);
  for (int i = 2; i < count; ++i) measure_package(*run.results.billboards, std::atoi(arguments[i]));
}

}  // namespace
}  // namespace bosk

int main(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(stderr, "usage: watching_benchmark PROJECT [CODEWORDS...]\n");
    return 2;
  }
  try {
    bosk::measure(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
