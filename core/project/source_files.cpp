#include "core/project/source_files.h"

#include <tbb/parallel_for.h>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/system_error.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kMaxSourceBytes = std::uint64_t(4) << 30;

}  // namespace

void add_file(FilesByName& files, const fs::path& path) {
  const std::string name = path.stem().string();
  const auto [place, is_new] = files.emplace(name, path);
  if (!is_new) {
    throw Error(printable(place->second.string()) + " and " + printable(path.string()) +
                ": files are matched by name without ending, and these have the same; rename one");
  }
}

FilesByName files_in(const fs::path& folder) {
  std::error_code failure;
  FilesByName files;
  for (const auto& entry : fs::directory_iterator(folder, failure)) {
    const bool hidden = entry.path().filename().string().rfind('.', 0) == 0;
    if (!hidden && entry.is_regular_file()) add_file(files, entry.path());
  }
  if (failure) throw system_error(folder, "read", failure.value());
  return files;
}

FilesByName photo_files(const Project& project) {
  FilesByName files;
  for (const fs::path& photo : project.photos) add_file(files, project.absolute(photo));
  return files;
}

void hash_content(std::vector<SourceFile>& files) {
  tbb::parallel_for(std::size_t(0), files.size(), [&](std::size_t i) {
    files[i].content = content_hash(read_file(files[i].path, kMaxSourceBytes));
  });
}

std::vector<SourceFile> source_files(const FilesByName& files) {
  std::vector<SourceFile> sources;
  for (const auto& [name, path] : files) sources.push_back({name, path, {}});
  hash_content(sources);
  return sources;
}

void hash_files(ContentHasher& hasher, const std::vector<SourceFile>& files) {
  hasher.value(std::uint64_t(files.size()));
  for (const SourceFile& file : files) {
    hasher.text(file.name).value(file.content.high).value(file.content.low);
  }
}

}  // namespace bosk
