#include "ui/workstation/photos/photo_edits.h"

#include <algorithm>

#include "core/base/system_error.h"
#include "core/project/relink.h"
#include "ui/workstation/photos/photo_words.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace fs = std::filesystem;

void add_photos(Workspace& workspace, const std::vector<fs::path>& files) {
  const Project& project = workspace.project();
  std::set<fs::path> present;
  for (const fs::path& photo : project.photos) present.insert(project.absolute(photo));
  std::vector<fs::path> after = project.photos;
  for (const fs::path& file : files) {
    const fs::path photo = project.relative(file);
    if (present.insert(project.absolute(photo)).second) after.push_back(photo);
  }
  const std::size_t added = after.size() - project.photos.size();
  Notices& said = workspace.photos.said;
  if (added < files.size()) {
    said.push_back({Tone::neutral, count_of(files.size() - added, "photo") +
                                       " of these: already in the project."});
  }
  if (added == 0) return;
  std::sort(after.begin(), after.end());
  if (done_or_told(said, [&] { edit(workspace, photos_edit(project, after)); })) {
    said.push_back({Tone::good, "Added " + count_of(added, "photo") + "."});
  }
}

void remove_photos(Workspace& workspace, const std::set<fs::path>& photos) {
  const Project& project = workspace.project();
  std::vector<fs::path> after = project.photos;
  const std::size_t removed =
      std::erase_if(after, [&](const fs::path& photo) { return photos.contains(photo); });
  if (removed == 0) return;
  Notices& said = workspace.photos.said;
  said.clear();
  if (done_or_told(said, [&] { edit(workspace, photos_edit(project, after)); })) {
    said.push_back({Tone::good, "Removed " + count_of(removed, "photo") +
                                    " from the project; the files stay where they are."});
  }
}

void find_moved_photos(Workspace& workspace, const fs::path& found) {
  Notices& said = workspace.photos.said;
  said.clear();
  done_or_told(said, [&] {
    const Relinking relinking = relink_photos(workspace.project(), found);
    edit(workspace, relinking.edit);
    said.push_back({Tone::good, "Found " + count_of(relinking.found, "photo") + " again."});
    if (!relinking.still_missing.empty()) {
      said.push_back({Tone::note, count_of(relinking.still_missing.size(), "photo") +
                                      " still missing, such as " +
                                      printable(relinking.still_missing.front().string()) + "."});
    }
  });
}

}  // namespace bosk
