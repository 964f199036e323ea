#include "ui/workstation/preview/preview_step.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/measure/contact_sheet.h"
#include "tests/base/scratch_folder.h"
#include "tests/ui/workstation/finished_project.h"
#include "tests/ui/workstation/hand.h"
#include "ui/widgets/keys.h"

namespace bosk {
namespace {

// A picture on the screen: its texture, and the part of the screen that it may show in.
struct Drawn {
  ImTextureID texture;
  ImVec4 clip;
};

std::vector<Drawn> drawn_pictures() {
  std::vector<Drawn> drawn;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int i = 0; i < data.CmdListsCount; ++i) {
    for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) {
      if (command.GetTexID() && command.GetTexID() != ImGui::GetIO().Fonts->TexID) {
        drawn.push_back({command.GetTexID(), command.ClipRect});
      }
    }
  }
  return drawn;
}

class PreviewStep : public testing::Test {
 protected:
  PreviewStep() {
    open_project(hand.workspace(), finished_project(scratch.path()).folder);
    hand.settle();
    hand.click("step/preview");
    hand.settle();
  }

  CompareState& compare() { return hand.workspace().preview.compare; }
  Texture picture(const std::string& name) { return hand.workspace().pictures.newest(name); }
  const Image<glm::u8vec4>& pixels(const std::string& name) {
    return hand.textures().pictures.at(picture(name).id);
  }
  void open_compare() {
    hand.click("preview/compare");
    ASSERT_TRUE(hand.settle());
    ASSERT_TRUE(hand.sees("preview/picture"));
  }

  const ScratchFolder scratch;
  Hand hand;
};

TEST_F(PreviewStep, ShowsTheTreeWithoutOpenGl) {
  ASSERT_TRUE(hand.workspace().results.package);
  ASSERT_TRUE(hand.sees("preview/tree"));
  const Image<glm::u8vec4>& shown = pixels("preview/live");
  const auto [least, most] =
      std::minmax_element(shown.pixels().begin(), shown.pixels().end(),
                          [](const glm::u8vec4& a, const glm::u8vec4& b) { return a.g < b.g; });
  EXPECT_GT(int(most->g) - int(least->g), 20) << "a tree before grey, not grey alone";
}

TEST_F(PreviewStep, OrbitsZoomsAndMovesByMouse) {
  const ViewCamera start = hand.workspace().preview.live.camera;
  const ImVec2 middle = hand.at("preview/tree").middle();
  hand.drag(middle, {middle.x + 120, middle.y});
  const ViewCamera turned = hand.workspace().preview.live.camera;
  EXPECT_NE(turned.heading, start.heading);
  EXPECT_NEAR(glm::distance(target_of(turned), target_of(start)), 0.0, 1e-9) << "an orbit";
  hand.move_to(middle);
  hand.wheel(2.0f);
  EXPECT_LT(hand.workspace().preview.live.camera.distance, turned.distance);
  hand.drag(middle, {middle.x + 60, middle.y}, 8, 1);
  EXPECT_GT(glm::distance(target_of(hand.workspace().preview.live.camera), target_of(start)), 0.01);
  hand.click("preview/home");
  hand.frame();
  EXPECT_EQ(hand.workspace().preview.live.camera, start);
}

TEST_F(PreviewStep, DrawsAPictureOnlyWhenSomethingChanged) {
  const std::uint64_t before = hand.workspace().preview.live.slow_revision;
  hand.frame(20);
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(hand.workspace().preview.live.slow_revision, before);
  hand.move_to(hand.at("preview/tree").middle());
  hand.wheel(1.0f);
  ASSERT_TRUE(hand.settle());
  EXPECT_GT(hand.workspace().preview.live.slow_revision, before);
}

TEST_F(PreviewStep, ComparesAPhotoWithTheTreeFromItsCamera) {
  open_compare();
  const KeptComparison* kept = follow_comparison(hand.workspace());
  ASSERT_TRUE(kept);
  const Comparison& comparison = *kept->comparison;
  EXPECT_EQ(comparison.render.width(), 64);
  EXPECT_EQ(comparison.render.height(), 80);
  EXPECT_EQ(comparison.photo.width(), 64) << "the photo with its background is known too";
  ASSERT_TRUE(comparison.score);
  const ViewScore again = score_view(comparison.render, comparison.truth);
  EXPECT_EQ(comparison.score->psnr, again.psnr);
  // A white frame gets about 12 dB of such trees, one in the wrong place less than 15
  EXPECT_GT(comparison.score->psnr, 17.0);
}

TEST_F(PreviewStep, EachModeShowsItsPictures) {
  open_compare();
  const ImTextureID photo = picture("preview/photo").id, render = picture("preview/render").id;
  const auto shown_in = [&](const std::string& button) {
    hand.click(button);
    hand.frame(2);
    std::vector<ImTextureID> shown;
    for (const Drawn& drawn : drawn_pictures()) shown.push_back(drawn.texture);
    return shown;
  };
  using Shown = std::vector<ImTextureID>;
  EXPECT_EQ(shown_in("preview/photo"), Shown({photo}));
  EXPECT_EQ(shown_in("preview/render"), Shown({render}));
  EXPECT_EQ(shown_in("preview/wipe"), Shown({photo, render}));
  EXPECT_EQ(shown_in("preview/blend"), Shown({photo, render}));
  EXPECT_EQ(shown_in("preview/side"), Shown({photo, render}));
  const Shown difference = shown_in("preview/difference");
  EXPECT_EQ(difference, Shown({picture("preview/difference").id}));
}

TEST_F(PreviewStep, OneKeyChangesBetweenPhotoAndRender) {
  open_compare();
  hand.key('T');
  EXPECT_EQ(compare().mode, CompareMode::photo);
  hand.key('T');
  EXPECT_EQ(compare().mode, CompareMode::render);
  hand.key('T');
  EXPECT_EQ(compare().mode, CompareMode::photo);
}

TEST_F(PreviewStep, TheDividerFollowsTheHand) {
  open_compare();
  hand.click("preview/wipe");
  const Landmark area = hand.at("preview/picture");
  const ImVec2 from = hand.at("preview/divider").middle();
  const float wanted = area.least.x + 0.25f * (area.most.x - area.least.x);
  hand.drag(from, {wanted, from.y});
  EXPECT_NEAR(compare().divider, 0.25f, 0.01f);
  hand.frame();
  const std::vector<Drawn> drawn = drawn_pictures();
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_NEAR(drawn[1].clip.x, wanted, 1.0f) << "the render begins at the divider";
}

TEST_F(PreviewStep, AllModesShareZoomAndPlace) {
  open_compare();
  hand.click("preview/side");
  hand.move_to(hand.at("preview/picture2").middle());
  hand.wheel(4.0f);
  const ImageView part = compare().part;
  EXPECT_GT(part.zoom, 2.0);
  hand.click("preview/difference");
  hand.frame(2);
  EXPECT_EQ(compare().part, part);
}

TEST_F(PreviewStep, SaysThatItsPhotosWereSeenInTraining) {
  open_compare();
  for (const ComparedView& view : {ComparedView{"000", false}, ComparedView{"007", false}}) {
    EXPECT_TRUE(hand.sees("preview/view/" + view.name));
  }
  EXPECT_FALSE(hand.sees("preview/held_out/003"));
}

TEST_F(PreviewStep, AnotherPhotoIsComparedByListAndByKey) {
  open_compare();
  hand.click("preview/view/005");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(compare().view.name, "005");
  hand.key(kKeyPageDown);
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(compare().view.name, "006");
  EXPECT_TRUE(follow_comparison(hand.workspace()));
}

TEST_F(PreviewStep, ScoresOnHeldOutPhotosFillATable) {
  hand.click("preview/scores");
  hand.workspace().preview.held_out.every = 4;
  hand.frame();
  hand.click("preview/score");
  ASSERT_TRUE(hand.settle());
  const auto evaluation = hand.workspace().preview.held_out.evaluation;
  ASSERT_TRUE(evaluation);
  EXPECT_EQ(evaluation->title, "2 of 8 photos held out");
  ASSERT_EQ(evaluation->scores.views.size(), 2u);
  EXPECT_TRUE(is_held_out_current(hand.workspace()));
  hand.click("preview/scores/003");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(compare().view, (ComparedView{"003", true}));
  ASSERT_TRUE(hand.sees("preview/picture"));
  const KeptComparison* kept = follow_comparison(hand.workspace());
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->comparison->score->psnr, evaluation->scores.views[0].score.psnr);
}

TEST_F(PreviewStep, AnEditMakesPackageAndScoresOutOfDate) {
  edit(hand.workspace(), option_edit(hand.workspace().project(), "pack.credit", "somebody"));
  hand.frame(2);
  EXPECT_EQ(state_of(hand.workspace(), "pack"), StageState::outdated);
  EXPECT_TRUE(hand.sees("preview/tree")) << "the older package stays to be seen";
  hand.click("preview/make");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state_of(hand.workspace(), "pack"), StageState::current);
}

TEST(Comparison, DifferenceOfAPictureWithItselfIsBlack) {
  Image<glm::u8vec4> picture(5, 4, {120, 60, 10, 200});
  picture(2, 1) = {0, 0, 0, 0};
  const Image<glm::u8vec4> difference = shown_difference(comparison_of(picture, picture));
  EXPECT_EQ(difference, Image<glm::u8vec4>(5, 4, {0, 0, 0, 255}));
}

TEST(Comparison, WithoutATreeInTheMatteThereIsNoScore) {
  const Image<glm::u8vec4> nothing(5, 4);
  EXPECT_FALSE(comparison_of(nothing, nothing).score);
}

}  // namespace
}  // namespace bosk
