#pragma once

#include <functional>
#include <vector>

namespace bosk {

// Runs every task once on up to `threads` threads, this one included, and returns when all have
// ended. If some threw, throws what the first of them in the list threw. Tasks must not depend on
// each other.
void run_parallel(const std::vector<std::function<void()>>& tasks, unsigned threads);

}  // namespace bosk
