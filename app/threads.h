#pragma once

namespace bosk {

// How many threads to use when none were asked for: SLURM_CPUS_PER_TASK, else the container's
// processor quota rounded up, else what the machine has.
int default_threads();

}  // namespace bosk
