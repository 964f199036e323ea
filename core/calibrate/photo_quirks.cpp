#include "core/calibrate/photo_quirks.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bosk {
namespace {

std::string size_text(int width_px, int height_px) {
  return std::to_string(width_px) + " x " + std::to_string(height_px);
}

using SightingsByPoint = std::map<std::string, const Sighting*>;

SightingsByPoint by_point(const PhotoSightings& photo) {
  SightingsByPoint result;
  for (const Sighting& sighting : photo.sightings) result[sighting.point] = &sighting;
  return result;
}

// Whether `copy` repeats the sightings of a photo with less than half of their noise. The first few
// dozen tell.
bool is_copy(const SightingsByPoint& photo, const PhotoSightings& copy) {
  constexpr std::size_t kTelling = 40;
  const std::size_t asked = std::min(copy.sightings.size(), kTelling);
  double sum = 0.0;
  std::size_t common = 0;
  for (std::size_t i = 0; i < asked; ++i) {
    const Sighting& sighting = copy.sightings[i];
    const auto other = photo.find(sighting.point);
    if (other == photo.end()) continue;
    const glm::dvec2 apart = (sighting.pixel - other->second->pixel) / sighting.sigma_px;
    sum += glm::dot(apart, apart);
    ++common;
  }
  const bool as_many = 5 * copy.sightings.size() >= 4 * photo.size();
  return as_many && common >= 4 && 5 * common >= 4 * asked && sum < 2.0 * 0.25 * double(common);
}

// Distance in sigmas of the points from the line through a and b that half of them keep within.
double usual_miss(const std::vector<Sighting>& sightings, const Sighting& a, const Sighting& b) {
  const glm::dvec2 along = b.pixel - a.pixel;
  const double length = glm::length(along);
  if (length < 1e-9) return 0.0;
  std::vector<double> misses;
  for (const Sighting& sighting : sightings) {
    const glm::dvec2 off = sighting.pixel - a.pixel;
    misses.push_back(std::abs(along.x * off.y - along.y * off.x) / length / sighting.sigma_px);
  }
  const auto most = misses.begin() + long(misses.size() * 4 / 5);
  std::nth_element(misses.begin(), most, misses.end());
  return *most;
}

bool on_a_line(const PhotoSightings& photo) {
  constexpr double kOnLine = 6.0;  // sigmas
  const auto& all = photo.sightings;
  for (std::size_t a = 0; a < std::min<std::size_t>(all.size(), 8); ++a)
    for (std::size_t b = a + 1; b < std::min<std::size_t>(all.size(), 8); ++b)
      if (usual_miss(all, all[a], all[b]) < kOnLine) return true;
  return false;
}

}  // namespace

void refuse_other_sizes(std::span<const PhotoSightings> photos, const Lens& lens,
                        std::vector<std::string>& refused) {
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const PhotoSightings& photo = photos[i];
    if (!refused[i].empty() ||
        (photo.width_px == lens.width_px && photo.height_px == lens.height_px))
      continue;
    const bool turned = photo.width_px == lens.height_px && photo.height_px == lens.width_px;
    refused[i] = "is " + size_text(photo.width_px, photo.height_px) + " and the others' lens " +
                 size_text(lens.width_px, lens.height_px) +
                 (turned ? ": turn the camera the same way for all photos"
                         : ": give the photo as the camera took it, not cropped or scaled");
  }
}

void refuse_copies(std::span<const PhotoSightings> photos, std::vector<std::string>& refused) {
  std::vector<SightingsByPoint> earlier;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    earlier.push_back(by_point(photos[i]));
    for (std::size_t j = 0; j < i && refused[i].empty(); ++j)
      if (refused[j].empty() && is_copy(earlier[j], photos[i]))
        refused[i] = "is a copy of " + photos[j].photo + ", and tells nothing new: leave it out";
  }
}

bool points_on_a_line(std::span<const PhotoSightings> photos,
                      const std::vector<std::string>& refused) {
  int straight = 0, asked = 0;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    if (!refused[i].empty() || photos[i].sightings.size() < 4) continue;
    ++asked;
    straight += on_a_line(photos[i]) ? 1 : 0;
  }
  return asked > 0 && 4 * straight >= 3 * asked;
}

}  // namespace bosk
