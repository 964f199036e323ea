#include "core/render/picture_files.h"

#include <chrono>

#include "core/base/atomic_file.h"
#include "core/image/image_io.h"

namespace bosk {

std::vector<PictureFile> write_pictures(std::span<const Camera> cameras, const CameraPainter& paint,
                                        const std::filesystem::path& folder, Progress& progress) {
  using Clock = std::chrono::steady_clock;
  make_folder(folder);
  std::vector<PictureFile> files;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const ProgressPart part(progress, double(i) / double(cameras.size()),
                            double(i + 1) / double(cameras.size()));
    progress.begin("Drawing " + cameras[i].name, 1);
    const Clock::time_point start = Clock::now();
    const Image<glm::vec4> view = paint(cameras[i]);
    const std::chrono::duration<double, std::milli> spent = Clock::now() - start;
    files.push_back({folder / (cameras[i].name + ".png"), spent.count()});
    write_png(files.back().path, rgba8_from_straight(view));
  }
  return files;
}

}  // namespace bosk
