#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "core/image/orientation.h"
#include "core/matte/scribbles.h"
#include "tests/ui/workstation/matte/matte_project.h"
#include "ui/workstation/matte/matte_paint.h"

namespace bosk {

// A hand before the first photo of such a project, in the step Matte.
class MatteHand : public testing::Test {
 protected:
  MatteHand() {
    copy_matte_project(scratch.path());
    open_project(workspace, scratch.path() / "oak");
    workspace.step = WorkStep::matte;
    EXPECT_TRUE(hand.settle());
    EXPECT_TRUE(hand.wait_for([&] { return photo_on_canvas(workspace) != nullptr; }, 60.0));
    hand.settle();
  }

  void open(const std::string& photo) {
    hand.click("matte/photo/" + photo);
    hand.settle();
  }

  // Where the upright picture lies on the screen now.
  ImagePlace place() {
    const Landmark canvas = hand.at("matte/canvas");
    const Photo& photo = *photo_on_canvas(workspace);
    const glm::ivec2 size =
        upright_size({photo.srgb.width(), photo.srgb.height()}, orientation_on_canvas(workspace));
    return place_of(workspace.matte.image_view, size, canvas.least, canvas.most);
  }
  ImVec2 on_screen(const glm::dvec2& upright_px) {
    const glm::dvec2 at = place().screen_from_picture(upright_px);
    return {float(at.x), float(at.y)};
  }
  void paint(const glm::dvec2& from, const glm::dvec2& to, int steps = 6) {
    hand.drag(on_screen(from), on_screen(to), steps);
  }
  // Over the crown and the sky of the tiny tree.
  void paint_both() {
    paint({44, 60}, {52, 60});
    hand.key('X');
    paint({10, 10}, {80, 10});
    hand.key('X');
  }

  const std::vector<Stroke>& strokes_of(const std::string& photo) {
    static const std::vector<Stroke> none;
    const auto found = workspace.project().strokes.find(photo);
    return found == workspace.project().strokes.end() ? none : found->second;
  }
  const Stroke& last_stroke() { return strokes_of(workspace.matte.photo).back(); }

  // To one pixel of the photo as taken: the mouse stands on whole points of the screen.
  void expect_at(const glm::dvec2& taken_px, const glm::dvec2& upright_px) {
    const Photo& photo = *photo_on_canvas(workspace);
    const auto wanted = taken_from_upright(photo, orientation_on_canvas(workspace), upright_px);
    ASSERT_TRUE(wanted);
    EXPECT_LT(glm::distance(taken_px, *wanted), 1.0);
  }
  void expect_canvas_is_the_projects() {
    const MatteCanvas& canvas = workspace.matte.canvas;
    Image<std::uint8_t> wanted(canvas.strokes.width(), canvas.strokes.height(), kNoStroke);
    paint_strokes(strokes_of(canvas.photo), *photo_on_canvas(workspace), wanted);
    EXPECT_EQ(canvas.strokes, wanted);
  }
  const Image<glm::u8vec4>& seen() {
    const Texture texture = workspace.pictures.newest("matte/" + workspace.matte.photo);
    return hand.textures().pictures.at(texture.id);
  }

  const ScratchFolder scratch;
  Hand hand;
  Workspace& workspace = hand.workspace();
};

}  // namespace bosk
