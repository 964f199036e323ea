#include "core/calibrate/feature_tracks.h"

#include <algorithm>
#include <numeric>

namespace bosk {
namespace {

// Disjoint sets of numbers.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
  }
  std::size_t find(std::size_t element) {
    while (parent_[element] != element) element = parent_[element] = parent_[parent_[element]];
    return element;
  }
  void join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

bool shows_a_photo_twice(const FeatureTrack& track) {
  for (std::size_t i = 1; i < track.size(); ++i)
    if (track[i].photo == track[i - 1].photo) return true;
  return false;
}

}  // namespace

std::vector<FeatureTrack> feature_tracks(std::span<const PhotoFeatures> photos,
                                         std::span<const FeatureMatches> matches) {
  std::vector<std::size_t> first_of_photo{0};
  for (const PhotoFeatures& photo : photos)
    first_of_photo.push_back(first_of_photo.back() + photo.pixel.size());
  Sets sets(first_of_photo.back());
  for (const FeatureMatches& match : matches)
    for (const auto& [a, b] : match.pairs)
      sets.join(first_of_photo[match.first] + std::size_t(a),
                first_of_photo[match.second] + std::size_t(b));
  std::vector<FeatureTrack> of_root(first_of_photo.back());
  for (std::size_t photo = 0; photo < photos.size(); ++photo)
    for (std::size_t feature = 0; feature < photos[photo].pixel.size(); ++feature)
      of_root[sets.find(first_of_photo[photo] + feature)].push_back({photo, int(feature)});
  std::erase_if(of_root, [](const FeatureTrack& track) {
    return track.size() < 2 || shows_a_photo_twice(track);
  });
  std::stable_sort(
      of_root.begin(), of_root.end(),
      [](const FeatureTrack& a, const FeatureTrack& b) { return a.size() > b.size(); });
  return of_root;
}

}  // namespace bosk
