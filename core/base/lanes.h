#pragma once

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <cstddef>

namespace bosk {

// Sums that many threads scatter into are kept in this many buffers, each filled in a fixed order
// and merged in a fixed order, so that a result is the same to the bit at every thread count. More
// lanes would let more threads work and cost memory and merging; four keep the overhead near a
// tenth.
inline constexpr std::size_t kLanes = 4;

// Calls body(lane, first, last) for each lane's share of 0 .. count - 1.
template <class Body>
void for_each_lane(std::size_t count, Body&& body) {
  tbb::parallel_for(
      std::size_t(0), kLanes,
      [&](std::size_t lane) { body(lane, count * lane / kLanes, count * (lane + 1) / kLanes); },
      tbb::simple_partitioner{});
}

}  // namespace bosk
