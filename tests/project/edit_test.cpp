#include "core/project/edit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/project/edit_bytes.h"
#include "tests/base/scratch_folder.h"
#include "tests/project/random_edits.h"

namespace bosk {
namespace {

const Stroke kStroke{StrokeKind::foreground, 8.0, {{1.0, 2.0}, {3.5, 4.0}}};
const Stroke kOther{StrokeKind::background, 8.0, {{1.0, 2.0}}};

const HandSighting kHere{true, {12.25, -0.5}}, kNotThere{false, {}};
const SetSighting kMoved{"oak", "red", std::nullopt, kHere};
const Measurements kMeasured{
    {{"red", "blue", 2.35, 0.003}}, {{"red", 1.5, 0.01}}, {{"post", {1.0, -2.0, 0.25}, 0.02}}};

TEST(Edit, RevertUndoesApply) {
  const ScratchFolder folder;
  Project project = saved_project(folder.path());
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const std::string before = content_of(project);
    const Edit edit = random_edit(random, project);
    apply(edit, project);
    const std::string after = content_of(project);
    revert(edit, project);
    ASSERT_EQ(content_of(project), before) << title(edit);
    apply(edit, project);
    ASSERT_EQ(content_of(project), after) << title(edit);
  }
}

TEST(Edit, OfAPhotoWithoutStrokesLeavesNoTrace) {
  Project project;
  const Edit edit = AddStroke{"oak", kStroke};
  apply(edit, project);
  EXPECT_EQ(project.strokes.at("oak").size(), 1u);
  revert(edit, project);
  EXPECT_TRUE(project.strokes.empty());
}

TEST(Edit, KeepsStrokesRounded) {
  Project project;
  const Edit edit = AddStroke{"oak", {StrokeKind::foreground, 8.01, {{1.03, 2.0}}}};
  apply(edit, project);
  EXPECT_EQ(project.strokes.at("oak").front().points_px.front().x, 1.0);
  revert(edit, project);
  EXPECT_TRUE(project.strokes.empty());
}

TEST(Edit, RevertsAfterOtherChangesToo) {
  Project project;
  project.strokes["oak"] = {kStroke, kOther, kStroke, kOther};
  revert(AddStroke{"oak", kStroke}, project);
  EXPECT_EQ(project.strokes["oak"], (std::vector<Stroke>{kStroke, kOther, kOther}));
  revert(AddStroke{"elm", kStroke}, project);
  EXPECT_EQ(project.strokes.size(), 1u);

  const SetOption set = option_edit(project, "opacity.passes", "5");
  apply(set, project);
  set_option(project.recipe, "opacity.passes", "7");
  revert(set, project);
  EXPECT_EQ(option_text(project.recipe, "opacity.passes"), set.before);
}

TEST(Edit, HasATitleThatSaysWhatItDoes) {
  Project project;
  set_option(project.recipe, "opacity.cell_px", "3.6");
  EXPECT_EQ(title(option_edit(project, "opacity.cell_px", "2.8")), "opacity.cell_px 3.6 to 2.8");
  EXPECT_EQ(title(AddStroke{"oak_03", kStroke}), "stroke on oak_03");
  EXPECT_EQ(title(AddStroke{"oak\x1b[2J", kStroke}), "stroke on oak?[2J");
  EXPECT_EQ(title(SetPhotos{{"a"}, {"a", "b"}}), "adding 1 photo");
  EXPECT_EQ(title(SetPhotos{{"a", "b", "c"}, {"a"}}), "removing 2 photos");
  EXPECT_EQ(title(SetFiles{FileKind::cameras, "", "../x/transforms.json"}),
            "cameras transforms.json");
  EXPECT_EQ(title(ClearStrokes{"oak_03", {kStroke}}), "clearing the strokes on oak_03");
}

TEST(Edit, SetsSeveralOptionsAtOnceAndPutsThemBack) {
  const ScratchFolder folder;
  Project project = saved_project(folder.path());
  const std::string before = content_of(project);
  Recipe wanted = project.recipe;
  wanted.opacity.cell_px = 5.0;
  wanted.radiance.epochs = 7;
  const SetOptions edit = recipe_edit(project, "preset quick", wanted);
  EXPECT_EQ(edit.options.size(), 2u);
  EXPECT_EQ(title(edit), "preset quick");
  apply(edit, project);
  EXPECT_EQ(project.recipe.radiance.epochs, 7);
  EXPECT_TRUE(recipe_edit(project, "again", wanted).options.empty());
  revert(edit, project);
  EXPECT_EQ(content_of(project), before);
}

TEST(Edit, ThatDoesNotFitIsRefusedAndChangesNothing) {
  const ScratchFolder folder;
  Project project = saved_project(folder.path());
  const std::string before = content_of(project);
  const Edit misfits[] = {SetOption{"opacity.cell_px", "3", "nan"}, SetOption{"no.such", "", ""},
                          SetOptions{"", {{"opacity.cell_px", "3", "5"}, {"no.such", "", ""}}},
                          AddStroke{"oak", {StrokeKind::erase, 3.0, {}}}};
  for (const Edit& edit : misfits) {
    EXPECT_THROW(checked_edit(edit, project), Error);
    EXPECT_THROW(apply(edit, project), Error);
  }
  EXPECT_THROW(checked_edit(AddStroke{"\xff", kStroke}, project), Error);
  EXPECT_THROW(checked_edit(SetFiles{FileKind::mattes, "", "\xc3"}, project), Error);
  EXPECT_EQ(content_of(project), before);
}

TEST(Edit, OfSightingsSaysWhereWhatIsThereOrThatItIsNot) {
  Project project;
  apply(kMoved, project);
  EXPECT_EQ(project.calibration.sightings.at("oak").at("red"), kHere);
  const SetSighting removed = sighting_edit(project, "oak", "red", kNotThere);
  apply(removed, project);
  EXPECT_FALSE(project.calibration.sightings.at("oak").at("red").there);
  revert(removed, project);
  EXPECT_EQ(project.calibration.sightings.at("oak").at("red"), kHere);
  apply(sighting_edit(project, "oak", "red", std::nullopt), project);
  EXPECT_TRUE(project.calibration.empty());
}

TEST(Edit, OfCalibrationHasATitleToo) {
  const Project project;
  EXPECT_EQ(title(kMoved), "red on oak");
  EXPECT_EQ(title(SetSighting{"oak", "red", kHere, kHere}), "moving red on oak");
  EXPECT_EQ(title(SetSighting{"oak", "red", kHere, kNotThere}), "removing red on oak");
  EXPECT_EQ(title(SetSighting{"oak", "red", kHere, std::nullopt}), "forgetting red on oak");
  EXPECT_EQ(title(SetSightings{"clicks.json", {kMoved}}), "clicks.json");
  EXPECT_EQ(title(SetMeasurements{{}, {{{"red", "blue", 2.35, 0.003}}, {}, {}}}), "adding a tape");
  EXPECT_EQ(title(SetMeasurements{{{}, {{"red", 1.5, 0.01}}, {}}, {}}), "removing a height");
  EXPECT_EQ(title(SetMeasurements{kMeasured, kMeasured}), "measurements");
  EXPECT_EQ(title(SetFiles{FileKind::boards, "", "../boards"}), "board photos boards");
}

TEST(Edit, OfCalibrationThatDoesNotFitIsRefusedAndChangesNothing) {
  Project project;
  project.calibration.measurements = kMeasured;
  const double nan = std::nan("");
  const auto measured = [](auto change) {
    Measurements wrong = kMeasured;
    change(wrong);
    return SetMeasurements{{}, wrong};
  };
  const Edit misfits[] = {
      SetSighting{"oak", "red", std::nullopt, HandSighting{true, {nan, 0.0}}},
      SetSighting{"oak", "red", std::nullopt, HandSighting{true, {0.0, 1e7}}},
      SetSighting{"oak", "", std::nullopt, kHere},
      SetSightings{"", {kMoved, {"oak", "blue", std::nullopt, HandSighting{true, {nan, 0.0}}}}},
      measured([](Measurements& m) { m.tapes[0].length_m = 0.0; }),
      measured([](Measurements& m) { m.tapes[0].sigma_m = -1.0; }),
      measured([](Measurements& m) { m.tapes[0].to = m.tapes[0].from; }),
      measured([&](Measurements& m) { m.heights[0].height_m = nan; }),
      measured([](Measurements& m) { m.points[0].in_world.y = 1e9; }),
      measured([](Measurements& m) { m.points[0].point = "\xff"; })};
  for (const Edit& edit : misfits) {
    EXPECT_THROW(checked_edit(edit, project), Error) << title(edit);
    EXPECT_THROW(apply(edit, project), Error) << title(edit);
    EXPECT_TRUE(project.calibration.sightings.empty());
    EXPECT_EQ(project.calibration.measurements, kMeasured);
  }
  EXPECT_THROW(checked_edit(SetSighting{"\xff", "red", std::nullopt, kHere}, project), Error);
  EXPECT_THROW(checked_edit(SetSighting{"", "red", std::nullopt, kHere}, project), Error);
  EXPECT_THROW(checked_edit(SetSightings{"twice", {kMoved, kMoved}}, project), Error);
}

TEST(EditBytes, ReadBackAsWritten) {
  const ScratchFolder folder;
  Project project = saved_project(folder.path());
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Edit edit = random_edit(random, project);
    apply(edit, project);
    ASSERT_EQ(edit_of_bytes(bytes_of_edit(edit)), edit);
  }
}

TEST(EditBytes, CutAnywhereAreRefused) {
  const Edit edits[] = {SetOption{"a.b", "1", "2"},
                        SetPhotos{{"a"}, {"a", "b"}},
                        SetFiles{FileKind::scribbles, "", "x"},
                        AddStroke{"oak", kStroke},
                        ClearStrokes{"oak", {kStroke, kOther}},
                        SetOptions{"preset", {{"a.b", "1", "2"}, {"c.d", "", "3"}}},
                        kMoved,
                        SetSightings{"clicks", {kMoved, {"elm", "red", kHere, kNotThere}}},
                        SetMeasurements{{}, kMeasured},
                        UseAll{"oak", {kStroke}},
                        RenamePoint{{"red is blue", {kMoved}}, {{}, kMeasured}}};
  for (const Edit& edit : edits) {
    const auto bytes = bytes_of_edit(edit);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_THROW(edit_of_bytes(std::span(bytes).first(size)), Error) << title(edit) << size;
    }
    auto longer = bytes;
    longer.push_back({});
    EXPECT_THROW(edit_of_bytes(longer), Error);
  }
}

}  // namespace
}  // namespace bosk
