#include <bit>
#include <cstring>

#include "core/base/atomic_file.h"
#include "core/photo/camera_files_colmap.h"

// COLMAP's binary model, little-endian, nothing aligned:
//   cameras.bin  [u64 count] ([u32 id][i32 model][u64 width][u64 height][f64 x parameters]) x count
//   images.bin   [u64 count] ([u32 id][f64 qw qx qy qz tx ty tz][u32 camera_id][name 0]
//                             [u64 points]([f64 x y][u64 point_id]) x points) x count
namespace bosk::camera_files {
namespace {

static_assert(std::endian::native == std::endian::little);
constexpr std::uint64_t kMaxBytes = std::uint64_t(1) << 31;
constexpr std::uint64_t kLeastCameraBytes = 4 + 4 + 8 + 8 + 3 * 8;
constexpr std::uint64_t kLeastImageBytes = 4 + 7 * 8 + 4 + 1 + 8;
constexpr std::uint64_t kPointBytes = 24;

class Bytes {
 public:
  explicit Bytes(const std::filesystem::path& file)
      : file_(file.string()), bytes_(read_text(file, kMaxBytes)), rest_(bytes_) {}

  template <class T>
  T value() {
    T item;
    std::memcpy(&item, skip(sizeof item).data(), sizeof item);
    return item;
  }
  // A count of entries that take at least so many bytes each.
  std::uint64_t count(std::uint64_t least_bytes) {
    const auto entries = value<std::uint64_t>();
    if (entries > rest_.size() / least_bytes)
      refuse(place(), "a count of " + std::to_string(entries) +
                          " is more than the file can hold; it is damaged, copy it again");
    return entries;
  }
  std::string_view text() {
    const std::size_t end = rest_.find('\0');
    if (end == std::string_view::npos) refuse_cut();
    const std::string_view result = skip(end);
    skip(1);
    return result;
  }
  std::string_view skip(std::size_t size) {
    if (size > rest_.size()) refuse_cut();
    const std::string_view result = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return result;
  }
  void expect_end() const {
    if (!rest_.empty())
      refuse(place(), std::to_string(rest_.size()) +
                          " bytes follow the last entry; the file is damaged, copy it again");
  }
  std::string place() const {
    return file_ + ", byte " + std::to_string(bytes_.size() - rest_.size());
  }

 private:
  [[noreturn]] void refuse_cut() const {
    refuse(place(), "the file ends too early; it is damaged, copy it again");
  }
  std::string file_, bytes_;
  std::string_view rest_;
};

ColmapLenses read_lenses(const std::filesystem::path& file) {
  Bytes bytes(file);
  ColmapLenses lenses;
  for (std::uint64_t left = bytes.count(kLeastCameraBytes); left > 0; --left) {
    const std::string place = bytes.place();
    const auto id = bytes.value<std::uint32_t>();
    const ColmapModel& model = colmap_model(bytes.value<std::int32_t>(), place);
    const auto width = bytes.value<std::uint64_t>(), height = bytes.value<std::uint64_t>();
    Lens lens;
    set_size(lens, double(width), double(height), place);
    std::vector<double> parameters(std::size_t(model.parameters()));
    for (double& parameter : parameters) parameter = bytes.value<double>();
    set_parameters(lens, model, parameters);
    add_lens(lenses, id, lens, place);
  }
  bytes.expect_end();
  return lenses;
}

void read_image(CameraFile& result, const ColmapLenses& lenses, Bytes& bytes) {
  const std::string place = bytes.place();
  bytes.value<std::uint32_t>();  // the image's number
  double pose[7];
  for (double& value : pose) value = bytes.value<double>();
  const auto camera_id = bytes.value<std::uint32_t>();
  const std::string_view image = bytes.text();
  bytes.skip(bytes.count(kPointBytes) * kPointBytes);
  add_image(result, lenses, camera_id, {pose[0], pose[1], pose[2], pose[3]},
            {pose[4], pose[5], pose[6]}, image, place);
}

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

CameraFile read_colmap_binary(const std::filesystem::path& folder) {
  const ColmapLenses lenses = read_lenses(folder / "cameras.bin");
  const std::filesystem::path file = folder / "images.bin";
  Bytes bytes(file);
  CameraFile result;
  for (std::uint64_t left = bytes.count(kLeastImageBytes); left > 0; --left)
    read_image(result, lenses, bytes);
  bytes.expect_end();
  check_set(result.cameras, file.string());
  return result;
}

void write_colmap_binary(std::span<const Camera> cameras, const std::filesystem::path& folder,
                         Images images) {
  const SharedLenses shared = shared_lenses(cameras);
  std::string lens_bytes, image_bytes, point_bytes;
  append(lens_bytes, std::uint64_t(shared.lenses.size()));
  for (std::size_t i = 0; i < shared.lenses.size(); ++i) {
    const Lens& lens = shared.lenses[i];
    const ColmapModel& model = colmap_model_of(lens);
    append(lens_bytes, std::uint32_t(i + 1));
    append(lens_bytes, model.id);
    append(lens_bytes, std::uint64_t(lens.width_px));
    append(lens_bytes, std::uint64_t(lens.height_px));
    for (const double parameter : parameters_of(lens, model)) append(lens_bytes, parameter);
  }
  append(image_bytes, std::uint64_t(cameras.size()));
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    append(image_bytes, std::uint32_t(i + 1));
    append(image_bytes, wxyz_from_rotation(cameras[i].camera_from_world.rotation));
    append(image_bytes, cameras[i].camera_from_world.translation);
    append(image_bytes, std::uint32_t(shared.of_camera[i] + 1));
    image_bytes += images[i].generic_string() + '\0';
    append(image_bytes, std::uint64_t(0));
  }
  append(point_bytes, std::uint64_t(0));
  write_file_atomically(folder / "cameras.bin", lens_bytes);
  write_file_atomically(folder / "images.bin", image_bytes);
  write_file_atomically(folder / "points3D.bin", point_bytes);
}

}  // namespace bosk::camera_files
