#include "ui/workstation/photos/large_photo.h"

#include "core/image/orientation.h"
#include "ui/workstation/photos/decoder_pool.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

void install(LargePhoto& large, const fs::path& file, Image<glm::u8vec4> picture) {
  if (large.file != file) return;  // another photo was asked for meanwhile
  large.picture = std::make_shared<const Image<glm::u8vec4>>(std::move(picture));
  ++large.revision;
}

}  // namespace

void follow_large(Workspace& workspace, LargePhoto& large, const PhotoRow& row,
                  const std::string& key) {
  const ShelvedPhoto* photo = shelved(workspace, row.file);
  if (!photo || (large.file == row.file && large.stamp == photo->stamp)) return;
  large.file = row.file;
  large.stamp = photo->stamp;
  large.picture = nullptr;
  workspace.jobs.start(
      "Opening " + row.name,
      [decoders = workspace.photos.shelf.decoders, file = row.file,
       limits = decode_limits(workspace.project().recipe.photo)](Progress& progress) {
        progress.begin("decoding", 1);
        return large_photo(*decoders, file, limits, progress);
      },
      [&large, file = row.file](Image<glm::u8vec4> picture) {
        install(large, file, std::move(picture));
      },
      Lane::interactive, key);
}

Texture best_picture(Workspace& workspace, const LargePhoto& large, const PhotoRow& row,
                     const std::string& name) {
  if (large.file != row.file || !large.picture) return thumbnail_of(workspace, row.file);
  return workspace.pictures.show(name, large.revision, [&] { return *large.picture; });
}

void ask_again(LargePhoto& large) {
  if (!large.picture) large.file.clear();
}

glm::dvec2 upright_size_of(const PhotoFacts& facts) {
  return upright_size({facts.decoded.width_px, facts.decoded.height_px},
                      facts.decoded.metadata.orientation);
}

}  // namespace bosk
