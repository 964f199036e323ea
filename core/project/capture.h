#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/base/content_hash.h"
#include "core/calibrate/calibration.h"
#include "core/photo/camera.h"
#include "core/project/project.h"
#include "core/project/source_files.h"

namespace bosk {

// All that a run starts from, gathered from the project's files; everything after is a function of
// this and the recipe. Photos that lack a camera or, where ready-made mattes are used, a matte are
// not in it.
struct Capture {
  std::vector<SourceFile> photos;  // by name; the same order in `cameras`
  std::vector<Camera> cameras;
  std::vector<SourceFile> mattes;     // one for each photo, or none at all
  std::vector<SourceFile> scribbles;  // for some of the photos
  Strokes strokes;                    // drawn on some of the photos; they go over `scribbles`
  std::set<std::string> left_out;     // names of photos that no stage after import may see
  std::vector<std::string> remarks;   // one sentence for each file of the project that is not used
};

// Reads the camera file, or where the project names none what calibration left in the cache, and
// the content of every source file. Throws Error when there are no cameras yet, or when fewer than
// two photos are left, naming why.
Capture gather_capture(const Project& project);
// The same with the content of the camera file, or the calibration, at hand.
Capture gather_capture(const Project& project, const std::vector<Camera>& cameras);
Capture gather_capture(const Project& project, const Calibration& calibration);

// The capture with these strokes, of the photos that it uses: quick, since no file is read again.
void take_strokes(Capture& capture, const Strokes& strokes);

// What to do about a project without cameras, in words: "find them with ...".
std::string cameras_remedy(const std::filesystem::path& project_folder);

// The names of the project's photos, sorted. Throws Error when two have the same.
std::vector<std::string> photo_names(const Project& project);

// All of the camera.
void hash_camera(ContentHasher& hasher, const Camera& camera);

}  // namespace bosk
