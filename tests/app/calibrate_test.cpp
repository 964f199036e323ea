// `bosk calibrate` as a user meets it: photos without anything in them, and clicks that a walk with
// known truth would give. Bad captures end in one sentence and leave the project as it was.

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/calibrate/lens_profile.h"
#include "core/photo/camera_files.h"
#include "tests/app/program.h"
#include "tests/base/scratch_folder.h"
#include "tests/calibrate/orbit.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AnyOf;
using testing::HasSubstr;

void write_blank_photo(const fs::path& path, int width, int height, int focal_35mm = 0) {
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("Compression", "jpeg:90");
  if (focal_35mm > 0) spec.attribute("Exif:FocalLengthIn35mmFilm", focal_35mm);
  const std::vector<unsigned char> grey(std::size_t(width) * std::size_t(height) * 3, 128);
  auto output = OIIO::ImageOutput::create("jpg");
  const bool written = output && output->open(path.string(), spec) &&
                       output->write_image(OIIO::TypeDesc::UINT8, grey.data()) && output->close();
  if (!written) throw std::runtime_error("no photo for the test");
}

// A walk round eight markers with a lens of known truth.
class Calibrate : public testing::Test {
 protected:
  Calibrate() : orbit(make_orbit({.photos = 12, .noise_px = 0.3, .gross = 0.0, .missing = 0.0})) {}

  // Writes what was changed of the orbit; every photo gets a byte of its own, so that none is a
  // copy of another.
  void write_capture(int focal_35mm = 0) const {
    fs::create_directories(folder / "photos");
    json clicks = json::array();
    for (const PhotoSightings& photo : orbit.photos) {
      const fs::path file = folder / "photos" / (photo.photo + ".jpg");
      write_blank_photo(file, photo.width_px, photo.height_px, focal_35mm);
      fs::resize_file(file, fs::file_size(file) + 1 + std::size_t(&photo - orbit.photos.data()));
      for (const Sighting& seen : photo.sightings) {
        clicks.push_back({{"photo", photo.photo},
                          {"point", seen.point},
                          {"x", seen.pixel.x},
                          {"y", seen.pixel.y}});
      }
    }
    write_file_atomically(folder / "clicks.json", clicks.dump());
  }
  void make_project() const {
    ASSERT_EQ(bosk({"new", "p", "photos", "--calibrate.find_balls=false",
                    "--calibrate.features=off", "--quiet"})
                  .status,
              0);
  }
  ProgramEnd bosk(const std::vector<std::string>& arguments) const {
    return run_bosk(arguments, folder.path());
  }
  std::vector<std::string> with_clicks(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"calibrate", "p", "--quiet", "--sightings",
                                          "clicks.json"};
    const Tape tape = exact_tape(orbit, orbit.names[0], orbit.names[4]);
    arguments.insert(arguments.end(),
                     {"--tape", tape.from, tape.to, std::to_string(tape.length_m)});
    for (const Height& height : exact_heights(orbit)) {
      arguments.insert(arguments.end(),
                       {"--height", height.point, std::to_string(height.height_m)});
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  std::string project_file() const { return content_of(folder / "p" / "project.json"); }

  // Nothing of what was told is kept, and one sentence says why.
  void expect_refusal(const std::vector<std::string>& arguments, const std::string& part) const {
    const std::string before = project_file();
    const ProgramEnd end = bosk(arguments);
    EXPECT_EQ(end.status, 3) << end.out << end.err;
    EXPECT_THAT(end.out + end.err, HasSubstr(part));
    EXPECT_EQ(project_file(), before);
  }
  // Captures that can't be right come back as such, or with the culprit named; never as good ones
  // that aren't.
  void expect_words(const ProgramEnd& end, const std::string& culprit) const {
    EXPECT_THAT(end.status, AnyOf(3, 4)) << end.out << end.err;
    EXPECT_THAT(end.out, HasSubstr(culprit));
  }

  ScratchFolder folder;
  Orbit orbit;
};

TEST_F(Calibrate, FindsCamerasLensScaleAndUpFromClicks) {
  write_capture();
  make_project();
  const ProgramEnd end = bosk(with_clicks({"--json"}));
  EXPECT_THAT(end.status, AnyOf(0, 4)) << end.err;
  const json result = json::parse(end.out);
  EXPECT_EQ(result.at("photos").size(), 12u);
  EXPECT_EQ(result.at("scale_known"), true);
  EXPECT_EQ(result.at("up_known"), true);
  EXPECT_EQ(result.at("exit_status"), end.status);
  EXPECT_LT(result.at("rms_px").get<double>(), 1.0);
}

TEST_F(Calibrate, GivesItsCamerasToWhatFollows) {
  write_capture();
  make_project();
  EXPECT_THAT(bosk({"matte", "p", "--quiet", "--calibrate.tags=none"}).err,
              HasSubstr("no cameras could be found"));
  bosk(with_clicks());
  ASSERT_EQ(bosk({"export", "p", "--to", "transforms", "cameras.json", "--quiet"}).status, 0);
  const auto cameras = read_cameras(folder / "cameras.json");
  ASSERT_EQ(cameras.size(), orbit.cameras.size());
  // Heights of eyes come out in metres; 5 cm at 7 m is 8 px in these photos
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    EXPECT_NEAR(cameras[i].centre_in_world().z, orbit.cameras[i].centre_in_world().z, 0.05);
  }
  EXPECT_THAT(bosk({"info", "p"}).out, HasSubstr("12 of 12 photos"));
}

TEST_F(Calibrate, AskedAgainIsDoneAtOnceAndRewritesNothing) {
  write_capture();
  make_project();
  const ProgramEnd first = bosk(with_clicks());
  const auto time = fs::last_write_time(folder / "p" / "project.json");
  const ProgramEnd again = bosk({"calibrate", "p", "--quiet"});
  EXPECT_EQ(again.status, first.status);
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(fs::last_write_time(folder / "p" / "project.json"), time);
}

TEST_F(Calibrate, WritesAPageThatShowsItAll) {
  write_capture();
  make_project();
  bosk(with_clicks({"--report", "page.html"}));
  const std::string page = content_of(folder / "page.html");
  for (const std::string part : {"<h1>p: cameras</h1>", "oak_07", "The walk, from above",
                                 "data:image/jpeg;base64,", ">red</text>"}) {
    EXPECT_THAT(page, HasSubstr(part));
  }
  EXPECT_EQ(page.find("http"), std::string::npos) << "the page must need nothing else";
}

TEST_F(Calibrate, AClickThatIsRemovedStaysRemoved) {
  write_capture();
  make_project();
  bosk(with_clicks());
  write_file_atomically(folder / "less.json",
                        R"([{"photo": "oak_03", "point": "red", "removed": true}])");
  const json less =
      json::parse(bosk({"calibrate", "p", "--quiet", "--json", "--sightings", "less.json"}).out);
  for (const json& residual : less.at("residuals")) {
    EXPECT_FALSE(residual.at("photo") == "oak_03" && residual.at("point") == "red");
  }
}

TEST_F(Calibrate, RefusesWhatIsWrittenWronglyAsBadUsage) {
  write_capture();
  make_project();
  const std::string before = project_file();
  const std::vector<std::vector<std::string>> wrong = {{"--tape", "red", "blue", "long"},
                                                       {"--tape", "red", "blue", "2.35+-"},
                                                       {"--tape", "red", "red", "2.35"},
                                                       {"--tape", "red", "blue", "-1"},
                                                       {"--height", "red", "1.5m"},
                                                       {"--board", "9"},
                                                       {"--board", "1x1"},
                                                       {"--square", "0"},
                                                       {"--calibrate.features=perhaps"},
                                                       {"--point", "red", "1", "2", "up"}};
  for (const auto& arguments : wrong) {
    std::vector<std::string> all = {"calibrate", "p", "--quiet"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const ProgramEnd end = bosk(all);
    EXPECT_EQ(end.status, 2) << testing::PrintToString(arguments) << end.err;
    EXPECT_FALSE(end.err.empty());
  }
  EXPECT_EQ(project_file(), before);
}

TEST_F(Calibrate, RefusesFilesThatAreNoUse) {
  write_capture();
  make_project();
  write_file_atomically(folder / "none.json", "[{}]");
  expect_refusal({"calibrate", "p", "--quiet", "--sightings", "none.json"}, "entry 1 lacks");
  expect_refusal({"calibrate", "p", "--quiet", "--lens", "none.json"}, "none.json");
  expect_refusal({"calibrate", "p", "--quiet", "--boards", "nowhere"}, "nowhere");
  expect_refusal({"calibrate", "p", "--quiet", "--save-lens", "lens.json"}, "");
  EXPECT_FALSE(fs::exists(folder / "lens.json"));
}

TEST_F(Calibrate, NoBoardInAnyBoardPhoto) {
  write_capture();
  make_project();
  fs::create_directory(folder / "boards");
  for (const std::string name : {"oak_00.jpg", "oak_01.jpg"}) {
    fs::copy(folder / "photos" / name, folder / "boards" / name);
  }
  expect_refusal(with_clicks({"--board", "9x6", "--square", "30", "--boards", "boards",
                              "--save-lens", "lens.json"}),
                 "board");
  EXPECT_FALSE(fs::exists(folder / "lens.json"));
}

TEST_F(Calibrate, OnePhoto) {
  orbit.photos.resize(1);
  write_capture();
  make_project();
  expect_refusal(with_clicks(), "photo");
}

TEST_F(Calibrate, WithoutAnyClick) {
  write_capture();
  make_project();
  expect_refusal({"calibrate", "p", "--quiet"}, "refused");
}

TEST_F(Calibrate, AllMarkersOnALine) {
  for (std::size_t i = 0; i < orbit.points.size(); ++i) {
    orbit.points[i] = glm::dvec3(-1.4 + 0.4 * double(i), 0.0, 0.9);
  }
  for (std::size_t i = 0; i < orbit.photos.size(); ++i) {
    orbit.photos[i] = exact_sightings(orbit, orbit.cameras[i]);
  }
  write_capture();
  make_project();
  expect_refusal(with_clicks(), "line");
}

TEST_F(Calibrate, TwoColoursSwappedInOnePhoto) {
  for (Sighting& seen : orbit.photos[4].sightings) {
    if (seen.point == "red") {
      seen.point = "green";
    } else if (seen.point == "green") {
      seen.point = "red";
    }
  }
  write_capture();
  make_project();
  expect_words(bosk(with_clicks()), "oak_04");
}

TEST_F(Calibrate, AMarkerThatWasMovedBetweenShots) {
  Orbit moved = orbit;
  moved.points[0] += glm::dvec3(0.4, 0.3, 0.0);
  for (std::size_t i = 6; i < orbit.photos.size(); ++i) {
    orbit.photos[i] = exact_sightings(moved, orbit.cameras[i]);
  }
  write_capture();
  make_project();
  expect_words(bosk(with_clicks()), orbit.names[0]);
}

TEST_F(Calibrate, PhotosOfTwoSizes) {
  for (std::size_t i = 9; i < orbit.photos.size(); ++i) orbit.photos[i].width_px = 1000;
  for (std::size_t i = 9; i < orbit.photos.size(); ++i) {
    std::erase_if(orbit.photos[i].sightings,
                  [](const Sighting& seen) { return seen.pixel.x > 999.0; });
  }
  write_capture();
  make_project();
  expect_words(bosk(with_clicks()), "oak_09");
}

TEST_F(Calibrate, ExifThatLiesAboutTheFocalLength) {
  // 26 mm for 43.27 mm of diagonal is a focal length of 1062 px, which is the truth; this is 30 %
  // more
  write_capture(34);
  make_project();
  const ProgramEnd end = bosk(with_clicks({"--json"}));
  EXPECT_THAT(end.status, AnyOf(0, 4)) << end.out;
  const json result = json::parse(end.out);
  EXPECT_NEAR(result.at("lens").at("focal_px").at(0).get<double>(), orbit.lens.focal_px.x, 30.0);
  EXPECT_THAT(result.at("sentences").dump(), HasSubstr("EXIF"));
}

TEST_F(Calibrate, ACameraFileIsNotPassedOverInSilence) {
  write_capture();
  make_project();
  write_cameras(orbit.cameras, "transforms", folder / "known.json");
  ASSERT_EQ(bosk({"new", "p", "--replace", "--cameras", "known.json", "--quiet",
                  "--calibrate.find_balls=false", "--calibrate.features=off"})
                .status,
            0);
  expect_refusal(with_clicks(), "--replace");
  EXPECT_THAT(bosk(with_clicks({"--replace"})).status, AnyOf(0, 4));
  EXPECT_THAT(bosk({"info", "p"}).out, HasSubstr("12 of 12 photos"));
}

}  // namespace
}  // namespace bosk
