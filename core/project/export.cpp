#include "core/project/export.h"

#include "core/base/atomic_file.h"
#include "core/image/image_io.h"
#include "core/photo/camera_files.h"
#include "core/project/original_pixels.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& path, const std::vector<std::byte>& bytes) {
  std::error_code none;
  return fs::file_size(path, none) == bytes.size() && read_file(path, bytes.size()) == bytes;
}

}  // namespace

fs::path usual_package_path(const Project& project) {
  return project.folder / (project.name() + ".bosk");
}

bool write_package_file(const fs::path& path, const std::vector<std::byte>& package) {
  if (holds(path, package)) return false;
  write_file_atomically(path, package);
  return true;
}

std::size_t export_cameras(const Photos& views, const Capture& capture, const std::string& format,
                           const fs::path& output) {
  std::vector<Camera> cameras;
  std::vector<fs::path> images;
  for (const Photo& view : views) {
    cameras.push_back(view.original_camera);
    for (const SourceFile& photo : capture.photos) {
      if (photo.name == view.name) images.push_back(photo.path.filename());
    }
  }
  write_cameras(cameras, format, output, images);
  return cameras.size();
}

std::size_t export_mattes(const Photos& views, const Mattes& mattes, const fs::path& folder,
                          Progress& progress) {
  make_folder(folder);
  progress.begin("Writing mattes", views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Image<glm::vec4> matte = in_original_pixels(mattes[i].rgba, views[i]);
    write_png(folder / (views[i].name + ".png"), rgba8_from_straight(matte));
    progress.advance();
  }
  return views.size();
}

}  // namespace bosk
