#pragma once

#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

namespace bosk {

// Makes the calling thread give way to the interface thread when cores are short. Where the system
// has no such order, nothing happens.
void yield_to_interface();

// While it lives, oneTBB's workers give way likewise once they have entered the arena, and stay so.
class WorkersYield : public tbb::task_scheduler_observer {
 public:
  explicit WorkersYield(tbb::task_arena& arena) : tbb::task_scheduler_observer(arena) {
    observe(true);
  }
  ~WorkersYield() override { observe(false); }
  WorkersYield(const WorkersYield&) = delete;
  WorkersYield& operator=(const WorkersYield&) = delete;

  void on_scheduler_entry(bool is_worker) override {
    if (is_worker) yield_to_interface();
  }
};

}  // namespace bosk
