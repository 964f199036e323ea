// Strokes on their way through a project: file, keys, mattes, photos held out.

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/project/hold_out.h"
#include "core/project/new_project.h"
#include "core/project/project_json.h"
#include "core/project/run.h"
#include "core/project/session.h"
#include "tests/project/random_edits.h"
#include "tests/project/tiny_capture_test.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

class StrokesInProject : public TinyCaptureTest {
 protected:
  // Its own folder for each test, since they are all one process's.
  static Project project_with(const char* scribbles) {
    const fs::path capture = *scratch / "capture";
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    return make_project({*scratch / name,
                         {capture / "photos"},
                         capture / "transforms.json",
                         {},
                         scribbles ? capture / scribbles : fs::path()},
                        {}, true, Progress());
  }
  static ContentHash key(const Project& project, const std::string& stage = "matte") {
    return stage_key(gather_capture(project), project.recipe, stage);
  }
  // What matting refuses or warns of.
  static std::string complaint(const Project& project) {
    std::string warnings;
    Progress progress({}, [&](const std::string& sentence) { warnings += sentence; });
    try {
      run_stages(project, gather_capture(project), {"matte"}, progress);
    } catch (const Error& error) {
      return error.what();
    }
    return warnings;
  }
};

// Over the stem and over the sky, whatever the photo: its size is 96 to 200 px.
const std::vector<Stroke> kBothKinds = {{StrokeKind::foreground, 6.0, {{48.0, 40.0}, {48.0, 60.0}}},
                                        {StrokeKind::background, 4.0, {{4.0, 4.0}, {80.0, 4.0}}}};

TEST_F(StrokesInProject, ReadBackFromProjectJson) {
  const ScratchFolder folder;
  Project project = saved_project(folder.path());
  Random random(2);
  for (int i = 0; i < 30; ++i) project.strokes["\xc3\xa4 b"].push_back(random_stroke(random));
  project.strokes["oak_01"] = {
      rounded_stroke({StrokeKind::erase, 1e5, {{-1e6, 1e6}, {0.0625, -0.9375}, {123456.5, 0.0}}})};
  project.journal = {~std::uint64_t(0), std::uint64_t(1) << 40};
  save_project(project);
  const Project read = read_project(folder.path());
  EXPECT_EQ(read.strokes, project.strokes);
  EXPECT_EQ(read.journal, project.journal);
}

TEST_F(StrokesInProject, RaiseTheSchemaOnlyWhereThereAreSome) {
  Project project;
  EXPECT_NE(project_text(project).find("\"bosk_project\": 1"), std::string::npos);
  project.strokes["oak"];
  EXPECT_NE(project_text(project).find("\"bosk_project\": 1"), std::string::npos);
  project.strokes["oak"] = kBothKinds;
  EXPECT_NE(project_text(project).find("\"bosk_project\": 2"), std::string::npos);
}

TEST_F(StrokesInProject, DamagedInProjectJsonAreRefusedInWords) {
  Project project;
  project.strokes["oak"] = kBothKinds;
  const std::string sound = project_text(project);
  const std::pair<const char*, const char*> injuries[] = {{"\"foreground\"", "\"front\""},
                                                          {"48,40", "48;40"},
                                                          {"48,40", "48"},
                                                          {"48,40", "nan,40"},
                                                          {"48,40", "1e7,40"},
                                                          {"\"radius_px\": 6", "\"radius_px\": -6"},
                                                          {"\"radius_px\": 6", "\"radius\": 6"},
                                                          {"4,4 80,4", ""},
                                                          {"\"oak\": [", "\"oak\": [1,"}};
  for (const auto& [old, fresh] : injuries) {
    std::string text = sound;
    const std::size_t place = text.find(old);
    ASSERT_NE(place, std::string::npos) << old;
    text.replace(place, std::string(old).size(), fresh);
    EXPECT_THROW(project_of_text(std::as_bytes(std::span(text)), "project.json"), Error) << fresh;
  }
}

TEST_F(StrokesInProject, ChangeTheKeysFromTheMattesOnAndNothingWhereThereAreNone) {
  Project project = project_with("scribbles");
  const ContentHash without = key(project), photos = key(project, "photo");
  project.strokes["002"] = kBothKinds;
  EXPECT_NE(key(project), without);
  EXPECT_EQ(key(project, "photo"), photos);
  EXPECT_NE(key(project, "pack"), without);
  project.strokes["002"].clear();
  EXPECT_EQ(key(project), without);
  project.strokes["none of the photos"] = kBothKinds;
  EXPECT_EQ(key(project), without);
  EXPECT_EQ(gather_capture(project).remarks.size(), 1u);
}

TEST_F(StrokesInProject, EveryDetailOfAStrokeCounts) {
  Project project = project_with("scribbles");
  project.strokes["002"] = kBothKinds;
  std::set<ContentHash> keys = {key(project)};
  const auto with = [&](auto change) {
    Project other = project;
    change(other.strokes["002"]);
    EXPECT_TRUE(keys.insert(key(other)).second);
  };
  with([](auto& strokes) { strokes[0].kind = StrokeKind::erase; });
  with([](auto& strokes) { strokes[0].kind = StrokeKind::background; });
  with([](auto& strokes) { strokes[0].radius_px += kStrokeStepPx; });
  with([](auto& strokes) { strokes[1].points_px[1].y += kStrokeStepPx; });
  with([](auto& strokes) { strokes[1].points_px.pop_back(); });
  with([](auto& strokes) { std::swap(strokes[0], strokes[1]); });
  with([](auto& strokes) { strokes.pop_back(); });
}

TEST_F(StrokesInProject, OfLeftOutPhotosDoNotCount) {
  Project project = project_with("scribbles");
  Capture plain = gather_capture(project);
  project.strokes["002"] = kBothKinds;
  Capture drawn = gather_capture(project);
  plain.left_out = drawn.left_out = {"002"};
  EXPECT_EQ(stage_key(plain, project.recipe, "matte"), stage_key(drawn, project.recipe, "matte"));
}

TEST_F(StrokesInProject, BesideReadyMadeMattesDoNotCount) {
  Project project = project_with(nullptr);
  project.mattes = "../capture/mattes";
  const ContentHash without = key(project);
  project.strokes["002"] = kBothKinds;
  EXPECT_EQ(key(project), without);
}

TEST_F(StrokesInProject, MakeMattesWithoutAnyFile) {
  Project project = project_with(nullptr);
  project.strokes["002"] = kBothKinds;
  EXPECT_EQ(complaint(project).find("guessed"), std::string::npos);
}

TEST_F(StrokesInProject, OfOneKindOrErasedCorrectAGuess) {
  Project project = project_with(nullptr);
  const std::string guessed = "the tree was guessed";
  EXPECT_NE(complaint(project).find(guessed), std::string::npos);
  project.strokes["002"] = {kBothKinds[0]};
  EXPECT_NE(complaint(project).find(guessed), std::string::npos);
  project.strokes["002"] = kBothKinds;
  project.strokes["002"].push_back({StrokeKind::erase, 1e5, {{50.0, 50.0}}});
  EXPECT_NE(complaint(project).find(guessed), std::string::npos);
}

TEST_F(StrokesInProject, GoOverTheFiles) {
  Project project = project_with("scribbles");
  const std::string scribbled = gather_capture(project).scribbles.front().name;
  project.strokes[scribbled] = {{StrokeKind::erase, 1e5, {{50.0, 50.0}}}};
  EXPECT_NE(complaint(project).find("the tree was guessed"), std::string::npos)
      << "all that the file says is erased";
  project.strokes[scribbled].insert(project.strokes[scribbled].end(), kBothKinds.begin(),
                                    kBothKinds.end());
  EXPECT_EQ(complaint(project).find("guessed"), std::string::npos);
}

TEST_F(StrokesInProject, PhotosThatHaveSomeAreNotHeldOut) {
  Project project = project_with("scribbles");
  const std::set<std::string> before = held_out_names(gather_capture(project), 2);
  const std::string drawn = *before.begin();
  project.strokes[drawn] = kBothKinds;
  EXPECT_EQ(held_out_names(gather_capture(project), 2).count(drawn), 0u);
}

TEST_F(StrokesInProject, GiveTheSameKeysFromTheJournalAndFromProjectJson) {
  const Project made = project_with("scribbles");
  Session session(made.folder);
  session.apply(AddStroke{"002", {StrokeKind::foreground, 6.03, {{47.97, 40.0}, {48.01, -0.01}}}});
  session.apply(AddStroke{"002", kBothKinds[1]});
  session.apply(option_edit(session.project(), "matte.clusters", "5"));
  session.apply(AddStroke{"003", kBothKinds[1]});
  session.undo();
  const ContentHash from_memory = key(session.project(), "pack");
  const ContentHash from_journal = key(read_project(made.folder), "pack");
  session.save();
  const ContentHash from_json = key(read_saved_project(made.folder), "pack");
  EXPECT_EQ(from_memory, from_journal);
  EXPECT_EQ(from_memory, from_json);
}

TEST_F(StrokesInProject, TakeStrokesGivesWhatGatheringAnewWould) {
  Project project = project_with("scribbles");
  Capture capture = gather_capture(project);
  project.strokes["002"] = kBothKinds;
  project.strokes["none of the photos"] = kBothKinds;
  take_strokes(capture, project.strokes);
  EXPECT_EQ(capture.strokes, gather_capture(project).strokes);
}

}  // namespace
}  // namespace bosk
