#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/matte/matte.h"
#include "core/photo/camera.h"

namespace bosk {

// One photo's silhouette: how many pixels of any rectangle have alpha above a threshold, in
// constant time (summed-area table), seen through a pinhole camera.
class Silhouette {
 public:
  Silhouette(const Camera& pinhole, const Image<glm::vec4>& matte, float alpha_threshold);

  enum class Verdict { unseen, empty, occupied };
  // What the photo says of the cube: `unseen` when it lies behind the camera or reaches out of the
  // frame, `empty` when no pixel of its conservative footprint (bounding rectangle of the projected
  // corners, grown to whole pixels) is above the threshold.
  Verdict look_at(const glm::dvec3& lower_in_world, double edge_m) const;

  // Pixels x0 .. x1 - 1, y0 .. y1 - 1.
  struct Rectangle {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  };
  // The cube's conservative footprint, which may reach out of the frame; none behind the camera.
  std::optional<Rectangle> footprint(const glm::dvec3& lower_in_world, double edge_m) const;
  // How many pixels of a rectangle inside the frame are above the threshold.
  std::uint32_t count(const Rectangle& r) const {
    return sums_(r.x1, r.y1) - sums_(r.x0, r.y1) - sums_(r.x1, r.y0) + sums_(r.x0, r.y0);
  }
  int width() const { return sums_.width() - 1; }
  int height() const { return sums_.height() - 1; }

  std::uint32_t pixels_above() const { return sums_(sums_.width() - 1, sums_.height() - 1); }
  const Camera& camera() const { return camera_; }

 private:
  // The verdict where a circle around the cube decides it: most of the time, at an eighth of the
  // cost. Else none.
  std::optional<Verdict> glance_at(const glm::dvec3& lower_in_world, double edge_m) const;
  bool holds(const Rectangle& r) const {
    return r.x0 >= 0 && r.y0 >= 0 && r.x1 <= width() && r.y1 <= height();
  }

  Camera camera_;
  Image<std::uint32_t> sums_;  // (width + 1) x (height + 1)
};

// A cube of the world and its octree's cells.
struct Cube {
  glm::dvec3 origin{0.0};
  double size_m = 1.0;
};

// Cells of 2^level a side that the hull keeps: no photo sees them empty, and at least
// max(2, 3/4 of the photos) see them whole. Where that explains over 3 % less of the silhouettes
// than a third of the photos would, half or a third are enough: frames cut the tree off. A cell
// that reaches out of many frames is else more likely a ghost between silhouettes than a piece of
// the tree. Exact with respect to the cells' footprints: a cell is dropped only when the matte is
// clear all over its footprint in some photo.
std::vector<glm::ivec3> carve_hull(const std::vector<Silhouette>& silhouettes, const Cube& cube,
                                   int level, Progress& progress);

// The children, at `level`, of the given cells that no photo sees empty.
std::vector<glm::ivec3> carve_children(const std::vector<Silhouette>& silhouettes, const Cube& cube,
                                       const std::vector<glm::ivec3>& parents, int level,
                                       Progress& progress);

// The cube around everything the mattes agree on, found by carving a large cube around the point
// nearest to all optical axes and tightening it. Throws Error when nothing is left: the photos show
// no common volume, or the cameras don't belong to the mattes.
Cube find_crown(const std::vector<Silhouette>& silhouettes, Progress& progress);

}  // namespace bosk
