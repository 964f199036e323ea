#include "ui/workstation/photos/photos_step.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/photo/photo_writer.h"
#include "tests/ui/workstation/small_capture.h"
#include "ui/widgets/keys.h"
#include "ui/workstation/capture_files.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

class PhotosStep : public SmallCaptureStep {
 protected:
  PhotosStepState& state() { return hand.workspace().photos; }
  std::size_t photo_count() { return workspace().project().photos.size(); }
  PhotoRow row(const std::string& name) {
    const PhotoRow* found = row_of(workspace(), name);
    EXPECT_TRUE(found) << name;
    return found ? *found : PhotoRow();
  }
  void drop(const std::vector<fs::path>& paths) {
    hand.drop(paths);
    ASSERT_TRUE(hand.settle());
  }
  void expect_said(const std::string& words) { expect_told(state().said, words); }
};

TEST_F(PhotosStep, ATypedFolderAddsItsPhotosInOneEdit) {
  hand.click("photos/path");
  hand.type(capture.photos().string());
  hand.click("photos/add");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(photo_count(), 10u);
  expect_said("Added 10 photos");
  EXPECT_TRUE(hand.sees("photos/tile/000"));
  hand.click("undo");
  EXPECT_EQ(photo_count(), 0u);
  EXPECT_FALSE(workspace().session->can_undo());
}

TEST_F(PhotosStep, ATypedFileIsTakenByEnter) {
  hand.click("photos/path");
  hand.type(capture.photo("003").string());
  hand.key(kKeyEnter);
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(photo_count(), 1u);
  EXPECT_TRUE(row("003").accepted);
}

TEST_F(PhotosStep, AWrongPathIsToldAndChangesNothing) {
  hand.click("photos/path");
  hand.type("/nowhere/at/all.jpg");
  hand.click("photos/add");
  EXPECT_EQ(photo_count(), 0u);
  expect_said("/nowhere/at/all.jpg: there is no such file");
  EXPECT_FALSE(workspace().session->can_undo());
}

TEST_F(PhotosStep, BlanksAreNoPath) {
  hand.click("photos/path");
  hand.type("   ");
  hand.key(kKeyEnter);
  EXPECT_EQ(photo_count(), 0u);
  EXPECT_TRUE(state().said.empty());
}

TEST_F(PhotosStep, DroppedPhotosAreAddedFromAnyStep) {
  for (const WorkStep step : kSteps) {
    workspace().step = step;
    drop({capture.photo("00" + std::to_string(int(step)))});
    EXPECT_EQ(workspace().step, WorkStep::photos);
    EXPECT_EQ(photo_count(), std::size_t(step) + 1);
  }
}

TEST_F(PhotosStep, PhotosAreAddedOnce) {
  drop({capture.photos()});
  drop({capture.photo("000")});
  EXPECT_EQ(photo_count(), 10u);
  expect_said("already in the project");
}

TEST_F(PhotosStep, ThumbnailsOfAllPhotosAppear) {
  drop({capture.photos()});
  for (const PhotoRow& each : state().shelf.rows) {
    const ShelvedPhoto* photo = shelved(workspace(), each.file);
    ASSERT_TRUE(photo && photo->thumbnail) << each.name;
    EXPECT_EQ(photo->thumbnail->width(), 96);
    EXPECT_TRUE(photo->facts.decoded.pixels.empty());
  }
  EXPECT_GE(hand.textures().uploads, 1);
}

TEST_F(PhotosStep, ABrokenFileGetsItsReasonAndTheOthersStay) {
  const fs::path broken = write_broken_photo(capture.scratch / "broken.jpg");
  drop({capture.photo("000"), broken, capture.photo("001")});
  EXPECT_EQ(row("broken").word, "left out");
  EXPECT_THAT(row("broken").reason, HasSubstr("cannot be decoded"));
  EXPECT_TRUE(row("000").accepted);
  EXPECT_TRUE(row("001").accepted);
}

TEST_F(PhotosStep, ACopyIsLeftOutAndAGuessIsTold) {
  fs::copy_file(capture.photo("000"), capture.scratch / "copy.jpg");
  drop({capture.photo("000"), capture.scratch / "copy.jpg"});
  // By path the copy comes first or last; one of both is left out
  const bool copy_first = row("copy").accepted;
  EXPECT_THAT(row(copy_first ? "000" : "copy").reason, HasSubstr("is a copy of"));
  EXPECT_THAT(row(copy_first ? "copy" : "000").reason, HasSubstr("no focal length in EXIF"));
  EXPECT_EQ(row(copy_first ? "copy" : "000").word, "usable, with a guess");
}

TEST_F(PhotosStep, MixedSizesAreRemarkedOn) {
  ASSERT_TRUE(write_photo(capture.scratch / "wide.jpg", {.width = 64, .height = 48}));
  drop({capture.photo("000"), capture.scratch / "wide.jpg"});
  EXPECT_THAT(state().shelf.remarks, Contains(HasSubstr("1 of 64 x 48, 1 of 96 x 128")));
}

TEST_F(PhotosStep, UnchangedFilesAreNotReadAgain) {
  drop({capture.photos()});
  const std::uint64_t first = shelved(workspace(), capture.photo("000"))->revision;
  hand.click("undo");
  hand.click("redo");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(shelved(workspace(), capture.photo("000"))->revision, first);
  fs::resize_file(capture.photo("000"), fs::file_size(capture.photo("000")) + 1);
  hand.click("photos/look_again");
  ASSERT_TRUE(hand.settle());
  EXPECT_GT(shelved(workspace(), capture.photo("000"))->revision, first);
  EXPECT_EQ(shelved(workspace(), capture.photo("001"))->stamp, *stamp_of(capture.photo("001")));
}

TEST_F(PhotosStep, AProjectOpenedAgainShowsItsPhotosWithoutReadingThem) {
  const fs::path broken = write_broken_photo(capture.photos() / "broken.jpg");
  drop({capture.photos()});
  const PhotoRow before = row("003"), broken_before = row("broken");
  const Image<glm::u8vec4> thumbnail = *shelved(workspace(), capture.photo("003"))->thumbnail;
  // Were they read again, this would show: the same stamps on files that are no photos any more
  for (const PhotoRow& each : state().shelf.rows) {
    const FileStamp stamp = *stamp_of(each.file);
    std::ofstream(each.file) << std::string(stamp.bytes, 'x');
    fs::last_write_time(each.file, stamp.changed);
  }
  close_project(workspace());
  open_project(workspace(), capture.scratch / "oak");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(row("003").reason, before.reason);
  EXPECT_EQ(row("broken").reason, broken_before.reason);
  EXPECT_EQ(*shelved(workspace(), capture.photo("003"))->thumbnail, thumbnail);
}

TEST_F(PhotosStep, BrokenFilesAreNotReadAgainByOtherEdits) {
  drop({capture.photo("000"), write_broken_photo(capture.scratch / "broken.jpg")});
  const std::uint64_t first = shelved(workspace(), capture.scratch / "broken.jpg")->revision;
  edit(workspace(), option_edit(workspace().project(), "opacity.cell_px", "2.5"));
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(shelved(workspace(), capture.scratch / "broken.jpg")->revision, first);
}

TEST_F(PhotosStep, ChosenPhotosAreRemovedInOneEdit) {
  drop({capture.photos()});
  EXPECT_FALSE(hand.is_enabled("photos/remove"));
  hand.click("photos/choose/000");
  hand.click("photos/choose/002");
  hand.click("photos/remove");
  EXPECT_EQ(photo_count(), 8u);
  EXPECT_TRUE(fs::exists(capture.photo("000")));
  hand.click("undo");
  EXPECT_EQ(photo_count(), 10u);
}

TEST_F(PhotosStep, PhotosLeftOutAreChosenTogetherAndRemovedByKey) {
  drop({capture.photo("000"), write_broken_photo(capture.scratch / "broken.jpg")});
  hand.click("photos/choose_left_out");
  hand.key(kKeyDelete);
  EXPECT_EQ(photo_count(), 1u);
  EXPECT_TRUE(row("000").accepted);
}

TEST_F(PhotosStep, MovedPhotosAreFoundByOneOfThem) {
  drop({capture.photos()});
  fs::rename(capture.photos(), capture.scratch / "moved");
  hand.click("photos/look_again");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(row("004").word, "missing");
  hand.click("photos/moved");
  hand.type((capture.scratch / "moved" / "004.jpg").string());
  hand.click("photos/find");
  ASSERT_TRUE(hand.settle());
  expect_said("Found 10 photos again");
  EXPECT_TRUE(row("007").accepted);
  EXPECT_FALSE(hand.sees("photos/moved"));
}

TEST_F(PhotosStep, AClickShowsAPhotoLargeAndKeysLeadOn) {
  drop({capture.photos()});
  hand.click("photos/tile/001");
  ASSERT_TRUE(hand.settle());
  EXPECT_TRUE(hand.sees("photos/view"));
  ASSERT_TRUE(state().large.picture);
  EXPECT_EQ(state().large.picture->height(), 128);
  hand.move_to(hand.at("photos/view").middle());
  hand.wheel(3.0f);
  EXPECT_GT(state().view.zoom, 1.0);
  hand.key(kKeyRight);
  EXPECT_EQ(state().shown.stem(), "002");
  hand.key(kKeyLeft);
  EXPECT_EQ(state().shown.stem(), "001");
  hand.key(kKeyEscape);
  EXPECT_TRUE(hand.sees("photos/tile/001"));
}

TEST_F(PhotosStep, PhotosAreShownUpright) {
  PhotoFile lying{.width = 64, .height = 48};
  lying.attributes.attribute("Orientation", 6);
  ASSERT_TRUE(write_photo(capture.scratch / "lying.jpg", lying));
  drop({capture.scratch / "lying.jpg"});
  const ShelvedPhoto* photo = shelved(workspace(), capture.scratch / "lying.jpg");
  ASSERT_TRUE(photo && photo->thumbnail);
  EXPECT_EQ(photo->thumbnail->width(), 48);
  EXPECT_EQ(photo->thumbnail->height(), 64);
  EXPECT_EQ(photo->facts.decoded.width_px, 64);
}

TEST_F(PhotosStep, TheWheelNamesAndOpensPhotosOnceThereAreCameras) {
  drop({capture.photos()});
  EXPECT_FALSE(hand.sees("photos/wheel"));
  drop({capture.cameras()});
  EXPECT_EQ(workspace().step, WorkStep::calibrate);
  hand.click("step/photos");
  hand.frame(2);
  hand.move_to(hand.at("photos/spoke/003").middle());
  EXPECT_EQ(state().pointed_at, "003");
  hand.click("photos/spoke/003");
  EXPECT_EQ(state().shown.stem(), "003");
}

TEST_F(PhotosStep, APhotoWithoutItsCameraSaysSo) {
  fs::copy_file(capture.photo("000"), capture.scratch / "stray.jpg");
  fs::resize_file(capture.scratch / "stray.jpg", fs::file_size(capture.photo("000")) + 1);
  drop({capture.photos(), capture.scratch / "stray.jpg"});
  drop({capture.cameras()});
  EXPECT_THAT(row("stray").reason, HasSubstr("no camera has its name"));
  EXPECT_EQ(row("000").word, "usable");
}

TEST_F(PhotosStep, ReadingThatWasStoppedGoesOnOnlyWhenAsked) {
  hand.drop({capture.photos()});
  workspace().jobs.cancel_all();
  ASSERT_TRUE(hand.settle());
  EXPECT_TRUE(state().shelf.stopped);
  EXPECT_EQ(row("009").word, "not read");
  hand.click("photos/look_again");
  ASSERT_TRUE(hand.settle());
  EXPECT_TRUE(row("009").accepted);
}

TEST_F(PhotosStep, ReadingGoesOnWhereAJobEndsBetweenTwoFrames) {
  hand.drop({capture.photos()});
  while (workspace().jobs.busy(Lane::interactive)) std::this_thread::yield();
  follow_photos(workspace());  // before its result could be collected
  EXPECT_FALSE(state().shelf.stopped);
  ASSERT_TRUE(hand.settle());
  EXPECT_FALSE(state().shelf.stopped);
  EXPECT_TRUE(row("009").accepted);
}

TEST_F(PhotosStep, ADroppedProjectIsOpened) {
  const fs::path elm = capture.scratch / "elm";
  Project project;
  project.folder = elm;
  fs::create_directories(elm);
  save_project(project);
  drop({elm, capture.photo("000")});
  EXPECT_EQ(workspace().project().name(), "elm");
  EXPECT_EQ(photo_count(), 0u);
  expect_said("Opened elm");
}

}  // namespace
}  // namespace bosk
