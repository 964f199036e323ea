#include "ui/workstation/matte/matte_review.h"

#include <algorithm>

#include "core/image/area_mean.h"
#include "core/matte/live_matte.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

const Matte* find_matte(const Mattes* mattes, const std::string& name) {
  if (!mattes) return nullptr;
  const auto found = std::find_if(mattes->begin(), mattes->end(),
                                  [&](const Matte& matte) { return matte.name == name; });
  return found == mattes->end() ? nullptr : &*found;
}

SmallPhoto small_of(const Photo& photo, const Matte* matte) {
  const int width = photo.srgb.width(), height = photo.srgb.height();
  const double scale = std::min(1.0, double(kSmallPhotoPx) / std::max(width, height));
  const int small_width = std::max(1, int(width * scale));
  const int small_height = std::max(1, int(height * scale));
  SmallPhoto small{photo.name, area_mean_srgb(photo.srgb, small_width, small_height), {}};
  if (matte) small.matte = area_mean_straight(matte->rgba, small_width, small_height);
  return small;
}

// The photos that have a matte, beside their mattes.
void compare(const ImportedPhotos& imported, const Mattes& mattes, const MatteOptions& options,
             MatteReview& review, Progress& progress) {
  Photos photos;
  for (const Matte& matte : mattes) {
    const auto found = std::find_if(imported.photos.begin(), imported.photos.end(),
                                    [&](const Photo& photo) { return photo.name == matte.name; });
    if (found == imported.photos.end()) return;
    photos.push_back(*found);
  }
  for (MatteDoubt& doubt : doubt_mattes(photos, mattes, progress)) {
    const std::string name = doubt.photo;
    review.doubts[name] = std::move(doubt);
  }
  std::vector<Image<float>> tilts = hull_tilts_from(photos, mattes, options, progress);
  for (std::size_t i = 0; i < photos.size(); ++i)
    review.tilts[photos[i].name] = std::move(tilts[i]);
}

MatteReview reviewed(const std::shared_ptr<const ImportedPhotos>& imported,
                     const std::shared_ptr<const Mattes>& mattes, const MatteOptions& options,
                     Progress& progress) {
  MatteReview review;
  review.imported = imported;
  review.mattes = mattes;
  progress.begin("Looking through the mattes", imported->photos.size(), 0.0, 0.5);
  for (const Photo& photo : imported->photos) {
    review.photos.push_back(small_of(photo, find_matte(mattes.get(), photo.name)));
    progress.advance();
  }
  const ProgressPart part(progress, 0.5, 1.0);
  if (mattes) compare(*imported, *mattes, options, review, progress);
  return review;
}

}  // namespace

void follow_mattes(Workspace& workspace) {
  MatteReview& review = workspace.matte.review;
  const auto imported = workspace.results.imported;
  const auto mattes = workspace.results.mattes;
  if (!imported || (review.imported == imported && review.mattes == mattes)) return;
  if (review.job != 0) workspace.jobs.cancel(review.job);
  review.imported = imported;
  review.mattes = mattes;
  review.job = workspace.jobs.start(
      "Looking through the mattes",
      [imported, mattes, options = workspace.project().recipe.matte](Progress& progress) {
        return reviewed(imported, mattes, options, progress);
      },
      [&workspace, revision = review.revision + 1](MatteReview fresh) {
        fresh.revision = revision;
        workspace.matte.review = std::move(fresh);
      });
}

const SmallPhoto* small_photo(const MatteReview& review, const std::string& name) {
  for (const SmallPhoto& photo : review.photos) {
    if (photo.name == name) return &photo;
  }
  return nullptr;
}

Image<float> what_others_say(const MatteReview& review, const std::string& name) {
  const auto found = review.tilts.find(name);
  return found == review.tilts.end() ? Image<float>(1, 1) : found->second;
}

std::vector<std::string> photos_in_order(const MatteReview& review, bool doubt_first) {
  std::vector<std::string> names;
  if (review.imported) {
    for (const Photo& photo : review.imported->photos) names.push_back(photo.name);
  }
  const auto doubt = [&](const std::string& name) {
    const auto found = review.doubts.find(name);
    return found == review.doubts.end() ? -1.0 : found->second.doubt;
  };
  if (doubt_first) {
    std::stable_sort(names.begin(), names.end(),
                     [&](const auto& a, const auto& b) { return doubt(a) > doubt(b); });
  }
  return names;
}

}  // namespace bosk
