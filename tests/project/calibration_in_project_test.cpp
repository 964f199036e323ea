// What a person tells calibration, on its way through a project: file, journal, keys.

#include <gtest/gtest.h>

#include <set>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/project/calibration_sources.h"
#include "core/project/project_json.h"
#include "core/project/session.h"
#include "core/project/sightings_file.h"
#include "tests/base/scratch_folder.h"
#include "tests/project/random_edits.h"

namespace bosk {
namespace {

Project told_project() {
  Project project;
  project.calibration.sightings["oak"]["red"] = {true, {12.25, -0.125}};
  project.calibration.sightings["oak"]["blue"] = {false, {}};
  project.calibration.measurements = {
      {{"red", "blue", 2.35, 0.003}}, {{"red", 1.5, 0.01}}, {{"post", {1.0, -2.0, 0.25}, 0.02}}};
  project.calibration.boards = "../boards";
  project.calibration.lens = "../lens.json";
  return project;
}

std::string injured(std::string text, const std::string& old, const std::string& fresh) {
  const std::size_t place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return place == std::string::npos ? text : text.replace(place, old.size(), fresh);
}

Project read_text(const std::string& text) {
  return project_of_text(std::as_bytes(std::span(text)), "project.json");
}

TEST(CalibrationInProject, ReadsBackFromProjectJson) {
  const Project told = told_project();
  const Project read = read_text(project_text(told));
  EXPECT_EQ(read.calibration.sightings, told.calibration.sightings);
  EXPECT_EQ(read.calibration.measurements, told.calibration.measurements);
  EXPECT_EQ(read.calibration.boards, told.calibration.boards);
  EXPECT_EQ(read.calibration.lens, told.calibration.lens);
}

TEST(CalibrationInProject, RaisesTheSchemaOnlyWhereSomethingIsTold) {
  EXPECT_NE(project_text(Project()).find("\"bosk_project\": 1"), std::string::npos);
  EXPECT_NE(project_text(told_project()).find("\"bosk_project\": 3"), std::string::npos);
}

TEST(CalibrationInProject, DamagedIsRefusedInWords) {
  const std::string sound = project_text(told_project());
  const std::pair<const char*, const char*> injuries[] = {
      {"12.25", "\"12\""},
      {"-0.125", "-0.125, 3"},
      {"12.25", "1e300"},
      {"\"length_m\": 2.35", "\"length_m\": -1"},
      {"\"length_m\"", "\"length\""},
      {"\"sigma_m\": 0.003", "\"sigma_m\": 0"},
      {"\"to\": \"blue\"", "\"to\": \"red\""},
      {"\"point\": \"red\"", "\"point\": 3"},
      {"\"../boards\"", "7"},
      {"\"red\": [", "\"\": ["}};
  for (const auto& [old, fresh] : injuries) {
    const std::string text = injured(sound, old, fresh);
    try {
      read_text(text);
      ADD_FAILURE() << "accepted: " << fresh;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("project.json: "), std::string::npos);
    }
  }
}

TEST(CalibrationInProject, IsTheSameFromTheJournalAndFromProjectJson) {
  const ScratchFolder folder;
  saved_project(folder.path());
  Session session(folder.path());
  const Project told = told_project();
  for (const auto& [photo, points] : told.calibration.sightings) {
    for (const auto& [point, said] : points) {
      session.apply(sighting_edit(session.project(), photo, point, said));
    }
  }
  session.apply(measurements_edit(session.project(), told.calibration.measurements));
  session.apply(files_edit(session.project(), FileKind::boards, told.calibration.boards));
  session.apply(files_edit(session.project(), FileKind::lens, told.calibration.lens));
  session.apply(sighting_edit(session.project(), "oak", "red", std::nullopt));
  session.undo();
  const std::string in_memory = content_of(session.project());
  EXPECT_EQ(content_of(read_project(folder.path())), in_memory);
  session.save();
  EXPECT_EQ(content_of(read_saved_project(folder.path())), in_memory);
  EXPECT_EQ(session.project().calibration.sightings, told.calibration.sightings);
}

TEST(CalibrationKey, ChangesWithEverythingTold) {
  CalibrationSources sources;
  sources.photos = {{"oak", "oak.jpg", {1, 2}}};
  std::set<ContentHash> keys = {calibration_key(sources)};
  const auto with = [&](auto change) {
    CalibrationSources other = sources;
    change(other);
    EXPECT_TRUE(keys.insert(calibration_key(other)).second) << keys.size();
  };
  with([](auto& s) { s.photos[0].content.low = 3; });
  with([](auto& s) { s.photos[0].name = "elm"; });
  with([](auto& s) { s.boards = {{"b", "b.jpg", {1, 2}}}; });
  with([](auto& s) { s.profile = SourceFile{"lens", "lens.json", {5, 6}}; });
  with([](auto& s) { s.sightings["oak"]["red"] = {true, {1.0, 2.0}}; });
  with([](auto& s) { s.sightings["oak"]["red"] = {true, {1.0, 2.5}}; });
  with([](auto& s) { s.sightings["oak"]["red"] = {false, {}}; });
  with([](auto& s) { s.measurements.tapes = {{"a", "b", 1.0, 0.002}}; });
  with([](auto& s) { s.measurements.tapes = {{"a", "b", 1.0, 0.003}}; });
  with([](auto& s) { s.measurements.heights = {{"a", 1.0, 0.002}}; });
  with([](auto& s) { s.measurements.points = {{"a", {0, 0, 1}, 0.002}}; });
  with([](auto& s) { s.options.find_balls = false; });
  with([](auto& s) { s.options.shape.square_m = 0.1; });
}

TEST(CalibrationKey, KnowsNoPathsAndNoLimits) {
  CalibrationSources sources;
  sources.photos = {{"oak", "oak.jpg", {1, 2}}};
  const ContentHash key = calibration_key(sources);
  sources.photos[0].path = "/elsewhere/oak.jpg";
  sources.limits.max_megapixels = 7.0;
  EXPECT_EQ(calibration_key(sources), key);
}

class SightingsFile : public testing::Test {
 protected:
  HandFile read(const std::string& text) const {
    const auto file = folder / "clicks.json";
    write_file_atomically(file, text);
    return read_sightings_file(file, project);
  }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }

  ScratchFolder folder;
  Project project = saved_project(folder.path());
};

TEST_F(SightingsFile, TakesPhotosWithAndWithoutTheirEnding) {
  const HandSightings told = read(
                                 R"([{"photo": "oak_01", "point": "red", "x": 1.5, "y": 2},
          {"photo": "oak_02.jpg", "point": "red", "removed": true}])")
                                 .sightings;
  EXPECT_EQ(told.at("oak_01").at("red"), (HandSighting{true, {1.5, 2.0}}));
  EXPECT_EQ(told.at("oak_02").at("red"), (HandSighting{false, {}}));
}

TEST_F(SightingsFile, TellsWhatIsLeftOut) {
  const HandFile told =
      read(R"([{"photo": "oak_01.jpg", "left_out": [[3, 4], [5, 6.5]], "radius": 20}])");
  EXPECT_TRUE(told.sightings.empty());
  const Stroke expected{StrokeKind::left_out, 20.0, {{3.0, 4.0}, {5.0, 6.5}}};
  EXPECT_EQ(told.left_out.at("oak_01"), std::vector<Stroke>{expected});
  EXPECT_NE(refusal(R"([{"photo": "oak_01", "left_out": [[3, 4]]}])").find("entry 1 lacks"),
            std::string::npos);
  EXPECT_NE(refusal(R"([{"photo": "oak_01", "left_out": [], "radius": 9}])").find("points"),
            std::string::npos);
}

TEST_F(SightingsFile, IsRefusedInWordsThatNameTheEntry) {
  EXPECT_NE(refusal("{}").find("no JSON list"), std::string::npos);
  EXPECT_NE(refusal("[").find("no JSON list"), std::string::npos);
  EXPECT_NE(refusal(R"([{"photo": "oak_01", "point": "red", "x": 1}])").find("entry 1 lacks"),
            std::string::npos);
  EXPECT_NE(refusal(R"([{"photo": "oak_01", "point": "red", "x": 1, "y": 1e9}])").find("no pixel"),
            std::string::npos);
  const std::string click = R"({"photo": "oak_01", "point": "red", "x": 1, "y": 2})";
  EXPECT_NE(refusal("[" + click + "," + click + "]").find("entry 2 is refused"), std::string::npos);
  EXPECT_NE(refusal(R"([{"photo": "elm", "point": "red", "x": 1, "y": 2}])").find("no photo"),
            std::string::npos);
}

}  // namespace
}  // namespace bosk
