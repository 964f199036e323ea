#include "tests/hostile_input/damaged_photos.h"

#include <sys/stat.h>

#include <array>
#include <fstream>
#include <limits>
#include <string_view>

#include "core/base/atomic_file.h"
#include "core/base/random.h"
#include "tests/photo/photo_writer.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using std::operator""sv;

// 16 x 16 pixels in four inks, made with libjpeg: OpenImageIO writes no such files.
constexpr std::array<unsigned char, 199> kCmykJpeg = {
    0xff, 0xd8, 0xff, 0xee, 0x00, 0x0e, 0x41, 0x64, 0x6f, 0x62, 0x65, 0x00, 0x64, 0x00, 0x00, 0x00,
    0x00, 0x00, 0xff, 0xdb, 0x00, 0x43, 0x00, 0x10, 0x0b, 0x0c, 0x0e, 0x0c, 0x0a, 0x10, 0x0e, 0x0d,
    0x0e, 0x12, 0x11, 0x10, 0x13, 0x18, 0x28, 0x1a, 0x18, 0x16, 0x16, 0x18, 0x31, 0x23, 0x25, 0x1d,
    0x28, 0x3a, 0x33, 0x3d, 0x3c, 0x39, 0x33, 0x38, 0x37, 0x40, 0x48, 0x5c, 0x4e, 0x40, 0x44, 0x57,
    0x45, 0x37, 0x38, 0x50, 0x6d, 0x51, 0x57, 0x5f, 0x62, 0x67, 0x68, 0x67, 0x3e, 0x4d, 0x71, 0x79,
    0x70, 0x64, 0x78, 0x5c, 0x65, 0x67, 0x63, 0xff, 0xc0, 0x00, 0x14, 0x08, 0x00, 0x10, 0x00, 0x10,
    0x04, 0x43, 0x11, 0x00, 0x4d, 0x11, 0x00, 0x59, 0x11, 0x00, 0x4b, 0x11, 0x00, 0xff, 0xc4, 0x00,
    0x15, 0x00, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x06, 0xff, 0xc4, 0x00, 0x18, 0x10, 0x01, 0x00, 0x03, 0x01, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x04, 0x14, 0x41, 0x61, 0xff, 0xda,
    0x00, 0x0e, 0x04, 0x43, 0x00, 0x4d, 0x00, 0x59, 0x00, 0x4b, 0x00, 0x00, 0x3f, 0x00, 0x8d, 0x85,
    0x88, 0xda, 0x7c, 0x4e, 0xa9, 0x14, 0x10, 0xb0, 0xa7, 0xc0, 0x4f, 0xc2, 0xc5, 0x05, 0x3e, 0x02,
    0x82, 0x16, 0x14, 0xf8, 0x0f, 0xff, 0xd9};

// Makes files and keeps the list of them.
class Workshop {
 public:
  explicit Workshop(fs::path folder) : folder_(std::move(folder)) {}

  fs::path path(const std::string& name) const { return folder_ / name; }
  void list(const std::string& name, Fate fate) { photos_.push_back({name, fate}); }
  void put(const std::string& name, Fate fate, std::string_view bytes) {
    write_file_atomically(path(name), bytes);
    list(name, fate);
  }
  void photo(const std::string& name, Fate fate, const PhotoFile& file) {
    if (write_photo(path(name), file)) list(name, fate);
  }
  // The bytes of a whole photo; empty when its format cannot be written here.
  std::string bytes_of(const std::string& ending, const PhotoFile& file) const {
    const fs::path whole = path("whole" + ending);
    if (!write_photo(whole, file)) return {};
    const std::vector<std::byte> bytes = read_file(whole, 1 << 24);
    fs::remove(whole);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  const std::vector<DamagedPhoto>& photos() const { return photos_; }

 private:
  fs::path folder_;
  std::vector<DamagedPhoto> photos_;
};

// So that no file shrinks to a few bytes in compression.
float noise(int x, int y, int channel) {
  return float(Random(std::uint64_t(x), std::uint64_t(y * 4 + channel)).uniform());
}

// A width that OpenImageIO's HEIF writer takes without reading past the end of the rows.
PhotoFile noisy() { return {.width = 128, .height = 90, .value = noise}; }

std::string big_endian(std::uint32_t number) {
  return {char(number >> 24), char(number >> 16), char(number >> 8), char(number)};
}

std::string little_endian(std::uint32_t number) {
  return {char(number), char(number >> 8), char(number >> 16), char(number >> 24)};
}

std::string random_bytes(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes.push_back(char(random.bits()));
  return bytes;
}

// PNG's own checksum (ISO 3309), bit by bit.
std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = ~0u;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

std::string png_chunk(const std::string& type, const std::string& data) {
  return big_endian(std::uint32_t(data.size())) + type + data + big_endian(crc32(type + data));
}

// A whole PNG but for its pixels: a few bytes that claim any size.
std::string png_of_size(std::uint32_t width, std::uint32_t height) {
  const std::string header =
      big_endian(width) + big_endian(height) + std::string("\x08\x02\0\0\0"sv);
  return std::string("\x89PNG\r\n\x1a\n"sv) + png_chunk("IHDR", header) +
         png_chunk("IDAT", std::string("\x78\x9c\x63\0\0\0\x01\0\x01"sv)) + png_chunk("IEND", "");
}

struct TiffEntry {
  std::uint16_t tag = 0, type = 4;  // 4: 32-bit number
  std::uint32_t count = 1, value = 0;
};

std::string tiff_folder(const std::vector<TiffEntry>& entries, std::uint32_t next) {
  const auto short_text = [](std::uint32_t number) { return little_endian(number).substr(0, 2); };
  std::string bytes = short_text(std::uint32_t(entries.size()));
  for (const TiffEntry& entry : entries) {
    bytes += short_text(entry.tag) + short_text(entry.type) + little_endian(entry.count) +
             little_endian(entry.value);
  }
  return bytes + little_endian(next);
}

std::string tiff_of(std::uint32_t width, std::uint32_t height, std::uint32_t strip_at,
                    std::uint32_t strip_size, std::uint32_t next = 0) {
  const std::vector<TiffEntry> entries = {
      {256, 4, 1, width}, {257, 4, 1, height}, {258, 3, 1, 8},
      {259, 3, 1, 1},     {262, 3, 1, 1},      {273, 4, 1, strip_at},
      {277, 3, 1, 1},     {278, 4, 1, height}, {279, 4, 1, strip_size}};
  return std::string("II*\0"sv) + little_endian(8) + tiff_folder(entries, next);
}

// A JPEG with an EXIF block of our making behind its first marker.
std::string jpeg_with_exif(const std::string& jpeg, const std::string& tiff) {
  const std::string block = std::string("Exif\0\0"sv) + tiff;
  const std::size_t size = block.size() + 2;
  return jpeg.substr(0, 2) + "\xff\xe1" + char(size >> 8) + char(size) + block + jpeg.substr(2);
}

void add_no_photos(Workshop& shop) {
  shop.put("empty.jpg", Fate::refused, "");
  shop.put("one_byte.jpg", Fate::refused, "\xff");
  shop.put("only_magic.png", Fate::refused, "\x89PNG\r\n\x1a\n");
  shop.put("text.jpg", Fate::refused, "This is a letter, not a photo.\n");
  shop.put("page.png", Fate::refused, "<!DOCTYPE html><title>404 Not Found</title>");
  shop.put("zeros.tif", Fate::refused, std::string(4096, '\0'));
  shop.put("animation.gif", Fate::refused, std::string("GIF89a\1\0\1\0\0\0\0;"sv));
  shop.put("scan.pdf", Fate::refused, "%PDF-1.4\n");
  shop.put("clip.heic", Fate::refused,
           std::string("\0\0\0\x18"
                       "ftypmp42\0\0\0\0mp42isom"sv));
  fs::create_directory(shop.path("folder.jpg"));
  shop.list("folder.jpg", Fate::refused);
  if (::mkfifo(shop.path("fifo.jpg").c_str(), 0600) == 0) shop.list("fifo.jpg", Fate::refused);
  fs::create_symlink("nowhere.jpg", shop.path("dangling.jpg"));
  shop.list("dangling.jpg", Fate::refused);
  fs::create_symlink("/dev/zero", shop.path("endless.jpg"));
  shop.list("endless.jpg", Fate::refused);
}

void add_noise_behind_magic(Workshop& shop) {
  const std::string noise_bytes = random_bytes(3000, 1);
  shop.put("noise.jpg", Fate::refused, "\xff\xd8\xff\xe0" + noise_bytes);
  shop.put("noise.png", Fate::refused, "\x89PNG\r\n\x1a\n" + noise_bytes);
  shop.put("noise.tif", Fate::refused, std::string("II*\0"sv) + noise_bytes);
  shop.put("noise.nef", Fate::refused, std::string("MM\0*"sv) + noise_bytes);
  shop.put("noise.exr", Fate::refused, std::string("\x76\x2f\x31\x01\x02\0\0\0"sv) + noise_bytes);
  shop.put("noise.heic", Fate::refused,
           std::string("\0\0\0\x18"
                       "ftypheic\0\0\0\0mif1heic"sv) +
               noise_bytes);
  shop.put("noise.raf", Fate::refused, "FUJIFILMCCD-RAW 0201" + noise_bytes);
  shop.put("noise.cr3", Fate::refused,
           std::string("\0\0\0\x18"
                       "ftypcrx \0\0\0\1crx isom"sv) +
               noise_bytes);
}

void add_cut_short(Workshop& shop) {
  for (const std::string ending : {".jpg", ".png", ".tif", ".exr", ".heic"}) {
    const std::string whole = shop.bytes_of(ending, noisy());
    for (const std::size_t percent : {3u, 30u, 90u}) {
      if (whole.empty()) continue;
      const std::string name = "cut_to_" + std::to_string(percent) + ending;
      shop.put(name, Fate::refused, whole.substr(0, whole.size() * percent / 100));
    }
  }
}

void add_lying_sizes(Workshop& shop) {
  std::string jpeg = shop.bytes_of(".jpg", noisy());
  const std::size_t frame = jpeg.find("\xff\xc0"sv);
  if (frame != std::string::npos) {
    shop.put("bomb.jpg", Fate::refused, jpeg.replace(frame + 5, 4, "\xff\xdc\xff\xdc"));
  }
  shop.put("bomb.png", Fate::refused, png_of_size(65500, 65500));
  shop.put("absurd.png", Fate::refused, png_of_size(0x7fffffff, 0x7fffffff));
  shop.put("no_pixels.png", Fate::refused, png_of_size(0, 10));
  shop.put("missing_pixels.png", Fate::refused, png_of_size(9000, 9000));
  shop.put("bomb.tif", Fate::refused, tiff_of(65500, 65500, 8, 100));
  shop.put("outside.tif", Fate::refused, tiff_of(100, 100, 0x7fffff00, 10000));
  shop.put("negative.tif", Fate::refused, tiff_of(0xffffffff, 100, 8, 100));
  std::string exr = shop.bytes_of(".exr", {.type = OIIO::TypeDesc::HALF});
  const std::size_t window = exr.find("dataWindow\0box2i\0"sv);
  if (window != std::string::npos) {
    const std::string far = little_endian(2'000'000'000);
    shop.put("bomb.exr", Fate::refused, exr.replace(window + 29, 8, far + far));
  }
}

void add_bad_details(Workshop& shop) {
  const std::string jpeg = shop.bytes_of(".jpg", noisy());
  const std::string loop = std::string("II*\0"sv) + little_endian(8) +
                           tiff_folder({{0x8769, 4, 1, 8}, {0x8825, 4, 1, 8}}, 8);
  shop.put("exif_loop.jpg", Fate::either, jpeg_with_exif(jpeg, loop));
  const std::string huge = std::string("II*\0"sv) + little_endian(8) +
                           tiff_folder({{0x010f, 2, 0xffffffff, 0xfffffff0}}, 0xfffffff0);
  shop.put("exif_huge.jpg", Fate::either, jpeg_with_exif(jpeg, huge));
  shop.put("exif_noise.jpg", Fate::either, jpeg_with_exif(jpeg, random_bytes(2000, 2)));
  shop.put("folder_loop.tif", Fate::either, tiff_of(20, 20, 8, 400, 8) + std::string(400, '\x40'));
  std::string flipped = shop.bytes_of(".png", noisy());
  flipped[flipped.size() / 2] = char(flipped[flipped.size() / 2] ^ 0x10);
  shop.put("flipped_bit.png", Fate::refused, flipped);
  std::string scrambled = jpeg;
  for (std::size_t i = scrambled.size() / 2; i + 100 < scrambled.size(); i += 97)
    scrambled[i] = 0x55;
  shop.put("scrambled.jpg", Fate::either, scrambled);
  shop.put("trailing.jpg", Fate::read, jpeg + random_bytes(5000, 3));
}

void add_unusual(Workshop& shop) {
  shop.put("cmyk.jpg", Fate::read,
           {reinterpret_cast<const char*>(kCmykJpeg.data()), kCmykJpeg.size()});
  PhotoFile cmyk{.channels = 4, .value = noise};
  cmyk.attributes.attribute("tiff:ColorSpace", "CMYK");
  shop.photo("cmyk.tif", Fate::read, cmyk);
  shop.photo("sixteen_bits.png", Fate::read, {.type = OIIO::TypeDesc::UINT16, .value = noise});
  shop.photo("sixteen_bits.tif", Fate::read, {.type = OIIO::TypeDesc::UINT16, .value = noise});
  shop.photo("thirty_two_bits.tif", Fate::read, {.type = OIIO::TypeDesc::UINT32, .value = noise});
  shop.photo("floats.tif", Fate::read, {.type = OIIO::TypeDesc::FLOAT, .value = noise});
  shop.photo("alpha.png", Fate::read, {.channels = 4, .straight_alpha = true, .value = noise});
  shop.photo("grey.png", Fate::read, {.channels = 1, .value = noise});
  shop.photo("grey_alpha.png", Fate::read, {.channels = 2, .value = noise});
  shop.photo("grey.jpg", Fate::read, {.channels = 1, .value = noise});
  shop.photo("seven_channels.tif", Fate::read, {.channels = 7, .value = noise});
  shop.photo("png_called_jpg.jpg", Fate::read, {.plugin = "png", .value = noise});
  shop.photo("jpg_called_tif.tif", Fate::read, {.width = 41, .plugin = "jpeg", .value = noise});
  shop.photo("tiff_called_nef.nef", Fate::either, {.width = 42, .plugin = "tiff", .value = noise});
  shop.photo("one_pixel.png", Fate::refused, {.width = 1, .height = 1});
  shop.photo("ribbon.png", Fate::refused, {.width = 20'000, .height = 10});
  shop.photo("nan.exr", Fate::read, {.type = OIIO::TypeDesc::FLOAT, .value = [](int, int, int) {
                                       return std::numeric_limits<float>::quiet_NaN();
                                     }});
  shop.photo("b\xc3\xa4um 'quoted' $(x).png", Fate::read, {.width = 43, .value = noise});
  shop.photo("-o.png", Fate::read, {.width = 44, .value = noise});
}

}  // namespace

std::vector<DamagedPhoto> make_damaged_photos(const fs::path& folder) {
  Workshop shop(folder);
  add_no_photos(shop);
  add_noise_behind_magic(shop);
  add_cut_short(shop);
  add_lying_sizes(shop);
  add_bad_details(shop);
  add_unusual(shop);
  return shop.photos();
}

}  // namespace bosk
