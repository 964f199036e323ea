// session_benchmark: what painting costs beside the picture: keeping, undoing, saving and opening
// with ten thousand strokes of a hundred points over 24 photos, and painting them at a megapixel.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "core/base/random.h"
#include "core/matte/scribbles.h"
#include "core/project/session.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

constexpr int kStrokes = 10'000, kPoints = 100, kPhotos = 24;

template <class Work>
double milliseconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

void print(const char* what, std::vector<double> times_ms) {
  std::sort(times_ms.begin(), times_ms.end());
  std::printf("%-40s %9.3f %9.3f %9.3f\n", what, times_ms[times_ms.size() / 2],
              times_ms[times_ms.size() * 99 / 100], times_ms.back());
}

Stroke drawn_stroke(Random& random) {
  Stroke stroke{StrokeKind(random.below(2)), random.uniform(4.0, 40.0), {}};
  glm::dvec2 place(random.uniform(0.0, 4000.0), random.uniform(0.0, 3000.0));
  for (int i = 0; i < kPoints; ++i) {
    stroke.points_px.push_back(place);
    place += glm::dvec2(random.uniform(-9.0, 12.0), random.uniform(-12.0, 9.0));
  }
  return stroke;
}

Photo bent_photo() {
  Photo photo;
  photo.original_camera.lens = {LensModel::opencv, 4000,        3000, glm::dvec2(3600.0),
                                {1999.5, 1499.5},  {-0.1, 0.05}};
  photo.camera.lens = scaled(undistorted(photo.original_camera.lens), 1155, 866);
  return photo;
}

void measure_session(const fs::path& folder) {
  Project project;
  project.folder = folder;
  fs::create_directories(folder);
  save_project(project);
  Random random(1);
  std::vector<double> applied, undone;
  {
    Session session(folder);
    for (int i = 0; i < kStrokes; ++i) {
      const Edit edit = AddStroke{"oak_" + std::to_string(i % kPhotos), drawn_stroke(random)};
      applied.push_back(milliseconds([&] { session.apply(edit); }));
    }
    print("stroke kept", applied);
    print("project read, all from the journal", {milliseconds([&] { read_project(folder); })});
    print("saved", {milliseconds([&] { session.save(); })});
    for (int i = 0; i < 1000; ++i) undone.push_back(milliseconds([&] { session.undo(); }));
    for (int i = 0; i < 1000; ++i) session.redo();
    print("undo", undone);
    const Edit clear = clear_edit(session.project(), "oak_3");
    print("strokes of a photo cleared", {milliseconds([&] { session.apply(clear); })});
    print("the same undone", {milliseconds([&] { session.undo(); })});
  }
  print("project read, all saved", {milliseconds([&] { read_project(folder); })});
  print("session opened", {milliseconds([&] { Session again(folder); })});
}

void measure_painting() {
  const Photo photo = bent_photo();
  Random random(2);
  std::vector<Stroke> strokes;
  std::vector<double> one;
  Image<std::uint8_t> scribbles;
  for (int i = 0; i < 200; ++i) {
    strokes.push_back(drawn_stroke(random));
    one.push_back(milliseconds([&] { paint_strokes({strokes.back()}, photo, scribbles); }));
  }
  print("one stroke painted, 1 MP", one);
  print("200 strokes painted at once",
        {milliseconds([&] { paint_strokes(strokes, photo, scribbles); })});
  std::vector<double> undone;
  while (strokes.size() > 100) {
    const Stroke last = strokes.back();
    strokes.pop_back();
    undone.push_back(milliseconds([&] {
      const PixelBox box = box_of(last, photo);
      for (int y = box.from.y; y < box.to.y; ++y) {
        for (int x = box.from.x; x < box.to.x; ++x) scribbles(x, y) = kNoStroke;
      }
      paint_strokes(strokes, photo, box, scribbles);
    }));
  }
  print("one of 200 taken out", undone);
  while (strokes.size() < kStrokes) strokes.push_back(drawn_stroke(random));
  print("10000 strokes painted at once",
        {milliseconds([&] { paint_strokes(strokes, photo, scribbles); })});
}

}  // namespace
}  // namespace bosk

int main() {
  const auto folder = std::filesystem::temp_directory_path() / "bosk-session-benchmark";
  std::filesystem::remove_all(folder);
  std::printf("%-40s %9s %9s %9s\n", "milliseconds", "median", "p99", "most");
  bosk::measure_session(folder);
  bosk::measure_painting();
  std::filesystem::remove_all(folder);
}
