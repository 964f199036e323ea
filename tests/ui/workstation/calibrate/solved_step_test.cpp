#include "tests/ui/workstation/calibrate/solved_hand.h"
#include "ui/widgets/keys.h"
#include "ui/workstation/guide.h"

namespace bosk {
namespace {

using testing::HasSubstr;

TEST_F(SolvedStep, BeginsWithWhatToPress) {
  open({});
  EXPECT_EQ(solve_state(workspace), SolveState::none);
  EXPECT_THAT(guide_of(workspace, WorkStep::calibrate).next, HasSubstr("Find markers"));
  EXPECT_TRUE(hand.is_enabled("calibrate/find"));
  EXPECT_TRUE(hand.sees("calibrate/canvas")) << "photos can be clicked before";
  EXPECT_THAT(obstacle_to_stages(workspace), HasSubstr("step Calibrate"));
}

TEST_F(SolvedStep, FindsSolvesAndLetsLaterStepsBegin) {
  open(true_clicks());
  find();
  ASSERT_EQ(solve_state(workspace), SolveState::current) << state().solved.trouble;
  EXPECT_NE(solved().verdict, Verdict::refused)
      << (solved().sentences.empty() ? "" : solved().sentences.front());
  EXPECT_EQ(solved().cameras.size(), 10u);
  EXPECT_TRUE(hand.sees("calibrate/finding/000"));
  EXPECT_TRUE(hand.sees("calibrate/point/red"));
  ASSERT_TRUE(workspace.capture);
  EXPECT_EQ(workspace.capture->cameras.size(), 10u);
  EXPECT_EQ(obstacle_to_stages(workspace), "");
  hand.click("calibrate/show/cameras");
  hand.frame();
  EXPECT_TRUE(hand.sees("calibrate/frustum/000"));
  EXPECT_TRUE(hand.sees("calibrate/solved/red"));
  hand.click("calibrate/show/wheel");
  hand.frame();
  EXPECT_TRUE(hand.sees("calibrate/spoke/000"));
}

TEST_F(SolvedStep, ARefusalSaysWhyAndStopsLaterSteps) {
  HandSightings clicks = true_clicks();
  for (auto& [photo, points] : clicks) {
    while (points.size() > 2) points.erase(points.begin());
  }
  open(clicks);
  find();
  ASSERT_EQ(solve_state(workspace), SolveState::current) << state().solved.trouble;
  EXPECT_EQ(solved().verdict, Verdict::refused);
  ASSERT_FALSE(solved().sentences.empty());
  const StepGuide guide = guide_of(workspace, WorkStep::calibrate);
  EXPECT_EQ(guide.tone, Tone::bad);
  EXPECT_FALSE(guide.has.empty());
  EXPECT_FALSE(guide.next.empty());
  EXPECT_FALSE(workspace.capture);
  EXPECT_THAT(obstacle_to_stages(workspace), HasSubstr("no cameras could be found"));
}

class SolvedCapture : public SolvedStep {
 protected:
  SolvedCapture() { open_solved(); }
  // A ball that the photo on the canvas shows.
  std::string shown_point() {
    for (const auto& [point, said] : workspace.project().calibration.sightings.at(shown_photo())) {
      if (said.there && hand.sees("calibrate/mark/" + point)) return point;
    }
    ADD_FAILURE() << "no ball on " << shown_photo();
    return {};
  }
};

TEST_F(SolvedCapture, AMarkMovedByTheMouseIsOneEditAndTheSolveFollows) {
  const std::string photo = shown_photo(), point = shown_point();
  const glm::dvec2 before = told(photo, point)->pixel;
  const ContentHash key = state().solved.key;
  const ImVec2 from = on_screen(before);
  hand.drag(from, {from.x + 40.0f, from.y + 20.0f});
  const double scale = place_of(state().canvas.view, {240, 320}, hand.at("calibrate/canvas").least,
                                hand.at("calibrate/canvas").most)
                           .scale;
  const glm::dvec2 moved = told(photo, point)->pixel - before;
  EXPECT_NEAR(moved.x, 40.0 / scale, 1.0 / scale);
  EXPECT_NEAR(moved.y, 20.0 / scale, 1.0 / scale);
  ASSERT_TRUE(hand.settle());
  ASSERT_EQ(solve_state(workspace), SolveState::current);
  EXPECT_NE(state().solved.key, key);
  const auto marks = marks_on_canvas(workspace);
  const PhotoMark* mark = mark_at(marks, told(photo, point)->pixel, 1.0);
  ASSERT_TRUE(mark && mark->error_px);
  EXPECT_TRUE(mark->outlier) << words_of(*mark);

  hand.click("undo");
  EXPECT_EQ(told(photo, point)->pixel, before);
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state().solved.key, key);
  EXPECT_EQ(solve_state(workspace), SolveState::current);
  EXPECT_TRUE(workspace.capture);
}

TEST_F(SolvedCapture, AClickWithoutAMoveChoosesThePointAndChangesNothing) {
  const std::uint64_t revision = workspace.session->revision();
  const std::string point = shown_point();
  hand.click("calibrate/mark/" + point);
  EXPECT_EQ(state().canvas.point, point);
  EXPECT_EQ(state().rename_to, point);
  EXPECT_EQ(workspace.session->revision(), revision);
}

TEST_F(SolvedCapture, ABrushLeavesOutWhatIsFoundThereAndTheSolveFollows) {
  const std::string photo = shown_photo();
  const ContentHash key = state().solved.key;
  hand.click("calibrate/leave_out");
  hand.key(kKeyRightBracket);
  hand.drag(on_screen({10.0, 10.0}), on_screen({200.0, 12.0}));
  const auto& left_out = workspace.project().calibration.left_out;
  ASSERT_EQ(left_out.count(photo), 1u);
  const Stroke stroke = left_out.at(photo).front();
  EXPECT_EQ(stroke.kind, StrokeKind::left_out);
  EXPECT_NEAR(stroke.radius_px, 0.03 * 1.25 * 320.0, 1.0 / 16);
  EXPECT_NEAR(stroke.points_px.front().x, 10.0, 1.0);
  EXPECT_NEAR(stroke.points_px.back().x, 200.0, 1.0);
  EXPECT_TRUE(workspace.project().strokes.empty());
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(solve_state(workspace), SolveState::current);
  EXPECT_NE(state().solved.key, key);
  EXPECT_EQ(state().canvas.point, "") << "the brush places no point";

  hand.click("calibrate/use_all");
  EXPECT_TRUE(left_out.empty());
  hand.key('Z', true);
  EXPECT_EQ(left_out.at(photo).size(), 1u);
  hand.key('Z', true);
  EXPECT_TRUE(left_out.empty());
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state().solved.key, key);
  hand.key('B');
  EXPECT_FALSE(state().canvas.brush);
}

TEST_F(SolvedCapture, ANewNameIsPlacedByAClick) {
  hand.click("calibrate/new_point");
  hand.type("post");
  hand.click("calibrate/take_point");
  EXPECT_EQ(state().canvas.point, "post");
  hand.click_at(on_screen({120.0, 20.0}));
  ASSERT_TRUE(told(shown_photo(), "post"));
  EXPECT_NEAR(told(shown_photo(), "post")->pixel.x, 120.0, 1.0);
  EXPECT_TRUE(hand.sees("calibrate/point/post"));
  hand.key('Z', true);
  EXPECT_FALSE(told(shown_photo(), "post"));
}

TEST_F(SolvedCapture, DeleteRemovesTheChosenPointFromThePhotoAlone) {
  const std::string photo = shown_photo(), point = shown_point();
  hand.click("calibrate/mark/" + point);
  hand.key(kKeyDelete);
  EXPECT_FALSE(told(photo, point));
  hand.key(kKeyPageDown);
  EXPECT_NE(shown_photo(), photo);
  hand.key(kKeyPageUp);
  EXPECT_EQ(shown_photo(), photo);
}

TEST_F(SolvedCapture, ATapeGivesTheScaleOnceItIsSolved) {
  EXPECT_FALSE(solved().scale_known);
  const auto& markers = capture().phantom.markers;
  const double length = glm::distance(markers[0].centre, markers[1].centre);
  choose("calibrate/new_tape/from", markers[0].name);
  choose("calibrate/new_tape/to", markers[1].name);
  EXPECT_FALSE(hand.is_enabled("calibrate/new_tape/add")) << "without a length";
  hand.click("calibrate/new_tape/metres");
  hand.key('A', true);
  hand.type(std::to_string(length));
  hand.key(kKeyEnter);
  hand.click("calibrate/new_tape/add");
  ASSERT_EQ(workspace.project().calibration.measurements.tapes.size(), 1u);
  EXPECT_NEAR(workspace.project().calibration.measurements.tapes[0].length_m, length, 1e-3);
  ASSERT_TRUE(hand.settle());
  ASSERT_EQ(solve_state(workspace), SolveState::current);
  EXPECT_TRUE(solved().scale_known);
  EXPECT_TRUE(hand.sees("calibrate/tape/0/metres"));
  hand.click("calibrate/tape/0/remove");
  EXPECT_TRUE(workspace.project().calibration.measurements.tapes.empty());
  hand.click("undo");
  EXPECT_EQ(workspace.project().calibration.measurements.tapes.size(), 1u);
}

TEST_F(SolvedCapture, ASurveyedPointIsTypedAndFixesTheWorldsPlace) {
  choose("calibrate/new_surveyed/point", "red");
  for (const auto& [axis, text] : {std::pair("x", "1.25"), {"y", "-0.5"}, {"z", "0.75"}}) {
    hand.click(std::string("calibrate/new_surveyed/") + axis);
    hand.key('A', true);
    hand.type(text);
  }
  hand.click("calibrate/new_surveyed/add");
  const auto& points = workspace.project().calibration.measurements.points;
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0], (SurveyedPoint{"red", {1.25, -0.5, 0.75}}));
  ASSERT_TRUE(hand.settle());
  ASSERT_EQ(solve_state(workspace), SolveState::current) << state().solved.trouble;
  hand.click("calibrate/surveyed/0/remove");
  EXPECT_TRUE(points.empty());
  hand.click("undo");
  EXPECT_EQ(points.size(), 1u);
}

TEST_F(SolvedCapture, ANameIsChangedInAllPhotosAndMeasurementsByOneEdit) {
  edit(workspace, measurements_edit(workspace.project(), {{}, {{"red", 0.5, 0.01}}, {}}));
  ASSERT_TRUE(hand.settle());
  const auto& heights = workspace.project().calibration.measurements.heights;
  hand.click("calibrate/point/red");
  hand.click("calibrate/rename_to");
  hand.key('A', true);
  hand.type("gate");
  hand.click("calibrate/rename");
  EXPECT_TRUE(hand.sees("calibrate/point/gate"));
  EXPECT_FALSE(hand.sees("calibrate/point/red"));
  EXPECT_EQ(heights.at(0).point, "gate");
  hand.click("undo");
  hand.frame();
  EXPECT_TRUE(hand.sees("calibrate/point/red"));
  EXPECT_EQ(heights.at(0).point, "red");
}

TEST_F(SolvedCapture, ARowOfTheTableOpensItsPhoto) {
  hand.click("calibrate/show/cameras");
  hand.click("calibrate/finding/003");
  hand.frame();
  EXPECT_EQ(shown_photo(), "003");
  EXPECT_TRUE(hand.sees("calibrate/canvas"));
}

TEST_F(SolvedCapture, TheLoupeFollowsTheMouse) {
  hand.move_to(on_screen({100.0, 100.0}));
  hand.frame();
  EXPECT_TRUE(hand.sees("calibrate/loupe_picture"));
  hand.key('L');
  EXPECT_FALSE(hand.sees("calibrate/loupe_picture"));
}

TEST_F(SolvedCapture, IsThereAgainWhenTheProjectIsOpenedAgain) {
  const ContentHash key = state().solved.key;
  close_project(workspace);
  show();
  EXPECT_EQ(solve_state(workspace), SolveState::current);
  EXPECT_EQ(state().solved.key, key);
  EXPECT_TRUE(workspace.capture);
}

TEST_F(SolvedStep, GoesOnByItselfWhereTheWindowWasClosedDuringASolve) {
  open(true_clicks());
  find();
  ASSERT_EQ(solve_state(workspace), SolveState::current) << state().solved.trouble;
  const ContentHash key = state().solved.key;
  const std::filesystem::path cache = workspace.project().cache_folder();
  close_project(workspace);
  int solves = 0;
  for (const auto& entry : std::filesystem::directory_iterator(cache)) {
    if (!entry.path().filename().string().starts_with("calibrate-")) continue;
    std::filesystem::remove(entry.path());
    ++solves;
  }
  EXPECT_EQ(solves, 1);
  show();
  EXPECT_EQ(solve_state(workspace), SolveState::current);
  EXPECT_EQ(state().solved.key, key);
}

// Of the words that the newest frame shows under names that begin so.
std::vector<Landmark> landmarks_under(const Workspace& workspace, const std::string& beginning) {
  std::vector<Landmark> found;
  for (const auto& [name, landmark] : workspace.landmarks) {
    if (name.starts_with(beginning)) found.push_back(landmark);
  }
  return found;
}

void expect_apart(const std::vector<Landmark>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool apart = words[i].least.x >= words[j].most.x ||
                         words[j].least.x >= words[i].most.x ||
                         words[i].least.y >= words[j].most.y || words[j].least.y >= words[i].most.y;
      EXPECT_TRUE(apart) << i << " covers " << j;
    }
  }
}

TEST_F(SolvedCapture, NamesOfPointsInTheViewOfCamerasCoverNoneOfEachOther) {
  hand.click("calibrate/show/cameras");
  hand.frame();
  hand.move_to(hand.at("calibrate/view").middle());
  hand.wheel(-5.0f);  // far away, where all points are close together
  hand.frame(2);
  const auto names = landmarks_under(workspace, "calibrate/label/");
  EXPECT_GE(names.size(), 3u);
  expect_apart(names);
}

// Twenty points close together on the first photo.
HandSightings crowded_clicks() {
  HandSightings clicks;
  for (int i = 0; i < 20; ++i) {
    clicks["000"]["p" + std::to_string(10 + i)] = {true,
                                                   {60.0 + 8.0 * (i % 5), 60.0 + 3.0 * (i / 5)}};
  }
  return clicks;
}

TEST_F(SolvedStep, NamesOfMarksOnAPhotoCoverNoneOfEachOther) {
  open(crowded_clicks());
  const auto names = landmarks_under(workspace, "calibrate/name/");
  EXPECT_GE(names.size(), 5u);
  expect_apart(names);
}

TEST_F(SolvedStep, TheListScrollsToAPointThatIsChosenOnThePhoto) {
  open(crowded_clicks());
  ASSERT_FALSE(hand.sees("calibrate/point/p29"));
  hand.click("calibrate/mark/p29");
  hand.frame(2);
  EXPECT_EQ(state().canvas.point, "p29");
  EXPECT_TRUE(hand.sees("calibrate/point/p29"));
}

TEST_F(SolvedCapture, OtherOptionsMakeItOutOfDateUntilTheyAreUndone) {
  edit(workspace, option_edit(workspace.project(), "calibrate.smallest_ball", "9"));
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(solve_state(workspace), SolveState::outdated);
  EXPECT_EQ(guide_of(workspace, WorkStep::calibrate).state, "out of date");
  EXPECT_FALSE(workspace.capture);
  hand.click("undo");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(solve_state(workspace), SolveState::current);
  EXPECT_TRUE(workspace.capture);
}

TEST_F(SolvedCapture, ACameraFileCountsOverItAndIsGivenUpByAButton) {
  edit(workspace, files_edit(workspace.project(), FileKind::cameras,
                             capture().scratch / "capture" / "transforms.json"));
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(solve_state(workspace), SolveState::unused);
  EXPECT_FALSE(hand.sees("calibrate/find"));
  hand.click("calibrate/unimport");
  ASSERT_TRUE(hand.settle());
  EXPECT_TRUE(workspace.project().cameras.empty());
  EXPECT_EQ(solve_state(workspace), SolveState::current);
  hand.click("undo");
  EXPECT_FALSE(workspace.project().cameras.empty());
}

TEST_F(SolvedStep, BallsAreFoundByThemselvesAndOneThatIsRemovedStaysRemoved) {
  open({}, true);
  find();
  ASSERT_TRUE(state().solved.finds) << state().solved.trouble;
  const auto marks = marks_on_canvas(workspace);
  ASSERT_FALSE(marks.empty()) << "no ball was found on " << shown_photo();
  const std::string point = marks.front().point;
  hand.click("calibrate/point/" + point);
  hand.click("calibrate/remove");
  ASSERT_TRUE(told(shown_photo(), point));
  EXPECT_FALSE(told(shown_photo(), point)->there);
  ASSERT_TRUE(hand.settle());
  find();
  const auto after = marks_on_canvas(workspace);
  EXPECT_EQ(after.front().kind, PhotoMark::Kind::removed);
  hand.click("calibrate/as_found");
  EXPECT_FALSE(told(shown_photo(), point));
}

}  // namespace
}  // namespace bosk
