#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/project/presets.h"
#include "tests/base/scratch_folder.h"
#include "tests/ui/workstation/hand.h"
#include "tests/ui/workstation/tiny_project.h"
#include "ui/widgets/keys.h"
#include "ui/workstation/guide.h"

namespace bosk {
namespace {

TEST(StartPage, MakesAProjectInATypedFolder) {
  const ScratchFolder scratch;
  Hand hand;
  hand.click("start/folder");
  hand.type((scratch.path() / "oak").string());
  hand.click("start/make");
  ASSERT_TRUE(hand.workspace().session);
  EXPECT_EQ(hand.workspace().project().name(), "oak");
  EXPECT_EQ(guide_of(hand.workspace(), WorkStep::photos).state, "needs photos");
}

TEST(StartPage, SaysWhyNothingCanBeOpened) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "file") << "no folder";
  Hand hand;
  EXPECT_FALSE(hand.is_enabled("start/open"));
  hand.click("start/folder");
  hand.type((scratch.path() / "file" / "oak").string());
  EXPECT_FALSE(hand.is_enabled("start/open"));
  hand.click("start/make");
  EXPECT_FALSE(hand.workspace().session);
  EXPECT_NE(hand.workspace().start_page.trouble.find("oak"), std::string::npos);
}

TEST(StartPage, RemembersProjects) {
  const ScratchFolder scratch;
  {
    Hand hand({1400, 900}, scratch.path() / "settings");
    hand.click("start/folder");
    hand.type((scratch.path() / "oak").string());
    hand.click("start/make");
  }
  Hand hand({1400, 900}, scratch.path() / "settings");
  hand.click("start/recent/1");
  ASSERT_TRUE(hand.workspace().session);
  EXPECT_EQ(hand.workspace().project().name(), "oak");
}

class OpenShell : public testing::Test {
 protected:
  OpenShell() {
    hand.click("start/folder");
    hand.type((scratch.path() / "oak").string());
    hand.click("start/make");
  }
  const ScratchFolder scratch;
  Hand hand;
};

TEST_F(OpenShell, EveryStepCanBeVisited) {
  for (const WorkStep step : kSteps) {
    hand.click(std::string("step/") + text_of(step).id);
    EXPECT_EQ(hand.workspace().step, step);
  }
}

TEST_F(OpenShell, StepsAreReachedByKey) {
  for (const WorkStep step : kSteps) {
    hand.key('1' + int(step), true);
    EXPECT_EQ(hand.workspace().step, step);
  }
}

TEST_F(OpenShell, EveryStepSaysWhatItNeeds) {
  for (const WorkStep step : kSteps) {
    EXPECT_FALSE(guide_of(hand.workspace(), step).needs.empty()) << text_of(step).name;
  }
}

TEST_F(OpenShell, UndoAndRedoByKeyAndButton) {
  edit(hand.workspace(), option_edit(hand.workspace().project(), "opacity.cell_px", "2.5"));
  hand.frame();
  hand.key('Z', true);
  EXPECT_EQ(hand.workspace().project().recipe.opacity.cell_px, OpacityOptions().cell_px);
  hand.key('Z', true, true);
  EXPECT_EQ(hand.workspace().project().recipe.opacity.cell_px, 2.5);
  hand.click("undo");
  EXPECT_EQ(hand.workspace().project().recipe.opacity.cell_px, OpacityOptions().cell_px);
  hand.click("redo");
  EXPECT_EQ(hand.workspace().project().recipe.opacity.cell_px, 2.5);
}

TEST_F(OpenShell, APresetIsOneEdit) {
  hand.click("step/volume");
  hand.click("preset/fast");
  Recipe fast;
  apply_preset(fast, "fast");
  EXPECT_EQ(hand.workspace().project().recipe.radiance.epochs, fast.radiance.epochs);
  EXPECT_EQ(hand.workspace().session->undo_title(), "preset fast");
  hand.click("preset/fast");  // nothing is left to change
  hand.click("undo");
  EXPECT_EQ(hand.workspace().project().recipe.radiance.epochs, RadianceOptions().epochs);
  EXPECT_FALSE(hand.workspace().session->can_undo());
}

TEST_F(OpenShell, TheListOfKeysComesAndGoes) {
  hand.key(kKeyF1);
  EXPECT_TRUE(hand.sees("keys"));
  hand.key(kKeyF1);
  EXPECT_FALSE(hand.sees("keys"));
}

TEST_F(OpenShell, ScaleIsAskedForByKeyWithinItsRange) {
  for (int i = 0; i < 20; ++i) {
    hand.key(kKeyEqual, true);
    ASSERT_TRUE(hand.workspace().scale_wanted);
    hand.workspace().settings.scale = double(*hand.workspace().scale_wanted);
  }
  EXPECT_EQ(hand.workspace().settings.scale, 3.0);
}

TEST_F(OpenShell, ClosingLeadsBackToTheStartPage) {
  hand.click("close");
  EXPECT_FALSE(hand.workspace().session);
  EXPECT_TRUE(hand.sees("start/folder"));
}

TEST(Workstation, ClosingDuringAJobLosesNothing) {
  const ScratchFolder scratch;
  const Project project = make_tiny_project(scratch.path());
  std::string content;
  {
    Hand hand;
    open_project(hand.workspace(), project.folder);
    ASSERT_TRUE(hand.settle());
    edit(hand.workspace(), option_edit(hand.workspace().project(), "opacity.passes", "2"));
    run_to(hand.workspace(), "pack");
    ASSERT_TRUE(hand.wait_for([&] { return hand.workspace().jobs.now().at(0).fraction > 0.2; }));
    content = option_text(hand.workspace().project().recipe, "opacity.passes");
  }
  Hand hand;
  open_project(hand.workspace(), project.folder);
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(option_text(hand.workspace().project().recipe, "opacity.passes"), content);
  EXPECT_NE(state_of(hand.workspace(), "photo"), StageState::missing);  // finished before the close
  run_to(hand.workspace(), "pack");
  ASSERT_TRUE(hand.settle());
  Progress progress;
  Project untouched = make_tiny_project(scratch.path() / "again");
  untouched.recipe.opacity.passes = 2;
  const bosk::Run run = run_stages(untouched, gather_capture(untouched), {"pack"}, progress);
  EXPECT_EQ(*hand.workspace().results.package, *run.results.package);
}

class RunOfStages : public testing::Test {
 protected:
  RunOfStages() {
    open_project(workspace(), project.folder);
    EXPECT_TRUE(hand.settle());
  }
  Workspace& workspace() { return hand.workspace(); }
  StageState state(const char* stage) { return state_of(workspace(), stage); }
  void wait_until_at_work() {
    ASSERT_TRUE(hand.wait_for([&] {
      const auto jobs = workspace().jobs.now();
      return !jobs.empty() && jobs[0].fraction > 0.2;
    }));
  }
  std::size_t stopped_jobs() {
    const auto& records = workspace().jobs.records();
    return std::size_t(std::count_if(records.begin(), records.end(), [](const JobRecord& record) {
      return record.end != JobRecord::End::done;
    }));
  }

  const ScratchFolder scratch;
  const Project project = make_tiny_project(scratch.path());
  Hand hand;
};

TEST_F(RunOfStages, ALaterStageWaitsForWhatIsAtWork) {
  run_to(workspace(), "radiance");
  wait_until_at_work();
  const int job = workspace().running_job;
  run_to(workspace(), "texture");
  EXPECT_EQ(workspace().running_job, job);
  EXPECT_TRUE(is_running(workspace(), "texture"));
  hand.frame();
  EXPECT_TRUE(hand.sees("job/drop"));
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state("radiance"), StageState::current);
  EXPECT_EQ(state("texture"), StageState::current);
  EXPECT_EQ(stopped_jobs(), 0u);
  EXPECT_FALSE(hand.sees("job/drop"));
}

TEST_F(RunOfStages, WhatWaitsCanBeDropped) {
  run_to(workspace(), "opacity");
  wait_until_at_work();
  run_to(workspace(), "texture");
  hand.frame();
  hand.click("job/drop");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state("opacity"), StageState::current);
  EXPECT_EQ(state("texture"), StageState::missing);
}

TEST_F(RunOfStages, NothingFollowsWhatWasStopped) {
  run_to(workspace(), "radiance");
  wait_until_at_work();
  run_to(workspace(), "texture");
  workspace().jobs.cancel(workspace().running_job);
  ASSERT_TRUE(hand.settle());
  EXPECT_NE(state("texture"), StageState::current);
  EXPECT_FALSE(is_running(workspace(), "texture"));
}

TEST_F(RunOfStages, WorkThatIsOutOfDateIsNotWaitedFor) {
  run_to(workspace(), "radiance");
  wait_until_at_work();
  edit(workspace(), option_edit(workspace().project(), "opacity.passes", "2"));
  run_to(workspace(), "texture");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state("texture"), StageState::current);
  EXPECT_EQ(stopped_jobs(), 1u);
}

}  // namespace
}  // namespace bosk
