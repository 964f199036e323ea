#include "core/project/project.h"

#include <algorithm>
#include <string>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/project/journal.h"
#include "core/project/project_json.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

// Strokes take about 17 bytes a point
constexpr std::uint64_t kMaxFileBytes = std::uint64_t(128) << 20;

fs::path project_file(const fs::path& folder) { return folder / "project.json"; }

}  // namespace

fs::path Project::absolute(const fs::path& path) const {
  // Without resolving "..", as the system would: FOLDER/../photos needs no FOLDER then
  return (fs::weakly_canonical(fs::absolute(folder)) / path).lexically_normal();
}

fs::path Project::relative(const fs::path& path) const {
  if (path.empty()) return path;
  const fs::path place = fs::weakly_canonical(fs::absolute(path));
  return place.lexically_relative(fs::weakly_canonical(fs::absolute(folder)));
}

std::string Project::name() const {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  const fs::path last = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
  return last.empty() ? "tree" : last.string();
}

bool holds_project(const fs::path& folder) {
  std::error_code none;
  return fs::exists(project_file(folder), none);
}

void require_project(const fs::path& folder) {
  const auto refuse = [&](const std::string& why) {
    throw Error(printable(folder.string()) + ": " + why);
  };
  std::error_code none;
  if (!fs::exists(folder, none)) {
    refuse("there is no such folder; make a project with `bosk new`");
  }
  if (!holds_project(folder)) {
    refuse("holds no project (project.json is missing); make one with `bosk new`");
  }
}

Project read_saved_project(const fs::path& folder) {
  require_project(folder);
  const fs::path file = project_file(folder);
  Project project = project_of_text(read_file(file, kMaxFileBytes), file);
  project.folder = folder;
  return project;
}

Project read_project(const fs::path& folder) {
  Project project = read_saved_project(folder);
  catch_up(project);
  return project;
}

void save_project(const Project& project) {
  const fs::path file = project_file(project.folder);
  const std::string text = project_text(project);
  if (text.size() > kMaxFileBytes) {
    throw Error(printable(file.string()) + ": would be larger than the " +
                std::to_string(kMaxFileBytes >> 20) +
                " MiB that Bosk reads; clear some of the strokes");
  }
  if (holds_project(project.folder)) {
    const auto old = read_file(file, kMaxFileBytes);
    const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
    if (std::equal(old.begin(), old.end(), bytes.begin(), bytes.end())) return;
  }
  write_file_atomically(file, text);
}

}  // namespace bosk
