#include "ui/workstation/photos/photo_shelf.h"

#include <algorithm>

#include "ui/workstation/calibrate/known_cameras.h"
#include "ui/workstation/photos/decoder_pool.h"
#include "ui/workstation/photos/photo_look.h"
#include "ui/workstation/photos/photo_words.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

void install(PhotoShelf& shelf, Look look) {
  shelf.job = {};
  shelf.missing = std::move(look.missing);
  shelf.to_read = look.left;
  shelf.look_wanted = look.left > 0;
  ++shelf.revision;
  for (auto& [file, photo] : look.read) {
    photo.revision = shelf.revision;
    shelf.photos[file] = std::move(photo);
  }
}

// Where the limits changed, photos that they may concern are looked at anew; whether they did.
bool follow_limits(PhotoShelf& shelf, const PhotoOptions& options) {
  const std::array<double, 3> limits{options.max_megapixels, options.memory_gib, options.seconds};
  if (limits == shelf.limits) return false;
  shelf.limits = limits;
  std::erase_if(shelf.photos, [&](const auto& entry) {
    const DecodedPhoto& photo = entry.second.facts.decoded;
    const double megapixels = 1e-6 * photo.width_px * photo.height_px;
    return !entry.second.facts.trouble.empty() || megapixels > options.max_megapixels;
  });
  return true;
}

void start_look(Workspace& workspace) {
  PhotoShelf& shelf = workspace.photos.shelf;
  const Project& project = workspace.project();
  LookRequest request;
  for (const fs::path& photo : project.photos) {
    request.photos.push_back({photo, project.absolute(photo)});
  }
  request.decoders = shelf.decoders;
  request.options = project.recipe.photo;
  request.cache_folder = project.cache_folder();
  for (const auto& [file, photo] : shelf.photos) request.known[file] = photo.stamp;
  shelf.look_wanted = false;
  shelf.job.id = workspace.jobs.start(
      "Reading photos",
      [request = std::move(request)](Progress& progress) {
        return look_through(request, progress);
      },
      [&workspace, folder = project.folder](Look look) {
        const bool same = workspace.session && workspace.project().folder == folder;
        if (same) install(workspace.photos.shelf, std::move(look));
      },
      Lane::interactive, "photos");
}

PhotoRow unread_row(const PhotoShelf& shelf, PhotoRow row) {
  if (shelf.missing.contains(row.file)) {
    row.tone = Tone::bad;
    row.word = "missing";
    row.reason = "there is no file any more at " + row.file.string();
  } else {
    row.tone = shelf.stopped ? Tone::muted : Tone::busy;
    row.word = shelf.stopped ? "not read" : "waits";
    row.reason = shelf.stopped ? "reading was stopped; press Look again" : "to be read";
  }
  return row;
}

bool is_read(const PhotoShelf& shelf, const fs::path& file) {
  return shelf.photos.contains(file) && !shelf.missing.contains(file);
}

void judge(Workspace& workspace) {
  PhotoShelf& shelf = workspace.photos.shelf;
  const std::vector<Camera>& cameras = known_cameras_of(workspace);
  std::vector<PhotoFacts> read;
  for (const PhotoRow& row : shelf.rows) {
    if (is_read(shelf, row.file)) read.push_back(shelf.photos.at(row.file).facts);
  }
  const auto verdicts = photo_verdicts(read, cameras, workspace.project().recipe.photo);
  std::vector<const PhotoFacts*> accepted;
  std::size_t next = 0;
  for (PhotoRow& row : shelf.rows) {
    if (!is_read(shelf, row.file)) {
      row = unread_row(shelf, std::move(row));
      continue;
    }
    const PhotoVerdict& verdict = verdicts[next];
    const VerdictWord word = word_of(verdict, read[next], !cameras.empty());
    row.tone = word.tone;
    row.word = word.word;
    row.reason = verdict.reason;
    row.accepted = verdict.accepted;
    if (verdict.accepted) accepted.push_back(&read[next]);
    ++next;
  }
  shelf.remarks = set_remarks(accepted);
}

void refresh_rows(Workspace& workspace) {
  PhotoShelf& shelf = workspace.photos.shelf;
  const std::uint64_t project = workspace.session->revision() + 1;
  const std::uint64_t cameras = known_cameras_revision(workspace);
  if (shelf.rows_revision == shelf.revision && shelf.rows_project == project &&
      shelf.rows_cameras == cameras) {
    return;
  }
  shelf.rows_revision = shelf.revision;
  shelf.rows_project = project;
  shelf.rows_cameras = cameras;
  shelf.rows.clear();
  for (const fs::path& photo : workspace.project().photos) {
    PhotoRow row;
    row.photo = photo;
    row.file = workspace.project().absolute(photo);
    row.name = photo.stem().string();
    shelf.rows.push_back(std::move(row));
  }
  judge(workspace);
}

}  // namespace

PhotoShelf::PhotoShelf() : decoders(std::make_shared<DecoderPool>()) {}

std::optional<FileStamp> stamp_of(const fs::path& file) {
  std::error_code failure;
  if (!fs::is_regular_file(file, failure)) return std::nullopt;
  FileStamp stamp;
  stamp.bytes = fs::file_size(file, failure);
  if (failure) return std::nullopt;
  stamp.changed = fs::last_write_time(file, failure);
  if (failure) return std::nullopt;
  return stamp;
}

void follow_photos(Workspace& workspace) {
  PhotoShelf& shelf = workspace.photos.shelf;
  follow_cameras(workspace);
  // A look that ended without a result was stopped: going on would defy whoever did so
  if (was_stopped(shelf.job, workspace.jobs)) {
    shelf.stopped = true;
    ++shelf.revision;
  }
  const Project& project = workspace.project();
  if (!shelf.job.is_at_work()) {
    const bool other_limits = follow_limits(shelf, project.recipe.photo);
    if (other_limits || shelf.looked_photos != project.photos) shelf.look_wanted = true;
    shelf.looked_photos = project.photos;
  }
  if (shelf.look_wanted && !shelf.stopped && !shelf.job.is_at_work() && !project.photos.empty()) {
    start_look(workspace);
  }
  refresh_rows(workspace);
}

void look_again(Workspace& workspace) {
  workspace.photos.shelf.stopped = false;
  workspace.photos.shelf.look_wanted = true;
}

const ShelvedPhoto* shelved(const Workspace& workspace, const fs::path& file) {
  const auto& photos = workspace.photos.shelf.photos;
  const auto place = photos.find(file);
  return place == photos.end() ? nullptr : &place->second;
}

const PhotoRow* row_of(const Workspace& workspace, const std::string& name) {
  const auto& rows = workspace.photos.shelf.rows;
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const PhotoRow& other) { return other.name == name; });
  return row == rows.end() ? nullptr : &*row;
}

Texture thumbnail_of(Workspace& workspace, const fs::path& file) {
  const ShelvedPhoto* photo = shelved(workspace, file);
  if (!photo || !photo->thumbnail) return {};
  return workspace.pictures.show("thumbnail/" + file.string(), photo->revision,
                                 [&] { return *photo->thumbnail; });
}

int orientation_of(const Workspace& workspace, const std::string& name) {
  const PhotoRow* row = row_of(workspace, name);
  const ShelvedPhoto* photo = row ? shelved(workspace, row->file) : nullptr;
  return photo ? photo->facts.decoded.metadata.orientation : 1;
}

Image<glm::u8vec4> large_photo(DecoderPool& decoders, const fs::path& file,
                               const DecodeLimits& limits, const Progress& progress) {
  return decoders.with_decoder(limits, [&](PhotoDecoder& decoder) {
    return shown_photo(decoder.decode(file, progress), kLargePhotoPx);
  });
}

}  // namespace bosk
