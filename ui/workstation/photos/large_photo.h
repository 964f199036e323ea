#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "ui/workstation/photos/photo_shelf.h"

namespace bosk {

// A photo shown large, as it comes from a job.
struct LargePhoto {
  std::filesystem::path file;
  FileStamp stamp;
  std::shared_ptr<const Image<glm::u8vec4>> picture;  // upright; null until it is there
  std::uint64_t revision = 0;
};

// Asks for the photo in full, once for each state of its file; `key` is the job's. `large` must be
// a part of the workspace.
void follow_large(Workspace& workspace, LargePhoto& large, const PhotoRow& row,
                  const std::string& key);
// The full photo where it is there, else its thumbnail.
Texture best_picture(Workspace& workspace, const LargePhoto& large, const PhotoRow& row,
                     const std::string& name);
// One that was stopped on its way is asked for again.
void ask_again(LargePhoto& large);

// Of the upright photo, in pixels as delivered.
glm::dvec2 upright_size_of(const PhotoFacts& facts);

}  // namespace bosk
