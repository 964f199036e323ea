#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/content_hash.h"
#include "core/project/project.h"

namespace bosk {

// One file that a run starts from. `name` is the file's without folder and ending.
struct SourceFile {
  std::string name;
  std::filesystem::path path;
  ContentHash content;
};

// Files by name without folder and ending, as they are matched. Throws Error when two have the
// same.
using FilesByName = std::map<std::string, std::filesystem::path>;
void add_file(FilesByName& files, const std::filesystem::path& path);
// The folder's regular files; hidden ones aside. Throws Error where it can't be read.
FilesByName files_in(const std::filesystem::path& folder);
// The project's photos, wherever they are.
FilesByName photo_files(const Project& project);

// Reads each file to fill in its hash. Throws Error where one can't be read.
void hash_content(std::vector<SourceFile>& files);
// By name, hashed.
std::vector<SourceFile> source_files(const FilesByName& files);

void hash_files(ContentHasher& hasher, const std::vector<SourceFile>& files);

}  // namespace bosk
