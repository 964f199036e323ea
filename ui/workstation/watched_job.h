#pragma once

#include "ui/workstation/jobs.h"

namespace bosk {

// A job whose result somebody waits for. `install` sets `id` back to 0; a job that ended without
// that was stopped, or failed.
struct WatchedJob {
  int id = 0;

  bool is_at_work() const { return id != 0; }
};

// Whether the job ended without a result; it is then watched no longer.
inline bool was_stopped(WatchedJob& job, const Jobs& jobs) {
  if (job.id == 0 || jobs.is_open(job.id)) return false;
  job = {};
  return true;
}

}  // namespace bosk
