#include "core/matte/first_guess.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/image/colour.h"
#include "core/matte/colour_cells.h"
#include "core/matte/hull.h"

namespace bosk {
namespace {

constexpr double kEdge = 0.04;        // of a photo's width or height
constexpr double kFlank = 0.1;        // of its width
constexpr double kMiddle = 0.2;       // half axes of the ellipse about the tree, the same
constexpr double kRare = 6.0;         // times as common in the middle as along the edges
constexpr double kCommon = 1.5;       // the other way: gaps in the crown show such colours
constexpr double kLeastShare = 1e-4;  // of the middle or the edges: fewer pixels say nothing
constexpr double kFewest = 50.0;      // pixels of tree in a photo

// Which parts of a photo a pixel is in.
struct Place {
  bool on_edge = false;
  bool beside = false;  // on the left or right flank, at the heights of the middle
  bool in_middle = false;
};

// Where on the photo the tree's middle is, 0 to 1 across it.
glm::dvec2 middle_of(const Photo& photo, const std::optional<glm::dvec3>& place) {
  const glm::dvec2 size(photo.srgb.width(), photo.srgb.height());
  const auto seen = place ? project(photo.camera, *place) : std::nullopt;
  return seen ? glm::clamp((*seen + 0.5) / size, 0.25, 0.75) : glm::dvec2(0.5);
}

Place place_of(const Photo& photo, const glm::dvec2& middle, int x, int y) {
  const glm::dvec2 size(photo.srgb.width(), photo.srgb.height());
  const glm::dvec2 share = (glm::dvec2(x, y) + 0.5) / size;
  const glm::dvec2 inward = glm::min(share, 1.0 - share);
  const glm::dvec2 off = (share - middle) / kMiddle;
  Place place;
  place.on_edge = std::min(inward.x, inward.y) < kEdge;
  place.beside = inward.x < kFlank && std::abs(off.y) < 1.0;
  place.in_middle = glm::dot(off, off) < 1.0;
  return place;
}

// How often each colour shows in parts of the photos, as shares of the part.
struct Colours {
  std::vector<double> edge = std::vector<double>(kAllColourCells);
  std::vector<double> beside = std::vector<double>(kAllColourCells);
  std::vector<double> middle = std::vector<double>(kAllColourCells);
};

void make_shares(std::vector<double>& counts) {
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  for (double& count : counts) count /= std::max(1.0, all);
}

Colours colours_of(const Photo& photo, const glm::dvec2& middle, const Progress& progress) {
  Colours colours;
  for (int y = 0; y < photo.srgb.height(); ++y) {
    progress.check();
    for (int x = 0; x < photo.srgb.width(); ++x) {
      const Place place = place_of(photo, middle, x, y);
      if (!(place.on_edge || place.beside || place.in_middle)) continue;
      const std::size_t cell = colour_cell(lab_from_srgb(photo.srgb(x, y)));
      colours.edge[cell] += place.on_edge ? 1.0 : 0.0;
      colours.beside[cell] += place.beside ? 1.0 : 0.0;
      colours.middle[cell] += place.in_middle ? 1.0 : 0.0;
    }
  }
  make_shares(colours.edge);
  make_shares(colours.beside);
  make_shares(colours.middle);
  return colours;
}

// Of all photos, each weighing the same.
Colours mean_of(const std::vector<Colours>& all) {
  Colours mean;
  for (const Colours& one : all) {
    for (std::size_t c = 0; c < kAllColourCells; ++c) {
      mean.edge[c] += one.edge[c] / double(all.size());
      mean.beside[c] += one.beside[c] / double(all.size());
      mean.middle[c] += one.middle[c] / double(all.size());
    }
  }
  return mean;
}

enum class Side : std::uint8_t { tree, background, neither };

// What a colour is, by how much commoner it is in the middle than elsewhere, or the other way.
Side side_of(const Colours& colours, std::size_t cell) {
  const double middle = colours.middle[cell];
  const double elsewhere = std::max(colours.edge[cell], colours.beside[cell]);
  if (middle > kLeastShare && middle > kRare * elsewhere) return Side::tree;
  return elsewhere > kCommon * middle ? Side::background : Side::neither;
}

Image<std::uint8_t> strokes_over(const Photo& photo, const glm::dvec2& middle,
                                 const Colours& colours, const Progress& progress) {
  Image<std::uint8_t> strokes(photo.srgb.width(), photo.srgb.height(), kNoStroke);
  double tree = 0.0;
  for (int y = 0; y < photo.srgb.height(); ++y) {
    progress.check();
    for (int x = 0; x < photo.srgb.width(); ++x) {
      const Place place = place_of(photo, middle, x, y);
      if (!(place.on_edge || place.in_middle)) continue;
      const Side side = side_of(colours, colour_cell(lab_from_srgb(photo.srgb(x, y))));
      if (side == Side::tree && place.in_middle) {
        strokes(x, y) = kForegroundStroke;
        tree += 1.0;
      } else if (side == Side::background || (side == Side::neither && place.on_edge)) {
        strokes(x, y) = kBackgroundStroke;
      }
    }
  }
  if (tree >= kFewest) return strokes;
  for (std::uint8_t& value : strokes.pixels()) {
    if (value == kForegroundStroke) value = kNoStroke;
  }
  return strokes;
}

}  // namespace

Scribbles guess_strokes(const Photos& photos, Progress& progress) {
  progress.begin("Guessing where the tree is", 2 * photos.size());
  const auto place = place_seen_by_all(photos);
  std::vector<Colours> each(photos.size());
  tbb::parallel_for(std::size_t(0), photos.size(), [&](std::size_t i) {
    each[i] = colours_of(photos[i], middle_of(photos[i], place), progress);
    progress.advance();
  });
  const Colours colours = mean_of(each);
  std::vector<Image<std::uint8_t>> strokes(photos.size());
  tbb::parallel_for(std::size_t(0), photos.size(), [&](std::size_t i) {
    strokes[i] = strokes_over(photos[i], middle_of(photos[i], place), colours, progress);
    progress.advance();
  });
  Scribbles scribbles;
  bool any = false;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    any = any || has_both_kinds(strokes[i]);
    scribbles[photos[i].name] = std::move(strokes[i]);
  }
  return any ? scribbles : Scribbles();
}

Scribbles guess_where_none(Scribbles drawn, const Photos& photos, Progress& progress) {
  const bool begun = std::any_of(drawn.begin(), drawn.end(),
                                 [](const auto& photo) { return has_both_kinds(photo.second); });
  if (begun) return drawn;
  Scribbles guess = guess_strokes(photos, progress);
  if (guess.empty()) return drawn;
  for (const auto& [name, strokes] : drawn) {
    const auto guessed = guess.find(name);
    if (guessed == guess.end() || guessed->second.size() != strokes.size()) continue;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      const std::uint8_t value = strokes.pixels()[i];
      if (value != kNoStroke) guessed->second.pixels()[i] = value;
    }
  }
  progress.warn(
      "no photo has strokes of both kinds, so the tree was guessed; look through the mattes and "
      "correct them with a few strokes");
  return guess;
}

}  // namespace bosk
