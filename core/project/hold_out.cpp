#include "core/project/hold_out.h"

#include <algorithm>

#include "core/base/error.h"

namespace bosk {
namespace {

bool has_strokes(const Capture& capture, const std::string& name) {
  const auto& files = capture.scribbles;
  return capture.mattes.empty() &&
         (capture.strokes.count(name) > 0 ||
          std::any_of(files.begin(), files.end(),
                      [&](const SourceFile& file) { return file.name == name; }));
}

}  // namespace

std::set<std::string> held_out_names(const Capture& capture, int every) {
  std::set<std::string> names;
  int count = 0;
  for (const SourceFile& photo : capture.photos) {
    if (has_strokes(capture, photo.name)) continue;
    if (++count % every == 0) names.insert(photo.name);
  }
  if (names.empty() || capture.photos.size() < names.size() + 2) {
    throw Error("holding out every " + std::to_string(every) + "th of " +
                std::to_string(capture.photos.size()) +
                " photos leaves none to judge by or fewer than 2 to work from; choose another "
                "--hold-out");
  }
  return names;
}

Capture with_only(const Capture& capture, const std::set<std::string>& names) {
  Capture chosen = capture;
  for (const SourceFile& photo : capture.photos) {
    if (names.count(photo.name) == 0) chosen.left_out.insert(photo.name);
  }
  return chosen;
}

}  // namespace bosk
