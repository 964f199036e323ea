// score_folders views|mattes RENDERED_DIR TRUTH_DIR: scores the PNGs of the same name and prints
// every measure with four decimals. For compare_scores.py.

#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/measure/matte_quality.h"
#include "core/measure/score_table.h"

namespace {

namespace fs = std::filesystem;

template <class Channel>
bosk::Image<glm::vec<4, Channel>> load(const fs::path& path, OIIO::TypeDesc type) {
  const OIIO::ImageSpec as_it_is = [] {
    OIIO::ImageSpec spec;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
  }();
  const auto input = OIIO::ImageInput::open(path.string(), &as_it_is);
  if (!input || input->spec().nchannels != 4) throw bosk::Error(path.string() + ": no RGBA image");
  bosk::Image<glm::vec<4, Channel>> image(input->spec().width, input->spec().height);
  input->read_image(0, 0, 0, 4, type, image.data());
  return image;
}

void score_views(const std::set<fs::path>& names, const fs::path& rendered, const fs::path& truth) {
  std::vector<bosk::NamedScore> scores;
  for (const fs::path& name : names) {
    scores.push_back(
        {name.string(), bosk::score_view(load<std::uint8_t>(rendered / name, OIIO::TypeDesc::UINT8),
                                         load<std::uint8_t>(truth / name, OIIO::TypeDesc::UINT8))});
  }
  std::fputs(bosk::table_text(bosk::tabulate(scores)).c_str(), stdout);
}

void score_mattes(const std::set<fs::path>& names, const fs::path& mattes, const fs::path& truth) {
  for (const fs::path& name : names) {
    const bosk::MatteScore score =
        bosk::score_matte(load<double>(mattes / name, OIIO::TypeDesc::DOUBLE),
                          load<double>(truth / name, OIIO::TypeDesc::DOUBLE));
    std::printf("%s", name.c_str());
    for (const auto& field : bosk::kMatteScoreFields) std::printf(" %.4f", score.*field.value);
    std::printf("\n");
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  try {
    std::set<fs::path> names;
    for (const auto& entry : fs::directory_iterator(arguments[2]))
      names.insert(entry.path().filename());
    const bool views = std::string(arguments[1]) == "views";
    (views ? score_views : score_mattes)(names, arguments[2], arguments[3]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
