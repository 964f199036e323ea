#include "core/matte/matte.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "core/base/error.h"
#include "leafy_scene.h"

namespace bosk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Told {
  Mattes mattes;
  std::vector<std::string> warnings;
};

Told matted(const Photos& photos, const Scribbles& scribbles, const MatteOptions& options = {}) {
  Told told;
  Progress progress({}, [&](const std::string& sentence) { told.warnings.push_back(sentence); });
  told.mattes = matte_photos(photos, scribbles, options, progress);
  return told;
}

Told matted(const LeafyScene& scene) { return matted({scene.photo}, {{"tree", scene.strokes}}); }

std::string complaint_about(const Photos& photos, const Scribbles& scribbles) {
  try {
    matted(photos, scribbles);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void expect_sound(const Mattes& mattes) {
  for (const Matte& matte : mattes) {
    for (const glm::vec4& pixel : matte.rgba.pixels()) {
      for (int c = 0; c < 4; ++c) ASSERT_TRUE(pixel[c] >= 0.0f && pixel[c] <= 1.0f) << matte.name;
    }
  }
}

LeafyScene named(LeafyScene scene, const std::string& name) {
  scene.photo.name = name;
  return scene;
}

// Real and rendered trees at forty times the pixels: 0.02 to 0.03 of mean error with a fair number
// of strokes.
constexpr double kFairError = 0.03;

TEST(MattePhotos, SeparateATreeFromItsBackground) {
  const LeafyScene scene = leafy_scene();
  const Told told = matted(scene);
  ASSERT_EQ(told.mattes.size(), 1u);
  expect_sound(told.mattes);
  EXPECT_LT(mean_absolute_error(alpha_of(told.mattes[0].rgba), scene.alpha), kFairError);
  EXPECT_THAT(told.warnings, IsEmpty());
}

// In pixels, larger of both axes; looked for as far as it matters.
constexpr int kClearOf = 3;
int distance_to_tree(const LeafyScene& scene, int x, int y) {
  int nearest = kClearOf + 1;
  for (int dy = -kClearOf; dy <= kClearOf; ++dy) {
    for (int dx = -kClearOf; dx <= kClearOf; ++dx) {
      const int px = std::clamp(x + dx, 0, 179), py = std::clamp(y + dy, 0, 139);
      if (scene.alpha(px, py) > 0.0f)
        nearest = std::min(nearest, std::max(std::abs(dx), std::abs(dy)));
    }
  }
  return nearest;
}

TEST(MattePhotos, LeaveNoHazeOverTheSky) {
  const LeafyScene scene = leafy_scene();
  const Told told = matted(scene);
  for (int y = 0; y < 112; ++y) {  // down to the horizon; strokes show the uppermost tenth alone
    for (int x = 0; x < 180; ++x) {
      if (distance_to_tree(scene, x, y) > kClearOf) {
        ASSERT_EQ(told.mattes[0].rgba(x, y).a, 0.0f) << x << ", " << y;
      }
    }
  }
}

TEST(MattePhotos, ServePhotosWithoutStrokes) {
  const LeafyScene first = named(leafy_scene(), "a"),
                   second = named(leafy_scene({.leaf_seed = 2}), "b");
  const Told told = matted({second.photo, first.photo}, {{"a", first.strokes}});
  ASSERT_EQ(told.mattes.size(), 2u);
  EXPECT_EQ(told.mattes[0].name, "b");
  EXPECT_LT(mean_absolute_error(alpha_of(told.mattes[0].rgba), second.alpha), 1.5 * kFairError);
  EXPECT_THAT(told.warnings, IsEmpty());
}

TEST(MattePhotos, ServePhotosOfAnotherExposureAndWhiteBalance) {
  const LeafyScene first = named(leafy_scene(), "a");
  const LeafyScene second = named(leafy_scene({.gain = {0.64f, 0.6f, 0.54f}, .leaf_seed = 2}), "b");
  const Told told = matted({first.photo, second.photo}, {{"a", first.strokes}});
  EXPECT_LT(mean_absolute_error(alpha_of(told.mattes[1].rgba), second.alpha), 1.5 * kFairError);
}

TEST(MattePhotos, ServePhotosOfAnotherSize) {
  const LeafyScene first = named(leafy_scene(), "a");
  const LeafyScene second = named(leafy_scene({.width = 131, .height = 101, .leaf_seed = 3}), "b");
  const Told told = matted({first.photo, second.photo}, {{"a", first.strokes}});
  EXPECT_LT(mean_absolute_error(alpha_of(told.mattes[1].rgba), second.alpha), 2.0 * kFairError);
}

TEST(MattePhotos, WarnOfAPhotoThatTheStrokesDoNotFit) {
  const LeafyScene first = named(leafy_scene(), "a");
  LeafyScene strange = named(leafy_scene(), "b");
  for (int y = 0; y < 140; ++y) {
    for (int x = 0; x < 180; ++x)
      strange.photo.srgb(x, y) = glm::vec3(0.9f, 0.1f * float(x % 3), 0.6f);
  }
  EXPECT_THAT(matted({first.photo, strange.photo}, {{"a", first.strokes}}).warnings,
              testing::Contains(testing::AllOf(HasSubstr("photo b"), HasSubstr("draw"))));
}

TEST(MattePhotos, CopeWithStrokesThatRunOverGaps) {
  LeafyScene scene = leafy_scene();
  for (int x = 40; x < 140; ++x)
    scene.strokes(x, 40) = 255;  // straight across the crown, gaps and all
  EXPECT_LT(mean_absolute_error(alpha_of(matted(scene).mattes[0].rgba), scene.alpha),
            1.3 * kFairError);
}

TEST(MattePhotos, CopeWithASaturatedSky) {
  const LeafyScene scene = leafy_scene({.sky = 3.0f});
  const Told told = matted(scene);
  expect_sound(told.mattes);
  EXPECT_LT(mean_absolute_error(alpha_of(told.mattes[0].rgba), scene.alpha), 2.0 * kFairError);
}

TEST(MattePhotos, CopeWithStrokesOfASinglePixel) {
  LeafyScene scene = leafy_scene();
  scene.strokes = Image<std::uint8_t>(180, 140, kNoStroke);
  scene.strokes(90, 100) = kForegroundStroke;
  scene.strokes(5, 5) = kBackgroundStroke;
  expect_sound(matted(scene).mattes);
}

TEST(MattePhotos, CopeWithAPhotoOfOneColour) {
  LeafyScene scene = leafy_scene();
  scene.photo.srgb = Image<glm::vec3>(180, 140, glm::vec3(0.5f));
  expect_sound(matted(scene).mattes);
}

TEST(MattePhotos, CopeWithAPhotoOfOnePixelAndARowOfTwo) {
  const LeafyScene scene = named(leafy_scene(), "a");
  Photo dot = scene.photo, pair = scene.photo;
  dot.name = "dot";
  dot.srgb = Image<glm::vec3>(1, 1, glm::vec3(0.2f));
  pair.name = "pair";
  pair.srgb = Image<glm::vec3>(2, 1, glm::vec3(0.9f));
  pair.srgb(0, 0) = glm::vec3(0.1f, 0.3f, 0.1f);
  Image<std::uint8_t> strokes(2, 1, kForegroundStroke);
  strokes(1, 0) = kBackgroundStroke;
  const Told told = matted({dot, pair}, {{"pair", strokes}});
  ASSERT_EQ(told.mattes.size(), 2u);
  expect_sound(told.mattes);
  EXPECT_EQ(told.mattes[1].rgba(0, 0).a, 1.0f);
  EXPECT_EQ(told.mattes[1].rgba(1, 0).a, 0.0f);
}

TEST(MattePhotos, WarnOfMattesThatAreClearOrOpaqueEverywhere) {
  const LeafyScene scene = named(leafy_scene(), "a");
  LeafyScene sky = scene, leaf = scene;
  sky.photo.name = "sky";
  leaf.photo.name = "leaf";
  sky.photo.srgb = Image<glm::vec3>(180, 140, scene.photo.srgb(5, 8));
  leaf.photo.srgb = Image<glm::vec3>(180, 140, scene.photo.srgb(90, 100));
  const Told told = matted({scene.photo, sky.photo, leaf.photo}, {{"a", scene.strokes}});
  EXPECT_THAT(told.warnings,
              testing::Contains(testing::AllOf(HasSubstr("sky"), HasSubstr("clear everywhere"))));
  EXPECT_THAT(told.warnings,
              testing::Contains(testing::AllOf(HasSubstr("leaf"), HasSubstr("opaque everywhere"))));
}

TEST(MattePhotos, RefuseMissingOrOneSidedStrokes) {
  const LeafyScene scene = leafy_scene();
  EXPECT_THAT(complaint_about({scene.photo}, {}), HasSubstr("no photo has strokes"));
  EXPECT_THAT(complaint_about({scene.photo}, {{"other", scene.strokes}}),
              HasSubstr("no photo has strokes"));
  EXPECT_THAT(complaint_about({scene.photo}, {{"tree", Image<std::uint8_t>(180, 140, 255)}}),
              HasSubstr("tree"));
  EXPECT_THAT(complaint_about({scene.photo}, {{"tree", Image<std::uint8_t>(9, 9, 255)}}),
              HasSubstr("size"));
  Photo without_pixels = scene.photo;
  without_pixels.srgb = {};
  EXPECT_THAT(complaint_about({without_pixels}, {{"tree", scene.strokes}}), HasSubstr("no pixels"));
}

// A hedge of the tree's colours in the sky's lower corner.
LeafyScene with_hedge(LeafyScene scene) {
  for (int y = 80; y < 110; ++y) {
    for (int x = 4; x < 34; ++x)
      scene.photo.srgb(x, y) = scene.photo.srgb(75 + x % 15, 50 + y % 15);
  }
  return scene;
}

double mean_alpha_of_hedge(const Matte& matte) {
  double sum = 0.0;
  for (int y = 80; y < 110; ++y) {
    for (int x = 4; x < 34; ++x) sum += matte.rgba(x, y).a;
  }
  return sum / (30.0 * 30.0);
}

TEST(MattePhotos, TakeStrokesOfOneKindAsCorrections) {
  const LeafyScene first = named(leafy_scene(), "a"),
                   second = with_hedge(named(leafy_scene({.leaf_seed = 2}), "b"));
  const Photos photos{first.photo, second.photo};
  Image<std::uint8_t> black(180, 140, kNoStroke);
  for (int y = 93; y < 98; ++y) {
    for (int x = 8; x < 30; ++x) black(x, y) = kBackgroundStroke;
  }
  const Mattes before = matted(photos, {{"a", first.strokes}}).mattes;
  const Mattes after = matted(photos, {{"a", first.strokes}, {"b", black}}).mattes;
  EXPECT_GT(mean_alpha_of_hedge(before[1]), 0.5);
  EXPECT_LT(mean_alpha_of_hedge(after[1]), 0.1);
  EXPECT_LT(mean_absolute_error(alpha_of(after[1].rgba), second.alpha), 1.5 * kFairError);
  EXPECT_EQ(after[0].rgba, before[0].rgba);  // what the other teaches is as it was
}

TEST(MattePhotos, SameWithOneThreadAndMany) {
  const LeafyScene first = named(leafy_scene(), "a"),
                   second = named(leafy_scene({.leaf_seed = 2}), "b");
  const auto with_threads = [&](std::size_t count) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    return matted({first.photo, second.photo}, {{"a", first.strokes}}).mattes;
  };
  const Mattes one = with_threads(1), many = with_threads(8);
  EXPECT_EQ(one[0].rgba, many[0].rgba);
  EXPECT_EQ(one[1].rgba, many[1].rgba);
}

TEST(MattePhotos, StopWhenAsked) {
  const LeafyScene scene = leafy_scene();
  Photos photos;
  for (const char* name : {"a", "b", "c", "d", "e"}) photos.push_back(named(scene, name).photo);
  // Listeners hear of every step that begins; the last photo's matte begins at 0.9
  for (const double when : {0.0, 0.15, 0.3, 0.5, 0.9}) {
    Progress* job = nullptr;
    Progress progress(
        [&](const ProgressReport& report) {
          if (report.fraction >= when) job->cancel();
        },
        {});
    job = &progress;
    EXPECT_THROW(matte_photos(photos, {{"a", scene.strokes}}, {}, progress), Cancelled) << when;
  }
}

TEST(MattePhotos, ReportFractionsThatGrow) {
  const LeafyScene scene = leafy_scene();
  std::vector<double> fractions;
  Progress progress([&](const ProgressReport& report) { fractions.push_back(report.fraction); },
                    {});
  matte_photos({scene.photo}, {{"tree", scene.strokes}}, {}, progress);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_LE(fractions.back(), 1.0);
}

TEST(MatteFromAlpha, AddsTheTreesOwnColour) {
  const LeafyScene scene = leafy_scene();
  Progress progress;
  const Matte matte = matte_from_alpha(scene.photo, scene.alpha, progress);
  EXPECT_EQ(matte.name, "tree");
  EXPECT_EQ(alpha_of(matte.rgba), scene.alpha);
  double brightest_photo = 0.0,
         brightest_matte = 0.0;  // half-covered pixels: the sky shines through the photo
  for (std::size_t i = 0; i < scene.alpha.size(); ++i) {
    if (scene.alpha.data()[i] < 0.3f || scene.alpha.data()[i] > 0.7f) continue;
    brightest_photo += scene.photo.srgb.data()[i].b;
    brightest_matte += matte.rgba.data()[i].b;
  }
  EXPECT_LT(brightest_matte, 0.5 * brightest_photo);
}

TEST(MatteCache, ReadsBackWhatItWrote) {
  const Mattes mattes{{"a", Image<glm::vec4>(3, 2, glm::vec4(0.25f))}, {"b", {}}};
  BinaryWriter writer;
  write(writer, mattes);
  BinaryReader reader(writer.bytes());
  const Mattes read = read_mattes(reader);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].name, "a");
  EXPECT_EQ(read[0].rgba, mattes[0].rgba);
  EXPECT_TRUE(read[1].rgba.empty());
  EXPECT_TRUE(reader.at_end());
}

TEST(MatteCache, RefusesEveryTruncation) {
  BinaryWriter writer;
  write(writer, Mattes{{"a", Image<glm::vec4>(3, 2, glm::vec4(0.25f))}});
  for (std::size_t size = 0; size < writer.bytes().size(); ++size) {
    BinaryReader reader(std::span(writer.bytes()).first(size));
    EXPECT_THROW(read_mattes(reader), Error) << size;
  }
}

TEST(MatteOptions, DescribeDefaultsWithinTheirRanges) {
  MatteOptions options;
  for (const Option& option : describe(options)) {
    EXPECT_NO_THROW(set_value(option, value_text(option))) << option.name;
    EXPECT_FALSE(option.help.empty());
  }
}

}  // namespace
}  // namespace bosk
