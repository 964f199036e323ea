#include "ui/workstation/codebook/codebook_step.h"

#include <gtest/gtest.h>

#include "tests/ui/workstation/phantom_project.h"

namespace bosk {
namespace {

class CodebookStep : public PhantomStep {
 protected:
  CodebookStep() : PhantomStep("codebook") {}
  const CodebookStepState& state() { return hand.workspace().codebook; }
  const CompressOptions& options() { return hand.workspace().project().recipe.compress; }
  void train() {
    hand.click("codebook/run");
    ASSERT_TRUE(hand.settle());
    ASSERT_TRUE(hand.workspace().results.textures);
  }
};

TEST_F(CodebookStep, TheCurveGrowsToItsEnd) {
  train();
  hand.click("codebook/curve");
  ASSERT_TRUE(hand.wait_for([&] { return state().curve && !state().curve->empty(); }));
  ASSERT_TRUE(hand.settle());
  ASSERT_GE(state().curve->size(), 5u);
  EXPECT_EQ(state().curve->front().codewords, 16);
  EXPECT_GT(state().curve->back().colour_psnr_db, state().curve->front().colour_psnr_db);
}

TEST_F(CodebookStep, TheCurveNeedsTextures) { EXPECT_FALSE(hand.is_enabled("codebook/curve")); }

TEST_F(CodebookStep, DraggingOnTheChartIsOneEditThatUndoTakesBack) {
  const int before = options().colour_codewords;
  const Landmark chart = hand.at("codebook/plot");
  const ImVec2 from = chart.middle();
  const std::uint64_t revision = hand.workspace().session->revision();
  hand.move_to(from);
  hand.press();
  for (int i = 0; i < 5; ++i) hand.move_to({from.x - 20.0f * float(i), from.y});
  EXPECT_TRUE(state().codewords_held);
  EXPECT_EQ(options().colour_codewords, before);  // not yet
  hand.release();
  hand.frame();
  EXPECT_LT(options().colour_codewords, before);
  EXPECT_EQ(hand.workspace().session->revision(), revision + 1);
  hand.click("undo");
  EXPECT_EQ(options().colour_codewords, before);
}

TEST_F(CodebookStep, TheOtherCodebookIsChosenApart) {
  const int colours = options().colour_codewords, alphas = options().alpha_codewords;
  hand.click("codebook/opacities");
  hand.click_at(hand.at("codebook/plot").middle());
  EXPECT_EQ(options().colour_codewords, colours);
  EXPECT_NE(options().alpha_codewords, alphas);
}

TEST_F(CodebookStep, ShowsCodewordsAndTexturesBesideWhatTheyGive) {
  EXPECT_FALSE(hand.sees("codebook/codewords"));
  train();
  EXPECT_TRUE(hand.sees("codebook/codewords"));
  EXPECT_TRUE(hand.sees("codebook/baked"));
  const int uploads = hand.textures().uploads;
  hand.click("codebook/as_gpu");
  hand.frame(2);
  EXPECT_TRUE(state().as_gpu);
  EXPECT_EQ(hand.textures().uploads, uploads + 1);  // the compressed side alone
}

}  // namespace
}  // namespace bosk
