#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/binary.h"
#include "core/base/options.h"
#include "core/base/progress.h"
#include "core/matte/matte.h"
#include "core/opacity/opacity.h"
#include "core/photo/photo.h"

namespace bosk {

struct RadianceOptions {
  int degree = 0;            // of the spherical harmonics of colour: 0, 1 or 2
  int finer_levels = 1;      // octree levels below opacity's finest
  double max_samples = 0.0;  // million, of the photos' rays in opacity's cells: photos are averaged
                             // over blocks of pixels until they have no more; 0: any number
  int epochs = 2;            // passes over all pixels at the finest level
  int last_epochs = 1;       // and after faint cells are dropped
  int coarse_epochs = 3;     // passes at each coarser level, over averaged pixels
  int subsets = 48;          // updates per pass
  double extinction_rate = 0.1;    // first step of an update, relative to clamp(extinction, 0.3, 3)
  double colour_rate = 0.06;       // first step of an update of colour
  double colour_variation = 0.05;  // weight of the total variation of colour, per ray
  double extinction_variation = 0.003;  // and of extinction
  double faintest = 0.02;  // extinction per cell edge below which a finished cell is dropped
  int stop_after = 0;      // epochs, counted over all levels; 0: never
};
Options describe(RadianceOptions& options);

// The fine sparse volume: extinction and view-dependent colour at the centre of each cell,
// trilinear between centres.
struct RadianceVolume {
  glm::dvec3 origin{0.0};
  double size_m = 1.0;
  SparseGrid grid;
  int degree = 1;
  std::vector<float> extinction;  // per cell edge, as OpacityTree's
  // Straight sRGB-encoded colour as spherical harmonics of the direction from the eye to the cell:
  // [cell][coefficient][r, g, b], (degree + 1)^2 coefficients.
  std::vector<float> colour;

  int coefficients() const { return (degree + 1) * (degree + 1); }
  double cell_m() const { return size_m / grid.side(); }
};

// The state after an epoch, for whoever watches. Valid during the call only.
struct RadiancePreview {
  const RadianceVolume& volume;
  int epoch = 0;         // from 1, over all levels
  int planned = 0;       // epochs in all
  double psnr_db = 0.0;  // of the rays of the epoch, premultiplied colour and alpha
  const Photos& photos;  // that it is made from
  const Mattes& mattes;
};
// Returns whether to go on. On false the volume is what refine_radiance gives with `stop_after` at
// this epoch: that of the level reached, without its faint cells.
using RadianceWatcher = std::function<bool(const RadiancePreview&)>;

// Refines opacity and colour together so that the volume, composited along each pixel's ray, gives
// the matted photos. Throws Error when photos carry no pixels.
RadianceVolume refine_radiance(const Photos& photos, const Mattes& mattes,
                               const OpacityTree& opacity, const RadianceOptions& options,
                               Progress& progress, const RadianceWatcher& watcher = {});

// The volume with the given cells alone; `kept` are cell numbers, ascending.
RadianceVolume subset(const RadianceVolume& volume, const std::vector<std::uint32_t>& kept,
                      const Progress& progress);

void write(BinaryWriter& writer, const RadianceVolume& volume);
RadianceVolume read_radiance_volume(BinaryReader& reader);

}  // namespace bosk
