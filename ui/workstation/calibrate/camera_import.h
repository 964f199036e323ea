#pragma once

#include <filesystem>

namespace bosk {

struct Workspace;

// Holds a camera file or folder against the photos, by a job, and where at least two of them find
// their camera in it, makes it the project's, in one edit. What came of it is told in the notices
// of step Calibrate.
void import_cameras(Workspace& workspace, const std::filesystem::path& place);
// Tells of an import that was stopped. Once a frame.
void follow_import(Workspace& workspace);

}  // namespace bosk
