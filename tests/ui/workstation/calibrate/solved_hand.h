#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/phantom/phantom.h"
#include "core/project/calibration_run.h"
#include "core/project/new_project.h"
#include "tests/base/scratch_folder.h"
#include "tests/ui/workstation/hand.h"

namespace bosk {

// Ten photos of a small tree among eight balls on sticks, made once; projects of them have no
// camera file.
class BallCapture {
 public:
  BallCapture() {
    PhantomOptions options = tiny_phantom();
    options.width_px = 240;
    options.height_px = 320;
    options.markers = 8;
    options.held_out = 0;
    options.samples = 2;
    options.density_side = 16;
    options.distortion = 0.0;
    Progress quiet;
    phantom = make_phantom(options, quiet);
    write_phantom(scratch / "capture", phantom, quiet);
  }
  // Nothing is looked for by itself but balls where asked.
  Project project_with(const std::filesystem::path& folder, const HandSightings& clicks,
                       bool find_balls = false) const {
    NewProject wanted;
    wanted.folder = folder;
    wanted.photos = {scratch / "capture" / "photos"};
    Project project = make_project(wanted, Recipe(), true, Progress());
    set_option(project.recipe, "calibrate.features", "off");
    set_option(project.recipe, "calibrate.find_balls", find_balls ? "true" : "false");
    project.calibration.sightings = clicks;
    return project;
  }

  Phantom phantom;
  const ScratchFolder scratch;
};

// A hand in step Calibrate of such a project.
class SolvedStep : public testing::Test {
 protected:
  static const BallCapture& capture() {
    static const BallCapture once;
    return once;
  }

  // The true places of all balls, as clicks.
  static HandSightings true_clicks() {
    HandSightings clicks;
    for (const PhantomView& view : capture().phantom.photos) {
      for (std::size_t i = 0; i < view.marker_px.size(); ++i) {
        if (view.marker_visible[i] < 0.5) continue;
        clicks[view.camera.name][capture().phantom.markers[i].name] = {true, view.marker_px[i]};
      }
    }
    return clicks;
  }
  // Opens a project with these clicks, in step Calibrate.
  void open(const HandSightings& clicks, bool find_balls = false) {
    save_project(capture().project_with(place, clicks, find_balls));
    show();
  }
  // The same with all true clicks, found and solved; the cache holds it.
  void open_solved() {
    static const Calibration once = [] {
      const Project project = capture().project_with(capture().scratch / "solved", true_clicks());
      save_project(project);
      Progress quiet;
      return run_calibration(gather_calibration(project), Cache(project.cache_folder()), quiet);
    }();
    std::filesystem::copy(capture().scratch / "solved", place,
                          std::filesystem::copy_options::recursive);
    show();
    EXPECT_EQ(solve_state(workspace), SolveState::current) << state().solved.trouble;
  }
  void show() {
    open_project(workspace, place);
    workspace.step = WorkStep::calibrate;
    EXPECT_TRUE(hand.settle());
  }
  void find() {
    hand.click("calibrate/find");
    EXPECT_TRUE(hand.settle());
  }

  CalibrateStepState& state() { return workspace.calibrate; }
  const Calibration& solved() { return *state().solved.calibration; }
  std::string shown_photo() { return row_on_canvas(workspace)->name; }
  const HandSighting* told(const std::string& photo, const std::string& point) {
    const HandSightings& all = workspace.project().calibration.sightings;
    const auto points = all.find(photo);
    if (points == all.end()) return nullptr;
    const auto said = points->second.find(point);
    return said == points->second.end() ? nullptr : &said->second;
  }
  // Where a pixel of the photo on the canvas, which stands upright as delivered, is on the screen.
  ImVec2 on_screen(const glm::dvec2& pixel) {
    const Landmark canvas = hand.at("calibrate/canvas");
    const glm::dvec2 size(240, 320);
    const glm::dvec2 at =
        place_of(state().canvas.view, size, canvas.least, canvas.most).screen_from_picture(pixel);
    return {float(at.x), float(at.y)};
  }
  void choose(const std::string& field, const std::string& point) {
    hand.click(field);
    hand.frame();
    hand.click(field + "/" + point);
  }

  // Beside the photos, so that paths in the project fit wherever it is copied to.
  const std::filesystem::path place = capture().scratch / std::to_string(++projects());
  Hand hand{ImVec2(1600, 1500)};
  Workspace& workspace = hand.workspace();

 private:
  static int& projects() {
    static int count = 0;
    return count;
  }
};

}  // namespace bosk
