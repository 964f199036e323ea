#include "core/project/camera_choice.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/project/capture.h"
#include "core/project/edit.h"
#include "core/project/new_project.h"
#include "tests/project/tiny_capture_test.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

class CameraChoiceTest : public TinyCaptureTest {
 protected:
  static fs::path capture() { return *scratch / "capture"; }
  static Project photos_alone(const fs::path& folder) {
    return make_project({folder, {capture() / "photos"}, {}, {}, {}}, {}, true, Progress());
  }
  // NeRF's own: an angle for all, no sizes, pictures without ending where they may not be.
  static fs::path without_sizes(const std::string& pictures) {
    const fs::path file = *scratch / "nerf.json";
    std::ofstream stream(file);
    stream << R"({"camera_angle_x": 0.7, "frames": [)";
    for (int i = 0; i < 6; ++i) {
      stream << (i > 0 ? "," : "") << R"({"file_path": ")" << pictures << "/00" << i
             << R"(.jpg", "transform_matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,)" << i
             << "],[0,0,0,1]]}";
    }
    stream << "]}";
    return file;
  }
};

TEST_F(CameraChoiceTest, CountsPhotosWithACameraAndNamesTheOthers) {
  Project project = photos_alone(*scratch / "counts");
  project.photos.push_back("../elsewhere/stranger.jpg");
  const CameraChoice choice = match_cameras(project, capture() / "transforms.json", Progress());
  EXPECT_EQ(choice.matched, 6u);
  EXPECT_EQ(choice.unmatched, (std::vector<std::string>{"stranger"}));
  EXPECT_EQ(project_path(choice, project), "../capture/transforms.json");
}

TEST_F(CameraChoiceTest, SaysWhyAFileIsNoCameraFile) {
  const Project project = photos_alone(*scratch / "refusals");
  EXPECT_THROW(match_cameras(project, capture() / "none.json", Progress()), Error);
  EXPECT_THROW(match_cameras(project, capture() / "truth.json", Progress()), Error);
}

TEST_F(CameraChoiceTest, TakesSizesFromThePhotosOfTheProject) {
  const Project project = photos_alone(*scratch / "sizes");
  const fs::path file = without_sizes("nowhere");
  const CameraChoice choice = match_cameras(project, file, Progress());
  EXPECT_EQ(choice.matched, 6u);
  const fs::path stored = project_path(choice, project);
  EXPECT_EQ(stored.parent_path(), "");
  EXPECT_EQ(read_cameras(project.absolute(stored)).size(), 6u);
  // Other cameras get another file, so that undoing finds the earlier ones
  CameraChoice other = choice;
  other.known.file.cameras[0].lens.focal_px *= 2.0;
  EXPECT_NE(project_path(other, project), stored);
}

TEST_F(CameraChoiceTest, AProjectOfPhotosAloneBecomesTheOneWithCameras) {
  const NewProject wanted{*scratch / "direct",
                          {capture() / "photos"},
                          capture() / "transforms.json",
                          {},
                          capture() / "scribbles"};
  const Project direct = make_project(wanted, {}, true, Progress());
  Project later = make_project({*scratch / "later", wanted.photos, {}, {}, wanted.scribbles}, {},
                               true, Progress());
  EXPECT_TRUE(later.cameras.empty());
  const CameraChoice choice = match_cameras(later, wanted.cameras, Progress());
  apply(files_edit(later, FileKind::cameras, project_path(choice, later)), later);
  EXPECT_EQ(later.photos, direct.photos);
  EXPECT_EQ(later.cameras, direct.cameras);
  EXPECT_EQ(later.scribbles, direct.scribbles);
}

TEST_F(CameraChoiceTest, AProjectWithoutCamerasSaysWhatIsNext) {
  const Project project = photos_alone(*scratch / "next");
  EXPECT_EQ(read_project(project.folder).photos.size(), 6u);
  try {
    gather_capture(project);
    FAIL() << "gathered";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("no cameras yet"), std::string::npos) << text;
    EXPECT_NE(text.find("bosk new --replace"), std::string::npos) << text;
    EXPECT_NE(text.find("bosk open"), std::string::npos) << text;
  }
}

TEST_F(CameraChoiceTest, ReplacingKeepsPhotosThatAreNotNamedAnewAndStrokes) {
  const fs::path folder = *scratch / "replaced";
  Project project = photos_alone(folder);
  project.strokes["001"] = {{StrokeKind::foreground, 5.0, {{9.0, 9.0}}}};
  project.strokes["gone"] = project.strokes["001"];
  project.journal = {7, 16};
  save_project(project);
  // A COLMAP model doesn't say where its pictures lie
  write_cameras(read_cameras(capture() / "transforms.json"), "colmap", *scratch / "sparse");
  const Project replaced =
      make_project({folder, {}, *scratch / "sparse", {}, {}}, {}, true, Progress());
  EXPECT_EQ(replaced.photos, project.photos);
  ASSERT_EQ(replaced.strokes.size(), 1u);
  EXPECT_EQ(replaced.strokes.at("001"), project.strokes.at("001"));
  EXPECT_EQ(replaced.journal, JournalPlace());
}

}  // namespace
}  // namespace bosk
