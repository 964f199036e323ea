#pragma once

#include <algorithm>
#include <map>

#include "core/calibrate/bundle.h"
#include "orbit.h"

namespace bosk {

// An orbit as a bundle, the state being the truth and the lens known.
struct OrbitBundle {
  BundleProblem problem;
  BundleState state;
};

inline OrbitBundle orbit_bundle(const Orbit& orbit) {
  OrbitBundle bundle;
  bundle.problem.family = family_of(orbit.lens);
  bundle.state.intrinsics = mrcal_intrinsics(orbit.lens, bundle.problem.family);
  bundle.problem.lens.mean = bundle.state.intrinsics;
  bundle.problem.lens.sigma.assign(bundle.state.intrinsics.size(), 100.0);
  bundle.problem.lens_free.assign(bundle.state.intrinsics.size(), false);
  std::map<std::string, int> index;
  for (const std::string& name : orbit.names) index.emplace(name, int(index.size()));
  bundle.state.points.resize(index.size());
  for (std::size_t i = 0; i < orbit.names.size(); ++i)
    bundle.state.points[std::size_t(index[orbit.names[i]])] = orbit.points[i];
  for (std::size_t i = 0; i < orbit.photos.size(); ++i) {
    bundle.state.camera_from_world.push_back(orbit.cameras[i].camera_from_world);
    for (const Sighting& sighting : orbit.photos[i].sightings)
      bundle.problem.sightings.push_back(
          {int(i), index.at(sighting.point), sighting.pixel, sighting.sigma_px, true});
  }
  return bundle;
}

}  // namespace bosk
