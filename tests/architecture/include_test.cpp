// Holds the source tree to the directions that its layout promises.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace bosk {
namespace {

namespace fs = std::filesystem;

// A folder of core/ may include itself and those before it.
const std::vector<std::string> kFolders = {
    "base",     "geometry",  "image",    "photo",   "phantom", "calibrate", "matte",  "opacity",
    "radiance", "billboard", "compress", "package", "render",  "measure",   "project"};

struct Include {
  std::string file;  // relative to the source tree
  int line = 0;
  std::string target;   // as written
  bool is_own = false;  // quoted: a file of this tree
};

std::string place(const Include& include) {
  return include.file + ":" + std::to_string(include.line) + " includes " + include.target;
}

std::vector<Include> includes_of(const fs::path& path) {
  static const std::regex pattern(R"rx(^\s*#\s*include\s*(["<])([^">]+)[">])rx");
  std::vector<Include> includes;
  std::ifstream file(path);
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    std::smatch match;
    if (!std::regex_search(line, match, pattern)) continue;
    const std::string relative = fs::relative(path, BOSK_SOURCE_FOLDER).generic_string();
    includes.push_back({relative, number, match[2], match[1] == "\""});
  }
  return includes;
}

bool is_source(const fs::path& path) {
  return path.extension() == ".h" || path.extension() == ".cpp";
}

std::vector<fs::path> sources_below(const std::string& folder) {
  std::vector<fs::path> sources;
  const fs::path root = fs::path(BOSK_SOURCE_FOLDER) / folder;
  if (!fs::exists(root)) return sources;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (is_source(entry.path())) sources.push_back(entry.path());
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

std::vector<Include> includes_below(const std::string& folder) {
  std::vector<Include> all;
  for (const fs::path& source : sources_below(folder)) {
    for (Include& include : includes_of(source)) all.push_back(std::move(include));
  }
  return all;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

// "core/base/error.h" -> 0; anything not in core/FOLDER/ -> -1.
int rank_of(const std::string& path) {
  for (std::size_t i = 0; i < kFolders.size(); ++i) {
    if (starts_with(path, "core/" + kFolders[i] + "/")) return int(i);
  }
  return -1;
}

TEST(Architecture, TestSeesTheSources) { EXPECT_GT(sources_below("core").size(), 50u); }

TEST(Architecture, CoreFoldersIncludeOnlyFoldersAboveThem) {
  for (const Include& include : includes_below("core")) {
    if (!include.is_own) continue;
    const int own = rank_of(include.file), other = rank_of(include.target);
    EXPECT_GE(own, 0) << include.file << " lies in no listed folder of core/";
    EXPECT_GE(other, 0) << place(include) << ", which is no folder of core/";
    EXPECT_LE(other, own) << place(include);
  }
}

TEST(Architecture, CoreKnowsNoWindowAndNoGraphicsLibraryOutsideRenderGl) {
  static const std::regex window(R"rx(imgui|glfw|^GL/|^GLES|^EGL/|^SDL|OpenGL)rx",
                                 std::regex::icase);
  for (const Include& include : includes_below("core")) {
    if (starts_with(include.file, "core/render/gl/")) continue;
    EXPECT_FALSE(std::regex_search(include.target, window)) << place(include);
  }
}

TEST(Architecture, TheWindowIsTheUisAlone) {
  static const std::regex window(R"rx(imgui|glfw|^GL/|^EGL/)rx", std::regex::icase);
  for (const Include& include : includes_below("app")) {
    EXPECT_FALSE(std::regex_search(include.target, window)) << place(include);
  }
}

TEST(Architecture, PanelsKnowNeitherWindowSystemNorOpenGl) {
  static const std::regex window(R"rx(glfw|^GL/|^EGL/|OpenGL|^backends/)rx", std::regex::icase);
  for (const std::string folder : {"ui/workstation", "ui/widgets"}) {
    for (const Include& include : includes_below(folder)) {
      EXPECT_FALSE(std::regex_search(include.target, window)) << place(include);
    }
  }
}

TEST(Architecture, TheWorkstationDoesNotIncludeTheProgram) {
  for (const Include& include : includes_below("ui")) {
    EXPECT_FALSE(starts_with(include.target, "app/")) << place(include);
  }
}

TEST(Architecture, NothingIncludesTests) {
  for (const std::string folder : {"core", "app", "ui"}) {
    for (const Include& include : includes_below(folder)) {
      EXPECT_FALSE(starts_with(include.target, "tests/")) << place(include);
    }
  }
}

// Follows our own includes from what a game links, sources of included headers too.
std::set<fs::path> runtime_files() {
  std::set<fs::path> files;
  std::vector<fs::path> open = {"core/package/tree_model.h", "core/package/reader.h",
                                "core/render/draw_list.h", "core/render/forest.h"};
  while (!open.empty()) {
    const fs::path file = open.back();
    open.pop_back();
    const fs::path whole = fs::path(BOSK_SOURCE_FOLDER) / file;
    if (!fs::exists(whole) || !files.insert(file).second) continue;
    if (file.extension() == ".h") open.push_back(fs::path(file).replace_extension(".cpp"));
    for (const Include& include : includes_of(whole)) {
      if (include.is_own) open.push_back(include.target);
    }
  }
  return files;
}

TEST(Architecture, TheRuntimeStandsOnTheStandardLibraryGlmZstdAndXxhashAlone) {
  static const std::regex allowed(R"rx(^(glm/.*|zstd\.h|xxhash\.h|[a-z_]+)$)rx");
  const auto files = runtime_files();
  EXPECT_GE(files.size(), 4u);
  for (const fs::path& file : files) {
    for (const Include& include : includes_of(fs::path(BOSK_SOURCE_FOLDER) / file)) {
      if (include.is_own) continue;
      EXPECT_TRUE(std::regex_match(include.target, allowed)) << place(include);
    }
  }
}

TEST(Architecture, NoSourceFileIsLongerThan600Lines) {
  for (const std::string folder : {"core", "app", "ui", "tests"}) {
    for (const fs::path& source : sources_below(folder)) {
      std::ifstream file(source);
      const auto lines = std::count(std::istreambuf_iterator<char>(file), {}, '\n');
      EXPECT_LE(lines, 600) << source;
    }
  }
}

}  // namespace
}  // namespace bosk
