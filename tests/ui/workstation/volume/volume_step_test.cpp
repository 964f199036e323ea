#include "ui/workstation/volume/volume_step.h"

#include <gtest/gtest.h>

#include "core/project/run.h"
#include "tests/ui/workstation/hand.h"
#include "tests/ui/workstation/phantom_project.h"

namespace bosk {
namespace {

class VolumeStep : public PhantomStep {
 protected:
  VolumeStep() : PhantomStep("volume") {}
  const VolumeStepState& state() { return hand.workspace().volume; }
  // Opacity and radiance made, and everything drawn.
  void make_volume() {
    hand.click("volume/run_radiance");
    ASSERT_TRUE(hand.settle());
    ASSERT_TRUE(state().look);
  }
};

TEST_F(VolumeStep, ShowsEachStageGrowPassByPass) {
  hand.click("volume/run_radiance");
  ASSERT_TRUE(hand.wait_for([&] { return state().look && state().look->pass > 0; }));
  EXPECT_TRUE(hand.sees("volume/orbit"));
  EXPECT_TRUE(hand.sees("volume/residuals/5"));
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state().passes.at("opacity").size(), 4u);
  const auto& passes = state().passes.at("radiance");
  ASSERT_EQ(passes.size(), 6u);  // 3 on halved photos, 2 on all pixels, 1 last
  for (int i = 0; i < 6; ++i) EXPECT_EQ(passes[std::size_t(i)].pass, i + 1);
  EXPECT_GT(passes.back().psnr_db, passes.front().psnr_db);
  EXPECT_EQ(state().look->pass, 0);  // the finished result
  EXPECT_TRUE(state().look->volume.has_colour);
}

TEST_F(VolumeStep, StopAndKeepLeavesWhatTheCommandLineMakesOfTheSameOptions) {
  edit(hand.workspace(), option_edit(hand.workspace().project(), "radiance.epochs", "100"));
  hand.frame(2);
  hand.click("volume/run_radiance");
  ASSERT_TRUE(
      hand.wait_for([&] { return state().look && state().look->stage == "radiance"; }, 30.0));
  hand.click("volume/stop");
  ASSERT_TRUE(hand.settle());
  const Project& project = hand.workspace().project();
  EXPECT_GT(project.recipe.radiance.stop_after, 0);
  EXPECT_LT(project.recipe.radiance.stop_after, 104);
  EXPECT_EQ(state_of(hand.workspace(), "radiance"), StageState::current);
  Project beside = project;
  beside.folder = scratch() / "beside";
  Progress progress;
  const bosk::Run run = run_stages(beside, gather_capture(project), {"radiance"}, progress);
  EXPECT_EQ(run.results.radiance->extinction, hand.workspace().results.radiance->extinction);
  EXPECT_EQ(run.results.radiance->colour, hand.workspace().results.radiance->colour);
  // Undone, the whole is asked for again
  hand.click("undo");
  EXPECT_EQ(state_of(hand.workspace(), "radiance"), StageState::outdated);
}

TEST_F(VolumeStep, AStageThatWasStoppedIsMadeWholeOnDemand) {
  edit(hand.workspace(), option_edit(hand.workspace().project(), "opacity.stop_after", "1"));
  hand.frame();
  hand.click("volume/run_opacity");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(hand.workspace().results.opacity->level(), 5);
  hand.click("volume/whole_opacity");
  EXPECT_EQ(state_of(hand.workspace(), "opacity"), StageState::outdated);
  hand.click("volume/run_opacity");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(hand.workspace().results.opacity->level(), 6);
}

TEST_F(VolumeStep, ResidualsChooseThePhotoThatIsCompared) {
  make_volume();
  hand.click("volume/residuals/4");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state().photo, 4);
  EXPECT_EQ(state().photo_picture.shown.photo, 4);
  const Camera& camera = state().look->cameras[4];
  EXPECT_EQ(state().photo_picture.pixels.height(), camera.lens.height_px);
  EXPECT_TRUE(hand.sees("volume/photo"));
}

TEST_F(VolumeStep, DraggingWalksAroundTheVolume) {
  make_volume();
  const double before = state().orbit.azimuth;
  const Image<glm::u8vec4> picture = state().orbit_picture.pixels;
  const ImVec2 middle = hand.at("volume/orbit").middle();
  hand.drag(middle, {middle.x + 100, middle.y});
  ASSERT_TRUE(hand.settle());
  EXPECT_NEAR(state().orbit.azimuth, before - 1.0, 1e-6);  // 0.01 a point
  EXPECT_NE(state().orbit_picture.pixels, picture);
  EXPECT_EQ(state().orbit_picture.shown.azimuth, state().orbit.azimuth);
}

TEST_F(VolumeStep, SlicesFollowTheirSliders) {
  make_volume();
  const int uploads = hand.textures().uploads;
  const Landmark slider = hand.at("volume/cut_z");
  hand.click_at({slider.least.x + 0.25f * (slider.most.x - slider.least.x), slider.middle().y});
  EXPECT_NEAR(state().cut.z, 0.25, 0.1);  // the grab is a tenth of so short a slider
  EXPECT_EQ(state().cut.x, 0.5);
  EXPECT_GT(hand.textures().uploads, uploads);
}

TEST_F(VolumeStep, OptionsAreEditsOfTheNextRun) {
  make_volume();
  const int subsets = hand.workspace().project().recipe.opacity.subsets;
  edit(hand.workspace(), option_edit(hand.workspace().project(), "opacity.subsets", "4"));
  hand.frame();
  EXPECT_TRUE(hand.sees("options/opacity.cell_px"));
  EXPECT_EQ(state_of(hand.workspace(), "radiance"), StageState::outdated);
  EXPECT_TRUE(state().look);  // the old one stays until the next run
  hand.click("undo");
  EXPECT_EQ(hand.workspace().project().recipe.opacity.subsets, subsets);
  EXPECT_EQ(state_of(hand.workspace(), "radiance"), StageState::current);
}

TEST_F(VolumeStep, OpenedAgainShowsWhatIsFinished) {
  make_volume();
  const std::filesystem::path folder = hand.workspace().project().folder;
  close_project(hand.workspace());
  open_project(hand.workspace(), folder);
  hand.frame();
  hand.click("step/volume");
  ASSERT_TRUE(hand.settle());
  ASSERT_TRUE(state().look);
  EXPECT_EQ(state().look->stage, "radiance");
  EXPECT_EQ(state().look->residuals.size(), 6u);
  hand.click("volume/show_opacity");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state().look->stage, "opacity");
}

}  // namespace
}  // namespace bosk
