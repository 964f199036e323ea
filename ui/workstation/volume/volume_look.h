#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/project/stages.h"
#include "core/radiance/photo_residuals.h"
#include "core/radiance/volume_snapshot.h"
#include "ui/workstation/mailbox.h"

namespace bosk {

// How near a pass came.
struct VolumePass {
  int pass = 0;              // from 1
  double alpha_error = 0.0;  // mean over the photos of their mean |alpha - matte|
  double psnr_db = 0.0;      // of the pass's rays; radiance alone
};

// All that is seen of a volume: a copy, small enough to be drawn while a finer one is worked on.
struct VolumeLook {
  std::string stage;          // opacity or radiance
  int pass = 0, planned = 0;  // 0: finished
  VolumeSnapshot volume;
  std::shared_ptr<const VolumeSnapshot>
      fine;                              // of a finished volume: for pictures that stand still
  std::vector<Camera> cameras;           // of the photos: pinhole, at the working size
  std::vector<PhotoResidual> residuals;  // of the same photos; empty without mattes
  std::vector<VolumePass> passes;        // of the stage's run so far
};

// What a run tells of its volume, and hears: shared by the panel and the run's watchers.
struct VolumeWatch {
  Mailbox<VolumeLook> looks;
  std::atomic<int> told = 0;              // looks so far
  std::atomic<bool> stop_wanted = false;  // end the stage at work after its pass, and keep it
};

// Watchers that put a look into the watch after each pass, and call `wake`.
RunWatchers volume_watchers(const std::shared_ptr<VolumeWatch>& watch,
                            const std::function<void()>& wake);

// A look at a finished volume, in a worker. Mattes may be null; the volume not.
VolumeLook look_at(const OpacityTree& tree, const Photos& views, const Mattes* mattes);
VolumeLook look_at(const RadianceVolume& volume, const Photos& views, const Mattes* mattes);

}  // namespace bosk
