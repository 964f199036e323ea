#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/photo/verdicts.h"
#include "ui/widgets/pictures.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/photos/photo_pictures.h"
#include "ui/workstation/watched_job.h"

namespace bosk {

struct Workspace;
class DecoderPool;

// When and how long a file is: as long as both stay, it isn't read again.
struct FileStamp {
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type changed{};

  bool operator==(const FileStamp&) const = default;
};
std::optional<FileStamp> stamp_of(const std::filesystem::path& file);  // none: there is no such

// A photo that was looked through once.
struct ShelvedPhoto {
  FileStamp stamp;
  PhotoFacts facts;                                     // without pixels
  std::shared_ptr<const Image<glm::u8vec4>> thumbnail;  // upright; null where nothing was decoded
  std::uint64_t revision = 0;                           // of the thumbnail
};

// What is known of the project's photos, and a verdict on each.
struct PhotoRow {
  std::filesystem::path photo, file;  // as the project has it; where it is
  std::string name;
  Tone tone = Tone::muted;
  std::string word, reason;
  bool accepted = false;  // as far as is known
};

struct PhotoShelf {
  PhotoShelf();

  // By place; photos that left the project stay, so that undo needs no second look.
  std::map<std::filesystem::path, ShelvedPhoto> photos;
  std::set<std::filesystem::path> missing;  // places where no file is
  std::vector<PhotoRow> rows;               // in the project's order
  std::vector<std::string> remarks;         // on all photos together
  std::shared_ptr<DecoderPool> decoders;

  std::array<double, 3> limits{};  // of PhotoOptions, that the photos were looked through by
  WatchedJob job;                  // that looks through photos now
  bool look_wanted = true;         // files may have changed
  bool stopped = false;            // by a person, or for want of memory
  std::size_t to_read = 0;         // photos that were not looked through yet
  std::uint64_t revision = 1;      // raised with every change of the above
  std::uint64_t rows_revision = 0, rows_project = 0, rows_cameras = 0;  // that `rows` were made of
  std::vector<std::filesystem::path> looked_photos;  // the project's at the last look
};

// Looks through new and changed photos, a few at a time so that whatever else follows the hand gets
// its turn, and keeps the rows up to date. Once a frame by each step that shows photos.
void follow_photos(Workspace& workspace);
// Looks whether files changed, appeared or went, and goes on where reading was stopped.
void look_again(Workspace& workspace);

const ShelvedPhoto* shelved(const Workspace& workspace, const std::filesystem::path& file);
// By its name; null where it isn't known.
const PhotoRow* row_of(const Workspace& workspace, const std::string& name);
// The thumbnail on the screen's side.
Texture thumbnail_of(Workspace& workspace, const std::filesystem::path& file);
// As EXIF has it; 1 where nothing is known.
int orientation_of(const Workspace& workspace, const std::string& name);

// Decodes for display, at most kLargePhotoPx.
Image<glm::u8vec4> large_photo(DecoderPool& decoders, const std::filesystem::path& file,
                               const DecodeLimits& limits, const Progress& progress);

}  // namespace bosk
