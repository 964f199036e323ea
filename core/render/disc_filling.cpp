#include "core/render/disc_filling.h"

#include <algorithm>
#include <cmath>

namespace bosk {
namespace {

constexpr int kTries = 30;  // places tried around a disc before it is given up (Bridson's k)

// Discs by square of the ground.
class Grid {
 public:
  // `side` of a square: at least the diameter of the largest disc.
  Grid(const glm::dvec2& size, double side)
      : size_(size),
        counts_(glm::clamp(glm::ivec2(glm::min(size / side, 1e6)), 1, kMost)),
        first_(std::size_t(counts_.x) * std::size_t(counts_.y), kNone) {}

  void add(const Disc& disc) {
    std::uint32_t& first = first_[index(square_of(disc.centre))];
    next_.push_back(first);
    first = std::uint32_t(discs_.size());
    discs_.push_back(disc);
  }

  bool has_room_for(const Disc& disc) const {
    const glm::ivec2 square = square_of(disc.centre);
    const glm::ivec2 low = glm::max(square - 1, glm::ivec2(0));
    const glm::ivec2 high = glm::min(square + 1, counts_ - 1);
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        if (!clear_in({x, y}, disc)) return false;
      }
    }
    return true;
  }

  std::vector<Disc>& discs() { return discs_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  static constexpr int kMost = 4096;  // squares a side: fewer and larger ones do as well

  glm::ivec2 square_of(const glm::dvec2& place) const {
    const glm::dvec2 share = place / size_ + 0.5;
    return glm::clamp(glm::ivec2(share * glm::dvec2(counts_)), glm::ivec2(0), counts_ - 1);
  }
  std::size_t index(const glm::ivec2& square) const {
    return std::size_t(square.y) * std::size_t(counts_.x) + std::size_t(square.x);
  }
  bool clear_in(const glm::ivec2& square, const Disc& disc) const {
    for (std::uint32_t i = first_[index(square)]; i != kNone; i = next_[i]) {
      const glm::dvec2 apart = discs_[i].centre - disc.centre;
      const double least = discs_[i].radius + disc.radius;
      if (glm::dot(apart, apart) < least * least) return false;
    }
    return true;
  }

  glm::dvec2 size_;
  glm::ivec2 counts_;
  std::vector<std::uint32_t> first_, next_;  // lists of discs
  std::vector<Disc> discs_;
};

// A place between once and twice `distance` away, by rejection: no call of the maths library whose
// last bit differs between machines.
glm::dvec2 place_around(const glm::dvec2& centre, double distance, Random& random) {
  while (true) {
    const glm::dvec2 step(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0));
    const double square = glm::dot(step, step);
    if (square >= 1.0 && square <= 4.0) return centre + distance * step;
  }
}

bool is_inside(const glm::dvec2& place, const glm::dvec2& size) {
  return std::abs(place.x) <= 0.5 * size.x && std::abs(place.y) <= 0.5 * size.y;
}

}  // namespace

std::vector<Disc> fill_with_discs(const glm::dvec2& size, const DiscSource& source,
                                  double largest_radius, std::size_t most, Random& random) {
  // Begin in the middle
  Grid grid(size, 2.0 * largest_radius);
  std::vector<std::uint32_t> open = {0};
  grid.add(source(random));

  // Try places around an open disc; close it when none is free
  while (!open.empty() && grid.discs().size() < most) {
    std::uint32_t& chosen = open[random.below(open.size())];
    const Disc parent = grid.discs()[chosen];
    bool found = false;
    for (int i = 0; i < kTries && !found; ++i) {
      Disc disc = source(random);
      disc.centre = place_around(parent.centre, parent.radius + disc.radius, random);
      found = is_inside(disc.centre, size) && grid.has_room_for(disc);
      if (found) {
        open.push_back(std::uint32_t(grid.discs().size()));
        grid.add(disc);
      }
    }
    if (!found) {
      chosen = open.back();
      open.pop_back();
    }
  }
  return std::move(grid.discs());
}

}  // namespace bosk
