#include "core/project/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/base/error.h"
#include "core/project/cache.h"
#include "core/project/new_project.h"
#include "tests/project/tiny_capture_test.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

class RunStages : public TinyCaptureTest {
 protected:
  static Project project_at(const fs::path& capture, const fs::path& folder) {
    const NewProject wanted{
        folder, {capture / "photos"}, capture / "transforms.json", capture / "mattes", {}};
    Recipe recipe;
    recipe.opacity.finest_level = 5;
    return make_project(wanted, recipe, true, Progress());
  }
  static Project project() { return project_at(*scratch / "capture", *scratch / "project"); }
};

std::vector<std::string> names_of(const Photos& photos) {
  std::vector<std::string> names;
  for (const Photo& photo : photos) names.push_back(photo.name);
  return names;
}

bool computed(const bosk::Run& run, const std::string& stage) {
  return std::any_of(run.times.begin(), run.times.end(), [&](const StageTime& time) {
    return time.stage == stage && !time.from_cache;
  });
}

void damage(const fs::path& file) {
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(std::streamoff(fs::file_size(file) / 2));
  stream.put('\x55').put('\x55');
}

TEST_F(RunStages, KeysDoNotDependOnPaths) {
  const Project here = project();
  fs::copy(*scratch / "capture", *scratch / "elsewhere", fs::copy_options::recursive);
  const Project there = project_at(*scratch / "elsewhere", *scratch / "deep");
  Recipe recipe;
  EXPECT_EQ(stage_key(gather_capture(here), recipe, "pack"),
            stage_key(gather_capture(there), recipe, "pack"));
}

TEST_F(RunStages, AnOptionChangesOnlyTheKeysDownstream) {
  const Capture capture = gather_capture(project());
  Recipe plain, other;
  other.radiance.epochs += 1;
  for (const std::string stage : {"photo", "view", "matte", "opacity"}) {
    EXPECT_EQ(stage_key(capture, plain, stage), stage_key(capture, other, stage)) << stage;
  }
  for (const std::string stage : {"radiance", "texture", "compress", "pack"}) {
    EXPECT_NE(stage_key(capture, plain, stage), stage_key(capture, other, stage)) << stage;
  }
}

TEST_F(RunStages, AnotherMatteChangesTheKeysFromTheMattesOn) {
  const Capture capture = gather_capture(project());
  Capture other = capture;
  other.mattes[2].content.low ^= 1;
  const Recipe recipe;
  EXPECT_EQ(stage_key(capture, recipe, "photo"), stage_key(other, recipe, "photo"));
  EXPECT_NE(stage_key(capture, recipe, "matte"), stage_key(other, recipe, "matte"));
  EXPECT_NE(stage_key(capture, recipe, "pack"), stage_key(other, recipe, "pack"));
}

TEST_F(RunStages, PhotosThatAreLeftOutReachNoStage) {
  const Project project = this->project();
  Capture capture = gather_capture(project);
  capture.left_out = {"001", "004"};
  Progress progress;
  const auto run = run_stages(project, capture, {"view", "matte"}, progress);
  const std::vector<std::string> kept = {"000", "002", "003", "005"};
  EXPECT_EQ(names_of(*run.results.views), kept);
  ASSERT_EQ(run.results.mattes->size(), kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ((*run.results.mattes)[i].name, kept[i]);
  }
  const Capture whole = gather_capture(project);
  EXPECT_NE(stage_key(whole, project.recipe, "view"), stage_key(capture, project.recipe, "view"));
  EXPECT_NE(stage_key(whole, project.recipe, "matte"), stage_key(capture, project.recipe, "matte"));
}

TEST_F(RunStages, TakeWhatIsFinishedFromTheCache) {
  const Project project = this->project();
  const Capture capture = gather_capture(project);
  Progress progress;
  run_stages(project, capture, {"opacity"}, progress);
  EXPECT_TRUE(is_finished(project, capture, "opacity"));
  const auto again = run_stages(project, capture, {"opacity"}, progress);
  ASSERT_EQ(again.times.size(), 1u);
  EXPECT_TRUE(again.times[0].from_cache);
}

TEST_F(RunStages, RecomputeADamagedEntryToTheSameResult) {
  const Project project = this->project();
  const Capture capture = gather_capture(project);
  Progress progress;
  const auto first = run_stages(project, capture, {"opacity"}, progress);
  const Cache cache(project.cache_folder());
  damage(cache.path("opacity", stage_key(capture, project.recipe, "opacity")));
  damage(cache.path("matte", stage_key(capture, project.recipe, "matte")));
  const auto second = run_stages(project, capture, {"opacity"}, progress);
  EXPECT_TRUE(computed(second, "opacity"));
  EXPECT_TRUE(computed(second, "matte"));
  EXPECT_FALSE(computed(second, "photo"));
  EXPECT_EQ(first.results.opacity->extinction, second.results.opacity->extinction);
}

TEST_F(RunStages, KeepFinishedStagesWhenCancelled) {
  Project project = this->project();
  project.folder = *scratch / "cancelled";
  const Capture capture = gather_capture(this->project());
  Progress* running = nullptr;
  Progress progress(
      [&](const ProgressReport& report) {
        if (report.part == "Opacity") running->cancel();
      },
      {});
  running = &progress;
  EXPECT_THROW(run_stages(project, capture, {"opacity"}, progress), Cancelled);
  EXPECT_TRUE(is_finished(project, capture, "matte"));
  EXPECT_FALSE(is_finished(project, capture, "opacity"));
}

TEST_F(RunStages, GoOnAfterAKillToTheSameBits) {
  const Project whole = project();
  Project broken = whole;
  broken.folder = *scratch / "broken";
  const Capture capture = gather_capture(whole);
  Progress progress;
  const auto at_once = run_stages(whole, capture, {"matte", "opacity"}, progress);
  run_stages(broken, capture, {"matte"}, progress);
  const auto resumed = run_stages(broken, capture, {"matte", "opacity"}, progress);
  EXPECT_FALSE(computed(resumed, "matte"));
  EXPECT_EQ(at_once.results.opacity->extinction, resumed.results.opacity->extinction);
}

std::vector<std::byte> stored_bytes(const RadianceVolume& volume) {
  BinaryWriter writer;
  write(writer, volume);
  return writer.bytes();
}

TEST_F(RunStages, ToldToStopGiveTheBytesOfStopAfterAndKeepThemUnderItsKey) {
  Project told = project(), asked = told;
  told.folder = *scratch / "told";
  asked.folder = *scratch / "asked";
  const Capture capture = gather_capture(told);
  Progress progress;
  RunWatchers watchers;
  watchers.radiance = [](const RadiancePreview& preview) { return preview.epoch < 2; };
  const auto stopped = run_stages(told, capture, {"radiance"}, progress, {}, watchers);
  EXPECT_EQ(stopped.recipe.radiance.stop_after, 2);
  EXPECT_FALSE(is_finished(told, capture, "radiance"));  // the whole of it isn't

  asked.recipe.radiance.stop_after = 2;
  const auto fresh = run_stages(asked, capture, {"radiance"}, progress);
  EXPECT_EQ(stored_bytes(*stopped.results.radiance), stored_bytes(*fresh.results.radiance));
  told.recipe = stopped.recipe;
  EXPECT_TRUE(is_finished(told, capture, "radiance"));
}

TEST_F(RunStages, GoOnBehindAStageThatWasStopped) {
  Project project = this->project();
  project.recipe.opacity.passes = 2;
  project.folder = *scratch / "stopped";
  const Capture capture = gather_capture(project);
  Progress progress;
  RunWatchers watchers;
  watchers.opacity = [](const OpacityPreview&) { return false; };
  const auto run = run_stages(project, capture, {"opacity", "radiance"}, progress, {}, watchers);
  EXPECT_EQ(run.recipe.opacity.stop_after, 1);
  project.recipe = run.recipe;
  EXPECT_TRUE(is_finished(project, capture, "opacity"));
  EXPECT_TRUE(is_finished(project, capture, "radiance"));
}

TEST_F(RunStages, ToldToStopAfterTheLastIterationAreSimplyFinished) {
  Project project = this->project();
  project.folder = *scratch / "last";
  const Capture capture = gather_capture(project);
  Progress progress;
  RunWatchers watchers;
  watchers.opacity = [](const OpacityPreview& preview) {
    return preview.iteration < preview.planned;
  };
  const auto run = run_stages(project, capture, {"opacity"}, progress, {}, watchers);
  EXPECT_EQ(run.recipe.opacity.stop_after, 0);
  EXPECT_TRUE(is_finished(project, capture, "opacity"));
}

TEST_F(RunStages, GuessTheTreeWithoutMattesAndStrokesAndSaySo) {
  Project project = this->project();
  project.mattes.clear();
  std::string warning;
  Progress progress({}, [&](const std::string& sentence) { warning += sentence; });
  const auto run = run_stages(project, gather_capture(project), {"view", "matte"}, progress);
  EXPECT_EQ(run.results.mattes->size(), run.results.views->size());
  EXPECT_NE(warning.find("the tree was guessed"), std::string::npos);
}

TEST_F(RunStages, ACaptureWithoutMatchingCamerasIsRefused) {
  const Project project = this->project();
  Camera stranger;
  stranger.name = "unrelated";
  try {
    gather_capture(project, {stranger});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no camera of that name"), std::string::npos);
  }
}

}  // namespace
}  // namespace bosk
