#pragma once

#include <filesystem>

#include "core/base/file_descriptor.h"

namespace bosk {

// Held while stages run, so that two processes never work on one project at once. The system frees
// it when the process ends, however it ends: no stale locks. Where a file system knows no locks, it
// guards nothing.
class ProjectLock {
 public:
  // Throws Error of kind temporary when another process holds it, naming that process.
  explicit ProjectLock(const std::filesystem::path& project_folder);

 private:
  FileDescriptor file_;
};

}  // namespace bosk
