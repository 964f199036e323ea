#pragma once

#include <string>
#include <vector>

#include "core/calibrate/calibration.h"
#include "core/photo/camera.h"

namespace bosk {

struct Workspace;

// Parts of step Calibrate. `cameras` are those of the project's photos.
void draw_frusta(Workspace& workspace, const std::vector<Camera>& cameras);
void draw_camera_table(Workspace& workspace, const std::vector<Camera>& cameras);

struct PointRow;
// All points that have a name of their own; valid until the next change.
const std::vector<PointRow>& listed_points(Workspace& workspace);
// Names of the calibration's options that are about the lens.
const std::vector<std::string>& lens_option_names();

// Those of a project whose cameras are found and solved:
void draw_solving(Workspace& workspace);         // what to press, the verdict and what it says
void draw_points(Workspace& workspace);          // the list of points
void draw_measurements(Workspace& workspace);    // tapes, heights, surveyed points
void draw_lens_sources(Workspace& workspace);    // where the lens is known from
void draw_lens_view(Workspace& workspace);       // what photos of a board gave
void draw_photo_findings(Workspace& workspace);  // a row for each photo
void draw_reshoot_wheel(Workspace& workspace);   // cameras from above, and where one is missing

}  // namespace bosk
