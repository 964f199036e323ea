#include "core/calibrate/lens_profile.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/error.h"
#include "tests/base/scratch_folder.h"
#include "tests/calibrate/painted_board.h"
#include "tests/photo/refusal.h"

namespace bosk {
namespace {

using testing_cameras::refusal_of;

LensProfile sample() {
  LensProfile profile;
  profile.taken_with = {"Acme", "One", 24.5};
  profile.lens = phone_lens(4000, 3000);
  profile.lens.focal_px.x = 3041.0 / 3.0;  // no short decimal
  profile.rms_px = 0.125;
  profile.boards = 12;
  profile.corners = 648;
  profile.coverage = Image<float>(4, 3, 2.0f);
  profile.uncertainty_px = Image<float>(4, 3, 0.1f);
  return profile;
}

bool contains(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

// What read_lens_profile says of a sample whose JSON was changed.
std::string refusal_after(const std::function<void(nlohmann::json&)>& change) {
  const ScratchFolder folder;
  const auto path = folder / "lens.json";
  save_lens_profile(path, sample());
  nlohmann::json root;
  std::ifstream(path) >> root;
  change(root);
  std::ofstream(path) << root;
  return refusal_of([&] { read_lens_profile(path); });
}

TEST(LensProfile, ComesBackBitByBit) {
  const ScratchFolder folder;
  save_lens_profile(folder / "lens.json", sample());
  const LensProfile back = read_lens_profile(folder / "lens.json");
  EXPECT_EQ(back.lens, sample().lens);
  EXPECT_EQ(back.taken_with, sample().taken_with);
  EXPECT_EQ(back.rms_px, sample().rms_px);
  EXPECT_EQ(back.boards, 12);
  EXPECT_EQ(back.corners, 648);
  EXPECT_EQ(back.coverage, sample().coverage);
  EXPECT_EQ(back.uncertainty_px, sample().uncertainty_px);
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(LensProfile, ACameraWithoutExifAndOddNamesComeBack) {
  const ScratchFolder folder;
  LensProfile profile = sample();
  profile.taken_with = {};
  save_lens_profile(folder / "lens.json", profile);
  EXPECT_EQ(read_lens_profile(folder / "lens.json").taken_with, LensIdentity{});
  profile.taken_with.make = "\xff\xfe";  // no UTF-8
  save_lens_profile(folder / "lens.json", profile);
  EXPECT_NO_THROW(read_lens_profile(folder / "lens.json"));
}

TEST(LensProfile, DamageIsNamed) {
  EXPECT_TRUE(contains(refusal_after([](auto& root) { root.erase("lens"); }), "no \"lens\""));
  EXPECT_TRUE(contains(refusal_after([](auto& root) {
                         root["lens"]["focal_px"] = {0, 1};
                       }),
                       "\"focal_px\""));
  EXPECT_TRUE(
      contains(refusal_after([](auto& root) { root["lens"]["model"] = "box"; }), "no lens model"));
  EXPECT_TRUE(contains(refusal_after([](auto& root) { root["coverage"]["columns"] = 5; }),
                       "a list of 15 numbers"));
  EXPECT_TRUE(contains(refusal_after([](auto& root) { root["boards"] = "many"; }), "whole number"));
  EXPECT_TRUE(contains(refusal_after([](auto& root) { root["bosk_lens_profile"] = 99; }), "newer"));
  EXPECT_TRUE(contains(refusal_after([](auto& root) { root = {1, 2}; }), "no lens profile"));
}

TEST(LensProfile, AFileCutShortOrMissingIsRefused) {
  const ScratchFolder folder;
  const auto path = folder / "lens.json";
  save_lens_profile(path, sample());
  std::string text(std::istreambuf_iterator<char>(std::ifstream(path).rdbuf()), {});
  for (std::size_t kept = 0; kept + 2 < text.size(); kept += 97) {
    std::ofstream(path) << text.substr(0, kept);
    EXPECT_TRUE(contains(refusal_of([&] { read_lens_profile(path); }), "damaged")) << kept;
  }
  EXPECT_THROW(read_lens_profile(folder / "none.json"), Error);
}

TEST(LensForPhoto, ScalesToAnotherSizeOfTheSameShape) {
  const LensProfile profile = sample();
  EXPECT_EQ(lens_for_photo(profile, profile.taken_with, 4000, 3000), profile.lens);
  EXPECT_EQ(lens_for_photo(profile, profile.taken_with, 1414, 1061),
            scaled(profile.lens, 1414, 1061));  // 1060.5 rounded
  const auto cropped = [&] { lens_for_photo(profile, profile.taken_with, 4000, 2250); };
  EXPECT_TRUE(contains(refusal_of(cropped), "cropped"));
  EXPECT_THROW(lens_for_photo(profile, profile.taken_with, 3000, 4000), Error);
}

TEST(LensForPhoto, TakesPhotosOfItsCameraAndFocalLengthAlone) {
  const LensProfile profile = sample();
  const auto refusal = [&](const LensIdentity& photo) {
    return refusal_of([&] { lens_for_photo(profile, photo, 4000, 3000); });
  };
  EXPECT_TRUE(contains(refusal({"Acme", "Two", 24.5}), "Acme Two at 24.50 mm"));
  EXPECT_TRUE(contains(refusal({"Acme", "One", 50.0}), "50 mm"));
  EXPECT_TRUE(contains(refusal({"Acme", "One", 24.6}), "no Error"));  // EXIF rounds
  EXPECT_TRUE(contains(refusal({}), "no Error"));
}

TEST(LensIdentity, IsCalledAsPeopleCallIt) {
  EXPECT_EQ(identity_text({"Canon", "Canon EOS R5", 35.0}), "Canon EOS R5 at 35 mm");
  EXPECT_EQ(identity_text({"samsung", "SM-G990", 5.4}), "samsung SM-G990 at 5.40 mm");
  EXPECT_EQ(identity_text({}), "a camera that EXIF doesn't name");
}

}  // namespace
}  // namespace bosk
