#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bosk {

enum class Fate {
  refused,  // no program could read it, or no photo may be so
  read,     // odd, but a photo
  either,   // depends on how forgiving the packaged decoder is
};

struct DamagedPhoto {
  std::string name;
  Fate fate = Fate::refused;
};

// Makes some sixty odd files in the folder: cut short, lying about their size or their kind, no
// files at all, and photos that are merely unusual. Those that this installation cannot make are
// left out.
std::vector<DamagedPhoto> make_damaged_photos(const std::filesystem::path& folder);

}  // namespace bosk
