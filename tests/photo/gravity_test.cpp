#include "core/photo/gravity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "core/photo/decode.h"
#include "tests/base/scratch_folder.h"
#include "tests/photo/photo_writer.h"

namespace bosk {
namespace {

// Big-endian TIFF as in EXIF: a directory of entries, those over four bytes after it.
struct Entry {
  int tag = 0, type = 0, count = 0;
  std::string bytes;
};

std::string number(unsigned value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text.push_back(char((value >> (8 * i)) & 0xffu));
  return text;
}

std::string directory(const std::vector<Entry>& entries, std::size_t at) {
  std::string table = number(unsigned(entries.size()), 2), rest;
  const std::size_t rest_at = at + 2 + 12 * entries.size() + 4;
  for (const Entry& entry : entries) {
    table += number(unsigned(entry.tag), 2) + number(unsigned(entry.type), 2) +
             number(unsigned(entry.count), 4);
    if (entry.bytes.size() <= 4) {
      table += entry.bytes + std::string(4 - entry.bytes.size(), '\0');
    } else {
      table += number(unsigned(rest_at + rest.size()), 4);
      rest += entry.bytes;
    }
  }
  return table + std::string(4, '\0') + rest;
}

Entry text_entry(int tag, std::string text) {
  text.push_back('\0');
  return {tag, 2, int(text.size()), text};
}

std::string maker_note(const glm::dvec3& gravity) {
  std::string rationals;
  for (int i = 0; i < 3; ++i) {
    rationals += number(unsigned(int(std::lround(gravity[i] * 1e6))), 4) + number(1'000'000, 4);
  }
  const std::string head("Apple iOS\0\0\1MM", 14);
  return head + directory({{8, 10, 3, rationals}}, head.size());
}

struct PhonePhoto {
  std::size_t note_bytes = std::string::npos;  // the note is cut there
  std::string make = "Apple", lens = "iPhone SE (2nd generation) back camera 3.99mm f/1.8";
  glm::dvec3 gravity{-0.0603, -0.8702, -0.4828};  // of an upright photo taken a little downwards
};

std::string exif_of(const PhonePhoto& phone) {
  const std::string head = std::string("MM\0*", 4) + number(8, 4);
  const std::string note = maker_note(phone.gravity).substr(0, phone.note_bytes);
  const auto whole = [&](std::size_t exif_at) {
    return directory({text_entry(0x010f, phone.make),
                      {0x0112, 3, 1, number(6, 2)},
                      {0x8769, 4, 1, number(unsigned(exif_at), 4)}},
                     head.size());
  };
  const std::size_t exif_at = head.size() + whole(0).size();
  return head + whole(exif_at) +
         directory({{0x927c, 7, int(note.size()), note}, text_entry(0xa434, phone.lens)}, exif_at);
}

// Puts the EXIF segment right behind the start of a JPEG.
void write_phone_photo(const std::filesystem::path& path, const PhonePhoto& phone) {
  ASSERT_TRUE(write_photo(path, {}));
  std::ifstream in(path, std::ios::binary);
  std::string jpeg{std::istreambuf_iterator<char>(in), {}};
  in.close();
  const std::string body = std::string("Exif\0\0", 6) + exif_of(phone);
  jpeg.insert(2, "\xff\xe1" + number(unsigned(body.size() + 2), 2) + body);
  std::ofstream(path, std::ios::binary) << jpeg;
}

std::optional<glm::dvec3> up_of(const PhonePhoto& phone) {
  const ScratchFolder folder;
  write_phone_photo(folder / "phone.jpg", phone);
  const PhotoMetadata metadata = decode_photo(folder / "phone.jpg", {}, Progress()).metadata;
  EXPECT_EQ(metadata.orientation, 6);
  return metadata.up_in_camera;
}

// The pixels of an upright photo are stored lying, tops to the left: up is along -x there.
TEST(Gravity, ComesWithAPhonesPhoto) {
  const auto up = up_of({});
  ASSERT_TRUE(up);
  EXPECT_NEAR(up->x, -0.8725, 1e-3);  // the note's length is 0.997
  EXPECT_NEAR(up->y, -0.0605, 1e-3);
  EXPECT_NEAR(up->z, -0.4841, 1e-3);  // a camera that looks down has up behind it
}

TEST(Gravity, IsNoneWhereNothingCanBeSaid) {
  EXPECT_FALSE(up_of({.gravity = {-0.5, -1.1, 0.4}})) << "shaken";
  EXPECT_FALSE(up_of({.lens = "iPhone SE (2nd generation) front camera 2.87mm f/2.2"}));
  EXPECT_FALSE(up_of({.make = "Other"}));
  const ScratchFolder folder;
  ASSERT_TRUE(write_photo(folder / "bare.jpg", {}));
  EXPECT_FALSE(decode_photo(folder / "bare.jpg", {}, Progress()).metadata.up_in_camera);
}

// The note is 56 bytes long: three fractions of 8 bytes behind a directory of one entry.
TEST(Gravity, IsNoneInANoteThatIsCutAnywhere) {
  const ScratchFolder folder;
  for (std::size_t bytes = 5; bytes < 56; ++bytes) {
    write_phone_photo(folder / "cut.jpg", {.note_bytes = bytes});
    EXPECT_FALSE(up_from_maker_note(folder / "cut.jpg")) << bytes;
  }
  write_phone_photo(folder / "whole.jpg", {.note_bytes = 56});
  EXPECT_TRUE(up_from_maker_note(folder / "whole.jpg"));
}

// Held lying with the top to the left, a photo is stored as it is seen: up is along -y.
TEST(Gravity, FollowsHowThePhoneIsHeld) {
  const glm::dvec3 lying = up_from_phone_gravity({-1.0, 0.0, 0.0}).value();
  EXPECT_EQ(lying, glm::dvec3(0.0, -1.0, 0.0));
  const glm::dvec3 to_the_ground = up_from_phone_gravity({0.0, 0.0, -1.0}).value();
  EXPECT_EQ(to_the_ground, glm::dvec3(0.0, 0.0, -1.0));
  EXPECT_FALSE(up_from_phone_gravity({0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace bosk
