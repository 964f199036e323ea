#include "ui/workstation/volume/volume_look.h"

namespace bosk {
namespace {

constexpr int kLevel = 7;      // of what is seen: 4 MB and 50 ms a picture for the oak
constexpr int kFineLevel = 8;  // 24 MB and 90 ms

// What stays the same over the passes of one stage.
struct StageWatch {
  std::vector<SmallMatte> mattes;
  std::vector<VolumePass> passes;
};

std::vector<Camera> cameras_of(const Photos& views) {
  std::vector<Camera> cameras;
  for (const Photo& view : views) cameras.push_back(view.camera);
  return cameras;
}

double mean_error(const std::vector<PhotoResidual>& residuals) {
  double sum = 0.0;
  for (const PhotoResidual& residual : residuals) sum += residual.alpha_error;
  return residuals.empty() ? 0.0 : sum / double(residuals.size());
}

template <class Volume>
VolumeLook look(const std::string& stage, const Volume& volume, const Photos& views,
                const std::vector<SmallMatte>& mattes) {
  VolumeLook seen;
  seen.stage = stage;
  seen.volume = snapshot_of(volume, kLevel);
  seen.cameras = cameras_of(views);
  seen.residuals = photo_residuals(seen.volume, mattes);
  return seen;
}

template <class Volume>
VolumeLook finished_look(const std::string& stage, const Volume& volume, const Photos& views,
                         const Mattes* mattes) {
  const bool belong = mattes && mattes->size() == views.size();
  VolumeLook seen =
      look(stage, volume, views, belong ? small_mattes(views, *mattes) : std::vector<SmallMatte>());
  seen.fine = std::make_shared<const VolumeSnapshot>(snapshot_of(volume, kFineLevel));
  return seen;
}

// Puts a look at one pass into the watch; whether to go on.
template <class Volume>
bool tell(VolumeWatch& watch, StageWatch& stage_watch, const std::string& stage,
          const Volume& volume, const Photos& photos, const Mattes& mattes, VolumePass pass,
          int planned) {
  if (stage_watch.mattes.empty()) stage_watch.mattes = small_mattes(photos, mattes);
  VolumeLook seen = look(stage, volume, photos, stage_watch.mattes);
  seen.pass = pass.pass;
  seen.planned = planned;
  pass.alpha_error = mean_error(seen.residuals);
  stage_watch.passes.push_back(pass);
  seen.passes = stage_watch.passes;
  watch.looks.put(std::move(seen));
  ++watch.told;
  return !watch.stop_wanted.exchange(false);
}

}  // namespace

RunWatchers volume_watchers(const std::shared_ptr<VolumeWatch>& watch,
                            const std::function<void()>& wake) {
  RunWatchers watchers;
  watchers.opacity = [=, of_stage = std::make_shared<StageWatch>()](const OpacityPreview& at) {
    const bool go_on = tell(*watch, *of_stage, "opacity", at.tree, at.photos, at.mattes,
                            {at.iteration, 0.0, 0.0}, at.planned);
    wake();
    return go_on;
  };
  watchers.radiance = [=, of_stage = std::make_shared<StageWatch>()](const RadiancePreview& at) {
    const bool go_on = tell(*watch, *of_stage, "radiance", at.volume, at.photos, at.mattes,
                            {at.epoch, 0.0, at.psnr_db}, at.planned);
    wake();
    return go_on;
  };
  return watchers;
}

VolumeLook look_at(const OpacityTree& tree, const Photos& views, const Mattes* mattes) {
  return finished_look("opacity", tree, views, mattes);
}

VolumeLook look_at(const RadianceVolume& volume, const Photos& views, const Mattes* mattes) {
  return finished_look("radiance", volume, views, mattes);
}

}  // namespace bosk
