#include "ui/workstation/export/export_sizes.h"

#include <algorithm>

namespace bosk {
namespace {

// Bytes of a PNG a pixel, as measured on rendered and photographed trees: leaves hardly compress,
// clear pixels nearly vanish.
constexpr double kBytesOfTree = 3.0, kBytesOfEdge = 0.8, kBytesOfClear = 0.03;
constexpr double kBytesOfScene = 0.5;   // sky, ground and a tree
constexpr double kBytesOfSheet = 1.3;   // a contact sheet's cells
constexpr double kBytesOfPage = 1.5e4;  // tables and settings
constexpr double kBytesOfFile = 100.0;

}  // namespace

Coverage coverage_of(const Mattes& mattes) {
  double pixels = 0.0, tree = 0.0, edges = 0.0;
  for (const Matte& matte : mattes) {
    for (int y = 0; y < matte.rgba.height(); y += 4) {
      for (int x = 0; x < matte.rgba.width(); x += 4) {
        const float alpha = matte.rgba(x, y).a;
        pixels += 1.0;
        tree += alpha > 0.0f ? 1.0 : 0.0;
        edges += alpha > 0.0f && alpha < 1.0f ? 1.0 : 0.0;
      }
    }
  }
  return pixels > 0.0 ? Coverage{tree / pixels, edges / pixels} : Coverage{};
}

std::size_t estimated_rgba_bytes(const Photos& views, const Coverage& coverage) {
  const double a_pixel = coverage.tree * kBytesOfTree + coverage.edges * kBytesOfEdge +
                         (1.0 - coverage.tree) * kBytesOfClear;
  double bytes = 0.0;
  for (const Photo& view : views) {
    const Lens& lens = view.original_camera.lens;
    bytes += kBytesOfFile + a_pixel * double(lens.width_px) * double(lens.height_px);
  }
  return std::size_t(bytes);
}

std::size_t estimated_turntable_bytes(int frames, const glm::ivec2& size_px) {
  return std::size_t(frames * (kBytesOfFile + kBytesOfScene * double(size_px.x) * size_px.y));
}

std::size_t estimated_report_bytes(const Photos& views, std::size_t scored) {
  if (views.empty()) return 0;
  // A row of three pictures a view, shrunk to 360 px; in a file and, in base 64, in the page
  const Lens& lens = views.front().camera.lens;
  const double cell_px = std::min(360.0, double(std::max(lens.width_px, lens.height_px)));
  const double row = 3.0 * cell_px * cell_px * kBytesOfSheet;
  return std::size_t(double(scored) * row * (1.0 + 4.0 / 3.0) + kBytesOfPage);
}

std::size_t estimated_camera_bytes(std::size_t cameras) { return 400 + 600 * cameras; }

}  // namespace bosk
