#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/matte/matte_doubt.h"
#include "core/project/stages.h"

namespace bosk {

struct Workspace;

// A photo and its matte, small, as delivered: for lists and the contact sheet.
struct SmallPhoto {
  std::string name;
  Image<glm::vec3> srgb;
  Image<glm::vec4> matte;  // empty while there is none
};
inline constexpr int kSmallPhotoPx = 320;  // longer side

// What is known of all photos together, from their newest full mattes.
struct MatteReview {
  std::shared_ptr<const ImportedPhotos> imported;  // that it is of
  std::shared_ptr<const Mattes> mattes;
  std::vector<SmallPhoto> photos;             // in the order of the import
  std::map<std::string, MatteDoubt> doubts;   // by photo
  std::map<std::string, Image<float>> tilts;  // what the others say of each (hull.h)
  std::uint64_t revision = 0;
  int job = 0;
};

// Looks through photos and mattes anew where they changed. Once a frame.
void follow_mattes(Workspace& workspace);

const SmallPhoto* small_photo(const MatteReview& review, const std::string& name);
Image<float> what_others_say(const MatteReview& review, const std::string& name);

// Names of photos: those most in doubt first, or as they were imported.
std::vector<std::string> photos_in_order(const MatteReview& review, bool doubt_first);

}  // namespace bosk
