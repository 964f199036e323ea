#pragma once

#include "core/radiance/radiance.h"

namespace bosk {

// The volume one level up. A cell lets as much light through as its children do on the mean over
// the three axes, and has their colour, weighted by extinction. The mean of extinctions would be
// too opaque: eight children with gaps between them shade less than a haze of the same mass.
RadianceVolume coarser_volume(const RadianceVolume& volume);

}  // namespace bosk
